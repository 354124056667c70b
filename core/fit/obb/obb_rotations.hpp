// The best oriented box among fixed rotations, the same for all points.
// Source: M. Alexa, "Super-Fibonacci spirals: fast, low-discrepancy sampling of SO(3)", 2022, for the rotations; libigl
// 2.6 (2025) fits its boxes so.
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "fit/obb/obb_hull.hpp"
#include "fit/obb/obb_trials.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 6> kObbRotationsPseudocode{
    "hull ← convex hull of the points",
    "for the world's axes, and 1000 fixed rotations (in 2-D: 89)",
    "  box ← the hull's extents along these axes",
    "  if box is smaller than best: keep it",
    "extents ← least and greatest along each",
    "return box",
};

template <int Dim>
inline constexpr Index kRotations = Dim == 2 ? 89 : 1000;

/// Turns by one angle over and over. Sums and products round alike everywhere, which sines and cosines do not.
class Turning {
 public:
  Turning(double cosine, double sine) : by_(cosine, sine) {}
  /// The cosine and sine of the angle so far, which begins at 0.
  [[nodiscard]] const Vector<double, 2>& at() const { return at_; }
  void go_on() {
    at_ = Vector<double, 2>(at_[0] * by_[0] - at_[1] * by_[1], at_[0] * by_[1] + at_[1] * by_[0]);
    at_ /= std::sqrt(at_[0] * at_[0] + at_[1] * at_[1]);
  }

 private:
  Vector<double, 2> by_, at_{1, 0};
};

/// The axes of rotations that lie about as far from each other as so many can, one after the other. In the plane they
/// are whole degrees below 90, and in space a spiral on the unit quaternions.
template <int Dim>
class FixedRotations;

template <>
class FixedRotations<2> {
 public:
  Matrix<double, 2> next() {
    turning_.go_on();
    return frame(turning_.at());
  }

 private:
  Turning turning_{0.99984769515639124, 0.017452406437283512};  // 1 degree
};

template <>
class FixedRotations<3> {
 public:
  Matrix<double, 3> next() {
    const double share = (at_++ + 0.5) / kRotations<3>;
    const Vector<double, 2> a = std::sqrt(share) * inner_.at(), b = std::sqrt(1 - share) * outer_.at();
    inner_.go_on();
    outer_.go_on();
    return Eigen::Quaterniond(b[0], a[1], a[0], b[1]).toRotationMatrix();
  }

 private:
  // A whole turn over the square root of 2, and over the positive root of x^4 = x + 4.
  Turning inner_{-0.26625534204141565, -0.9639025328498773}, outer_{-0.5775919727874612, -0.816325617000648};
  int at_ = 0;
};

/// Tries the box along the world's axes, and along each of the fixed rotations. It is never larger than the AABB, but
/// no other bound holds: a thin stick between two rotations gets a box many times too large. In the plane no direction
/// is more than half a degree from one that is tried; in space no rotation more than 11 degrees.
/// points: n >= 1 finite points, scene units. Expected O(n log n) time for the hull, and O(h) more for each rotation of
/// a hull with h vertices.
template <class Scalar, int Dim, StepObserver<ObbStep<Scalar, Dim>> Observer = Ignore>
Fit<Obb<Scalar, Dim>> obb_rotations(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  const ConvexHull<Scalar, Dim> hull = watched_hull(points, 0, observe);
  ObbTrials<Scalar, Dim, std::remove_reference_t<Observer>> trials(hull.vertices, observe);
  Index number = 0, told = -1;
  const auto attempt = [&](const Matrix<double, Dim>& axes) {
    trials.attempt_and_tell(axes, [&](const Obb<Scalar, Dim>& box, bool better) {
      if (!better) return;
      observe(ObbStep<Scalar, Dim>{
          3, true, box, RotationTried<Scalar, Dim>{number, number - told - 1, kRotations<Dim>, box, measure(box)}});
      told = number;
    });
    ++number;
  };
  attempt(Matrix<double, Dim>::Identity());
  for (FixedRotations<Dim> rotations; number <= kRotations<Dim>;) attempt(rotations.next());
  return finish_on_hull<Scalar, Dim>(trials.scalar_axes(), hull, 4, observe);
}

}  // namespace snug::fit
