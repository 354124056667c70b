#include "fit/obb/principal_axes.hpp"

using namespace snug;

namespace {

/// The covariance A A^T. thinning: how much shorter each axis of A is than the one before it.
template <class Scalar, int Dim>
Matrix<Scalar, Dim> covariance(Random& random, double thinning) {
  Eigen::Matrix<double, Dim, Dim> a;
  for (int row = 0; row < Dim; ++row)
    for (int column = 0; column < Dim; ++column) a(row, column) = random.between(-1, 1) * std::pow(thinning, column);
  const Eigen::Matrix<double, Dim, Dim> products = a * a.transpose();
  return products.template cast<Scalar>();
}

template <class Scalar, int Dim>
void check_axes(const Matrix<Scalar, Dim>& spread) {
  using Exact = Eigen::Matrix<double, Dim, Dim>;
  const auto found = fit::principal_axes(fit::CovarianceFound<Scalar, Dim>{Vector<Scalar, Dim>::Zero(), spread});
  const Exact axes = found.axes.template cast<double>(), given = spread.template cast<double>();
  const double roundoff = static_cast<double>(tolerance::kRoundoff<Scalar>);
  CHECK((axes.transpose() * axes - Exact::Identity()).cwiseAbs().maxCoeff() <= 12 * roundoff);
  const Exact left = given * axes - axes * found.variances.template cast<double>().asDiagonal();
  CHECK(left.cwiseAbs().maxCoeff() <= 32 * roundoff * given.cwiseAbs().maxCoeff());
  for (int i = 0; i < Dim; ++i) {
    if (i > 0) CHECK(found.variances[i - 1] <= found.variances[i]);
    int largest = 0;
    found.axes.col(i).cwiseAbs().maxCoeff(&largest);
    CHECK(found.axes(largest, i) > 0);
  }
}

}  // namespace

TEST_CASE_TEMPLATE("principal axes are perpendicular units that leave nothing beside the diagonal", Scalar, float,
                   double) {
  Random random(3);
  for (int turn = 0; turn < 500; ++turn)
    for (const double thinning : {1.0, 1e-3, 1e-9}) {
      check_axes<Scalar, 2>(covariance<Scalar, 2>(random, thinning));
      check_axes<Scalar, 3>(covariance<Scalar, 3>(random, thinning));
    }
  check_axes<Scalar, 3>(Matrix<Scalar, 3>::Zero());
  check_axes<Scalar, 3>(Matrix<Scalar, 3>::Constant(1));
  check_axes<Scalar, 3>(Matrix<Scalar, 3>::Constant(std::numeric_limits<Scalar>::max() / 4));
}

TEST_CASE_TEMPLATE("axes that a covariance is given in stay as they are", Scalar, float, double) {
  Matrix<Scalar, 3> spread = Matrix<Scalar, 3>::Zero();
  spread.diagonal() << 2, 3, 1;
  const auto found = fit::principal_axes(fit::CovarianceFound<Scalar, 3>{Vector<Scalar, 3>::Zero(), spread});
  CHECK(found.axes == Matrix<Scalar, 3>{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}});
  CHECK(found.variances == Vector<Scalar, 3>{1, 2, 3});
}

TEST_CASE_TEMPLATE("the thin directions of a flat set have axes as good as its long one", Scalar, float, double) {
  // Turned by 30 degrees about x, which is 1e4 (float) or 1e8 (double) times as long as the others.
  const Scalar thin = std::is_same_v<Scalar, float> ? Scalar(1e-8) : Scalar(1e-16);
  const Scalar cosine = std::sqrt(Scalar(3)) / 2, sine = Scalar(1) / 2;
  Matrix<Scalar, 3> spread = Matrix<Scalar, 3>::Zero();
  spread(0, 0) = 1;
  spread(1, 1) = thin * (cosine * cosine + 4 * sine * sine);
  spread(2, 2) = thin * (sine * sine + 4 * cosine * cosine);
  spread(1, 2) = spread(2, 1) = thin * (1 - 4) * cosine * sine;
  const auto found = fit::principal_axes(fit::CovarianceFound<Scalar, 3>{Vector<Scalar, 3>::Zero(), spread});
  CHECK(std::abs(found.axes(1, 0) - cosine) <= 16 * tolerance::kRoundoff<Scalar>);
  CHECK(std::abs(found.axes(2, 0) - sine) <= 16 * tolerance::kRoundoff<Scalar>);
}
