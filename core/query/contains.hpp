// Whether a volume holds a point, in exact arithmetic on the numbers as they are; and if not, how far it lies outside.
// For the convex hull see query/contains_hull.hpp.
#pragma once

#include <type_traits>

#include "geometry/aabb.hpp"
#include "geometry/capsule.hpp"
#include "geometry/kdop.hpp"
#include "geometry/lozenge.hpp"
#include "geometry/obb.hpp"
#include "geometry/sphere.hpp"

namespace snug::query {

/// -1, 0 or +1: whether |(point - center) . axis| is below, at or above half_extent, exactly: one slab of a box.
/// The axis need not be unit.
template <class Scalar, int Dim>
[[nodiscard]] int side_of_slab(const Vector<Scalar, Dim>& point, const Vector<Scalar, Dim>& center,
                               const Vector<Scalar, Dim>& axis, std::type_identity_t<Scalar> half_extent) noexcept;

/// Whether the volume holds the point; the boundary belongs to it. An OBB is the meeting of its slabs, a lozenge what
/// is near its parallelogram, whether or not its edges are quite perpendicular. All coordinates finite, and small
/// enough that their differences are.
template <class Scalar, int Dim>
[[nodiscard]] bool contains(const Sphere<Scalar, Dim>&, const std::type_identity_t<Vector<Scalar, Dim>>& point);
template <class Scalar, int Dim>
[[nodiscard]] bool contains(const Aabb<Scalar, Dim>&, const std::type_identity_t<Vector<Scalar, Dim>>& point);
template <class Scalar, int Dim>
[[nodiscard]] bool contains(const Obb<Scalar, Dim>&, const std::type_identity_t<Vector<Scalar, Dim>>& point);
template <class Scalar, int Dim>
[[nodiscard]] bool contains(const Capsule<Scalar, Dim>&, const std::type_identity_t<Vector<Scalar, Dim>>& point);
template <class Scalar, int Dim>
[[nodiscard]] bool contains(const Lozenge<Scalar, Dim>&, const std::type_identity_t<Vector<Scalar, Dim>>& point);
template <class Scalar, int Dim>
[[nodiscard]] bool contains(const Kdop<Scalar, Dim>&, const std::type_identity_t<Vector<Scalar, Dim>>& point);

/// How far outside the volume the point lies, scene units, within a few roundings of the coordinates: 0 just where the
/// volume contains it, and positive elsewhere even if only exact arithmetic tells. Of a k-DOP: how far outside that
/// slab which it is farthest out of, which is no more than the distance.
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
