#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "fit/merge/merge.hpp"
#include "fit/merge/merge_order.hpp"
#include "fit/obb/obb_frame.hpp"
#include "fit/obb/principal_axes.hpp"
#include "geometry/tolerance.hpp"
#include "number/power_of_two.hpp"

namespace snug::fit {
namespace {

/// How a box's numbers are read. With its axes as A's columns, the intersection of its slabs is its centre plus A^-T s,
/// |s_i| <= h_i; the span of its edges is its centre plus A s. The two differ if A is not quite a rotation.
enum class Read : std::uint8_t { kSlabs, kEdges };

/// Projects a box onto any direction, read either way.
template <int Dim>
class BoxAlong {
 public:
  template <class Scalar>
  explicit BoxAlong(const Obb<Scalar, Dim>& box)
      : center_(box.center.template cast<double>()), half_(box.half_extents.template cast<double>()),
        edges_(box.axes.template cast<double>().transpose()), slabs_(box.axes.template cast<double>().inverse()) {}

  /// The least and the greatest projection, from a point, onto a direction of about unit length; rounded.
  [[nodiscard]] std::array<double, 2> extent(const Vector<double, Dim>& direction, const Vector<double, Dim>& from,
                                             Read read) const {
    const double middle = (center_ - from).dot(direction);
    const double reach =
        half_.dot(Vector<double, Dim>((read == Read::kSlabs ? slabs_ : edges_) * direction).cwiseAbs());
    return {middle - reach, middle + reach};
  }
  /// An upper bound on how far it reaches from the point, to either side.
  [[nodiscard]] double reach_at_most(const Vector<double, Dim>& direction, const Vector<double, Dim>& from,
                                     Read read) const {
    const auto [low, high] = extent(direction, from, read);
    const double size = half_.sum() + (center_ - from).cwiseAbs().sum();
    return std::max(-low, high) + (tolerance::kMergedBox * size + 16 * std::numeric_limits<double>::denorm_min());
  }
  [[nodiscard]] const Vector<double, Dim>& center() const { return center_; }

 private:
  Vector<double, Dim> center_, half_;
  Matrix<double, Dim> edges_, slabs_;  // what a direction is multiplied by
};

/// Half extents with which a box of these axes and this centre certainly contains the other, whether both are
/// read as slabs or both as edges. Slabs are judged along the axes, edges along the rows of the axes'
/// inverse.
template <class Scalar, int Dim>
Vector<double, Dim> half_extents_around(const Vector<Scalar, Dim>& center, const Matrix<Scalar, Dim>& axes,
                                        const BoxAlong<Dim>& inner) {
  const Vector<double, Dim> from = center.template cast<double>();
  const Matrix<double, Dim> columns = axes.template cast<double>();
  const Matrix<double, Dim> inverse = columns.inverse();
  Vector<double, Dim> half;
  for (int i = 0; i < Dim; ++i)
    half[i] = std::max(inner.reach_at_most(columns.col(i), from, Read::kSlabs),
                       inner.reach_at_most(inverse.row(i).transpose(), from, Read::kEdges));
  return half;
}

template <class Scalar, int Dim>
bool holds(const Obb<Scalar, Dim>& outer, const BoxAlong<Dim>& inner) {
  const Vector<double, Dim> needed = half_extents_around<Scalar, Dim>(outer.center, outer.axes, inner);
  return (needed.array() <= outer.half_extents.template cast<double>().array()).all();
}

template <class Scalar, int Dim>
Obb<Scalar, Dim> box_along(const Matrix<Scalar, Dim>& axes, const BoxAlong<Dim>& a, const BoxAlong<Dim>& b) {
  Obb<Scalar, Dim> merged{{}, axes, {}};
  Vector<double, Dim> middle = Vector<double, Dim>::Zero();
  for (int i = 0; i < Dim; ++i) {
    const Vector<double, Dim> axis = axes.col(i).template cast<double>();
    const auto of_a = a.extent(axis, a.center(), Read::kSlabs), of_b = b.extent(axis, a.center(), Read::kSlabs);
    const double low = std::min(of_a[0], of_b[0]), high = std::max(of_a[1], of_b[1]);
    middle += (low + (high - low) / 2) * axis;
  }
  merged.center = (a.center() + middle).template cast<Scalar>();
  const Vector<double, Dim> needed = half_extents_around<Scalar, Dim>(merged.center, axes, a)
                                         .cwiseMax(half_extents_around<Scalar, Dim>(merged.center, axes, b));
  for (int i = 0; i < Dim; ++i) {
    auto half = static_cast<Scalar>(needed[i]);
    if (static_cast<double>(half) < needed[i]) half = std::nextafter(half, std::numeric_limits<Scalar>::max());
    merged.half_extents[i] = half;
  }
  return merged;
}

/// The principal axes of all vertices, about their mean and scaled so that no square overflows.
template <class Scalar, int Dim>
Matrix<Scalar, Dim> axes_of_corners(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b) {
  std::vector<Vector<double, Dim>> corners;
  const Vector<double, Dim> origin = a.center.template cast<double>();
  double largest = 0;
  for (const auto* box : {&a, &b})
    for (int corner = 0; corner < 1 << Dim; ++corner) {
      auto& place = corners.emplace_back(box->center.template cast<double>() - origin);
      for (int i = 0; i < Dim; ++i) {
        const Vector<double, Dim> arm =
            box->axes.col(i).template cast<double>() * static_cast<double>(box->half_extents[i]);
        place += (corner >> i & 1) == 0 ? -arm : arm;
      }
      largest = std::max(largest, place.cwiseAbs().maxCoeff());
    }
  for (auto& place : corners) place *= to_unit_size(largest);
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
