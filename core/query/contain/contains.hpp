// Whether a volume contains a point, in exact arithmetic on the numbers as they are; and if not, how far it lies
// outside. For the convex hull see query/contain/contains_hull.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "query/distance/gjk.hpp"

namespace snug::query {

/// -1, 0 or +1: whether |(point - center) . axis| is below, at or above half_extent, exactly: one slab of a box.
/// The axis need not be unit.
template <class Scalar, int Dim>
[[nodiscard]] int side_of_slab(const Vector<Scalar, Dim>& point, const Vector<Scalar, Dim>& center,
                               const Vector<Scalar, Dim>& axis, std::type_identity_t<Scalar> half_extent) noexcept;

/// Whether the volume contains the point; the boundary belongs to it. An OBB is the meeting of its slabs, a lozenge
/// what is near its parallelogram, whether or not its edges are quite perpendicular. All coordinates finite, and small
/// enough that their differences are. Other volumes say it in their own headers.
using snug::contains;
template <class Scalar, int Dim>
[[nodiscard]] bool contains(const Obb<Scalar, Dim>&, const std::type_identity_t<Vector<Scalar, Dim>>& point);
template <class Scalar, int Dim>
[[nodiscard]] bool contains(const Capsule<Scalar, Dim>&, const std::type_identity_t<Vector<Scalar, Dim>>& point);
template <class Scalar, int Dim>
[[nodiscard]] bool contains(const Lozenge<Scalar, Dim>&, const std::type_identity_t<Vector<Scalar, Dim>>& point);
template <class Scalar, int Dim>
[[nodiscard]] bool contains(const Kdop<Scalar, Dim>&, const std::type_identity_t<Vector<Scalar, Dim>>& point);

/// An excess that only exact arithmetic sees counts as at least the last digit of the size that it was compared with.
[[nodiscard]] inline double at_least_a_digit(double excess, double size) {
  return std::max({excess, std::nextafter(size, std::numeric_limits<double>::infinity()) - size,
                   std::numeric_limits<double>::denorm_min()});
}

/// How far outside the volume the point lies, scene units, within a few roundings of the coordinates: 0 just where the
/// volume contains it, and positive elsewhere even if only exact arithmetic tells. For any kind of volume by GJK; the
/// kinds below have their own. For a k-DOP it is how far the point lies outside the slab that it is farthest out of: a
/// lower bound on the distance.
template <template <class, int> class Kind, class Scalar, int Dim>
[[nodiscard]] double outside_by(const Kind<Scalar, Dim>& volume,
                                const std::type_identity_t<Vector<Scalar, Dim>>& point) {
  if (contains(volume, point)) return 0;
  const auto apart = gjk(Sphere<Scalar, Dim>{point, 0}, volume);
  if (!apart) return std::numeric_limits<double>::infinity();
  return at_least_a_digit(static_cast<double>(apart->distance), difference(point, anchor(volume)).norm());
}
template <class Scalar, int Dim>
[[nodiscard]] double outside_by(const Sphere<Scalar, Dim>&, const std::type_identity_t<Vector<Scalar, Dim>>& point);
template <class Scalar, int Dim>
[[nodiscard]] double outside_by(const Aabb<Scalar, Dim>&, const std::type_identity_t<Vector<Scalar, Dim>>& point);
template <class Scalar, int Dim>
[[nodiscard]] double outside_by(const Obb<Scalar, Dim>&, const std::type_identity_t<Vector<Scalar, Dim>>& point);
template <class Scalar, int Dim>
[[nodiscard]] double outside_by(const Capsule<Scalar, Dim>&, const std::type_identity_t<Vector<Scalar, Dim>>& point);
template <class Scalar, int Dim>
[[nodiscard]] double outside_by(const Lozenge<Scalar, Dim>&, const std::type_identity_t<Vector<Scalar, Dim>>& point);
template <class Scalar, int Dim>
[[nodiscard]] double outside_by(const Kdop<Scalar, Dim>&, const std::type_identity_t<Vector<Scalar, Dim>>& point);

}  // namespace snug::query
