#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "fit/merge.hpp"
#include "fit/merge_order.hpp"
#include "fit/obb_frame.hpp"
#include "fit/principal_axes.hpp"
#include "geometry/tolerance.hpp"

namespace snug::fit {
namespace {

/// A box as the meeting of its slabs, seen along any direction. With A its axes as columns, a point of it is its centre plus
/// A^-T s, |s_i| <= h_i, so that along m it reaches sum h_i |(A^-1 m)_i| from its centre, whether or not A is quite a
/// rotation.
template <int Dim>
class BoxAlong {
 public:
  template <class Scalar>
  explicit BoxAlong(const Obb<Scalar, Dim>& box)
      : center_(box.center.template cast<double>()), half_(box.half_extents.template cast<double>()),
        inverse_(box.axes.template cast<double>().inverse()) {}

  /// From a point, the least and the greatest along a unit direction, rounded.
  [[nodiscard]] std::array<double, 2> extent(const Vector<double, Dim>& direction, const Vector<double, Dim>& from) const {
    const double middle = (center_ - from).dot(direction);
    const double reach = half_.dot(Vector<double, Dim>(inverse_ * direction).cwiseAbs());
    return {middle - reach, middle + reach};
  }
  /// How far from the point it reaches to either side, and certainly no farther.
  [[nodiscard]] double reach_at_most(const Vector<double, Dim>& direction, const Vector<double, Dim>& from) const {
    const auto [low, high] = extent(direction, from);
    const double size = half_.sum() + (center_ - from).cwiseAbs().sum();
    return std::max(-low, high) + (tolerance::kMergedBox * size + 16 * std::numeric_limits<double>::denorm_min());
  }
  [[nodiscard]] const Vector<double, Dim>& center() const { return center_; }

 private:
  Vector<double, Dim> center_, half_;
  Matrix<double, Dim> inverse_;
};

template <class Scalar, int Dim>
bool holds(const Obb<Scalar, Dim>& outer, const BoxAlong<Dim>& inner) {
  const Vector<double, Dim> center = outer.center.template cast<double>();
  for (int i = 0; i < Dim; ++i)
    if (inner.reach_at_most(outer.axes.col(i).template cast<double>(), center) > static_cast<double>(outer.half_extents[i]))
      return false;
  return true;
}

template <class Scalar, int Dim>
Obb<Scalar, Dim> box_along(const Matrix<Scalar, Dim>& axes, const BoxAlong<Dim>& a, const BoxAlong<Dim>& b) {
  Obb<Scalar, Dim> merged{{}, axes, {}};
  Vector<double, Dim> middle = Vector<double, Dim>::Zero();
  for (int i = 0; i < Dim; ++i) {
    const Vector<double, Dim> axis = axes.col(i).template cast<double>();
    const auto of_a = a.extent(axis, a.center()), of_b = b.extent(axis, a.center());
    const double low = std::min(of_a[0], of_b[0]), high = std::max(of_a[1], of_b[1]);
    middle += (low + (high - low) / 2) * axis;
  }
  merged.center = (a.center() + middle).template cast<Scalar>();
  const Vector<double, Dim> center = merged.center.template cast<double>();
  for (int i = 0; i < Dim; ++i) {
    const Vector<double, Dim> axis = axes.col(i).template cast<double>();
    const double reach = std::max(a.reach_at_most(axis, center), b.reach_at_most(axis, center));
    auto half = static_cast<Scalar>(reach);
    if (static_cast<double>(half) < reach) half = std::nextafter(half, std::numeric_limits<Scalar>::max());
    merged.half_extents[i] = half;
  }
  return merged;
}

/// Of all corners, about their mean and scaled so that no square overflows.
template <class Scalar, int Dim>
Matrix<Scalar, Dim> axes_of_corners(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b) {
  std::vector<Vector<double, Dim>> corners;
  const Vector<double, Dim> origin = a.center.template cast<double>();
  double largest = 0;
  for (const auto* box : {&a, &b})
    for (int corner = 0; corner < 1 << Dim; ++corner) {
      auto& place = corners.emplace_back(box->center.template cast<double>() - origin);
      for (int i = 0; i < Dim; ++i) {
        const Vector<double, Dim> arm = box->axes.col(i).template cast<double>() * static_cast<double>(box->half_extents[i]);
        place += (corner >> i & 1) == 0 ? -arm : arm;
      }
      largest = std::max(largest, place.cwiseAbs().maxCoeff());
    }
  if (largest > 0)
    for (auto& place : corners) place *= std::ldexp(1.0, -std::clamp(std::ilogb(largest), -1000, 1000));
  const auto set = *PointSet<double, Dim>::make(std::move(corners));  // of about unit size: never refused
  Ignore ignore;
  const auto mean = mean_of(set.span(), ignore);
  const auto found = principal_axes(covariance_of(mean.mean, set.span(), ignore), set.span(), ignore);
  if constexpr (Dim == 2) return frame(Vector<double, 2>(found.axes.col(1))).template cast<Scalar>();
  else return frame(found.axes.col(2), found.axes.col(1)).template cast<Scalar>();
}

}  // namespace

template <class Scalar, int Dim>
Obb<Scalar, Dim> merge(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b) {
  const int order = order_of(a, b);
  if (order == 0) return a;
  if (order > 0) return merge(b, a);
  const BoxAlong<Dim> seen_a(a), seen_b(b);
  if (holds(a, seen_b)) return a;
  if (holds(b, seen_a)) return b;
  Obb<Scalar, Dim> least = box_along<Scalar, Dim>(a.axes, seen_a, seen_b);
  for (const Matrix<Scalar, Dim>& axes : {b.axes, axes_of_corners(a, b)}) {
    const Obb<Scalar, Dim> merged = box_along<Scalar, Dim>(axes, seen_a, seen_b);
    if (measure(merged) < measure(least)) least = merged;
  }
  return least;
}

template Obb<float, 2> merge(const Obb<float, 2>&, const Obb<float, 2>&);
template Obb<float, 3> merge(const Obb<float, 3>&, const Obb<float, 3>&);
template Obb<double, 2> merge(const Obb<double, 2>&, const Obb<double, 2>&);
template Obb<double, 3> merge(const Obb<double, 3>&, const Obb<double, 3>&);

}  // namespace snug::fit
