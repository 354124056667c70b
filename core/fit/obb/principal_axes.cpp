#include "fit/obb/principal_axes.hpp"
#include "number/power_of_two.hpp"

#include <utility>

namespace snug::fit {
namespace {

/// A covariance and the axes that it is expressed in, rotated until only its diagonal is left.
/// Source: C. Ericson, Real-Time Collision Detection, 2005, 4.3.3; G. H. Golub, C. F. Van Loan, Matrix Computations,
/// 1996, 8.4: Jacobi's method, cyclic by row.
template <class Scalar, int Dim>
struct Jacobi {
  Matrix<Scalar, Dim> a;
  Matrix<Scalar, Dim> axes = Matrix<Scalar, Dim>::Identity();

  void diagonalise() {
    constexpr int kSweeps = 16;  // five are the most that it was ever seen to take; the bound guards against rounding
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      bool turned = false;
      for (int p = 0; p < Dim; ++p)
        for (int q = p + 1; q < Dim; ++q) turned = turn(p, q) || turned;
      if (!turned) return;
    }
  }

 private:
  /// Rotates axes p and q so that a(p, q) becomes 0. Returns false if it is already 0 within rounding, relative to its
  /// own two variances: so the small variances of a thin set count as much as the large ones.
  bool turn(int p, int q) {
    constexpr Scalar kNone = tolerance::kRoundoff<Scalar> * tolerance::kRoundoff<Scalar>;
    const Scalar beside = a(p, q);
    if (beside * beside <= kNone * std::abs(a(p, p) * a(q, q))) return false;
    const Scalar ratio = (a(q, q) - a(p, p)) / (2 * beside);
    const Scalar tangent = std::copysign(1 / (std::abs(ratio) + std::sqrt(ratio * ratio + 1)), ratio);
    const Scalar cosine = 1 / std::sqrt(tangent * tangent + 1), sine = tangent * cosine,
                 half_tangent = sine / (1 + cosine);
    a(p, p) -= tangent * beside;
    a(q, q) += tangent * beside;
    a(p, q) = a(q, p) = 0;
    const auto mix = [&](Scalar& x, Scalar& y) {  // cosine x - sine y and sine x + cosine y, as small changes
      const Scalar old = x;
      x -= sine * (y + half_tangent * old);
      y += sine * (old - half_tangent * y);
    };
    for (int r = 0; r < Dim; ++r) {
      mix(axes(r, p), axes(r, q));
      if (r == p || r == q) continue;
      mix(a(r, p), a(r, q));
      a(p, r) = a(r, p);
      a(q, r) = a(r, q);
    }
    return true;
  }
};

}  // namespace

// Only the four operations and square roots: the same bits everywhere.
template <class Scalar, int Dim>
AxesFound<Scalar, Dim> principal_axes(const CovarianceFound<Scalar, Dim>& spread) {
  const Scalar largest = spread.covariance.cwiseAbs().maxCoeff();
  const int exponent = exponent_of(largest);  // squares of numbers near 1 do not underflow
  Jacobi<Scalar, Dim> jacobi{spread.covariance.unaryExpr([&](Scalar x) { return std::ldexp(x, -exponent); })};
  jacobi.diagonalise();

  AxesFound<Scalar, Dim> found{spread.mean, jacobi.axes, jacobi.a.diagonal()};
  for (int i = 0; i < Dim; ++i) {
    for (int j = i; j > 0 && found.variances[j] < found.variances[j - 1]; --j) {  // by rising variance
      std::swap(found.variances[j], found.variances[j - 1]);
      found.axes.col(j).swap(found.axes.col(j - 1));
    }
  }
  for (int i = 0; i < Dim; ++i) {
    int largest_at = 0;
    found.axes.col(i).cwiseAbs().maxCoeff(&largest_at);
    if (found.axes(largest_at, i) < 0) found.axes.col(i) *= -1;
    found.variances[i] = std::ldexp(found.variances[i], exponent);
  }
  return found;
}

template AxesFound<float, 2> principal_axes(const CovarianceFound<float, 2>&);
template AxesFound<float, 3> principal_axes(const CovarianceFound<float, 3>&);
template AxesFound<double, 2> principal_axes(const CovarianceFound<double, 2>&);
template AxesFound<double, 3> principal_axes(const CovarianceFound<double, 3>&);

}  // namespace snug::fit
