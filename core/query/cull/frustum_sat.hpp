// Decides exactly, by separating axes, whether a box shares a point with a frustum. The plane test (classify.hpp) is
// measured against it, because that test calls some boxes outside the frustum, near its edges and vertices,
// intersecting. Source: S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree: A hierarchical structure for rapid interference
// detection", 1996, for the axes: the normals of both, and the cross products of their edges.
#pragma once

#include <array>

#include "geometry/aabb.hpp"
#include "geometry/frustum_corners.hpp"
#include "geometry/obb.hpp"

namespace snug::query {

/// A frustum that has vertices, prepared for many boxes.
template <class Scalar, int Dim>
class FrustumSat {
 public:
  /// Errors: as of corners_of.
  static tl::expected<FrustumSat, InputError> make(const Frustum<Scalar, Dim>& frustum);

  /// Whether they share a point; touching ones do. Exact on the numbers as they are, even for flat boxes. An OBB is the
  /// set that classify describes; its axes must be linearly independent.
  [[nodiscard]] bool overlaps(const Obb<Scalar, Dim>& box) const;
  [[nodiscard]] bool overlaps(const Aabb<Scalar, Dim>& box) const;

 private:
  using ExactCorners = std::array<ExactPoint<Dim>, kFrustumCorners<Dim>>;
  FrustumSat(const Frustum<Scalar, Dim>& frustum, ExactCorners exact);
  [[nodiscard]] bool overlaps_any(const auto& box) const;

  Frustum<Scalar, Dim> frustum_;
  std::array<Vector<double, Dim>, 2 * Dim> normals_;  // its planes', scaled to about 1: their products do not overflow
  ExactCorners exact_;
  std::array<Vector<double, Dim>, kFrustumCorners<Dim>> corners_;
  double size_ = 0;  // their largest coordinate; infinite if one overflows
};

}  // namespace snug::query
