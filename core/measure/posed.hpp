// Volumes that rotate with their body. AABBs and k-DOPs have axes of their own, and must be fitted anew.
#pragma once

#include "geometry/volume.hpp"

namespace snug::cost {

template <class Scalar, int Dim>
[[nodiscard]] Sphere<Scalar, Dim> posed(const Sphere<Scalar, Dim>& sphere, const Pose<Scalar, Dim>& pose) {
  return {placed(pose, sphere.center), sphere.radius};
}

template <class Scalar, int Dim>
[[nodiscard]] Obb<Scalar, Dim> posed(const Obb<Scalar, Dim>& box, const Pose<Scalar, Dim>& pose) {
  return {placed(pose, box.center), orthonormal<Scalar, Dim>(pose.rotation * box.axes), box.half_extents};
}

template <class Scalar, int Dim>
[[nodiscard]] Capsule<Scalar, Dim> posed(const Capsule<Scalar, Dim>& capsule, const Pose<Scalar, Dim>& pose) {
  return {placed(pose, capsule.a), placed(pose, capsule.b), capsule.radius};
}

template <class Scalar, int Dim>
[[nodiscard]] Lozenge<Scalar, Dim> posed(const Lozenge<Scalar, Dim>& lozenge, const Pose<Scalar, Dim>& pose) {
  return {placed(pose, lozenge.origin),
          {pose.rotation * lozenge.edges[0], pose.rotation * lozenge.edges[1]},
          lozenge.radius};
}

template <class Scalar, int Dim>
[[nodiscard]] ConvexHull<Scalar, Dim> posed(ConvexHull<Scalar, Dim> hull, const Pose<Scalar, Dim>& pose) {
  for (auto& vertex : hull.vertices) vertex = placed(pose, vertex);
  return hull;
}

/// A volume that can be posed: it is fitted once, and then rotates and moves with its body.
template <class Kind>
inline constexpr bool kRotatesWithBody = false;
template <template <class, int> class Kind, class Scalar, int Dim>
inline constexpr bool kRotatesWithBody<Kind<Scalar, Dim>> = requires(const Kind<Scalar, Dim>& volume,
                                                                     const Pose<Scalar, Dim>& pose) {
  posed(volume, pose);
};

}  // namespace snug::cost
