// Does a box share a point with a frustum? By separating axes of both, decided exactly: what the plane test
// (classify.hpp) is measured against, for it calls some boxes near the frustum's edges and corners intersecting that
// are outside. Source: S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree: A hierarchical structure for rapid interference
// detection", 1996, for the axes: normals of both, and crosses of their edges.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/aabb.hpp"
#include "geometry/frustum_corners.hpp"
#include "geometry/obb.hpp"
#include "query/classify_steps.hpp"

namespace snug::query {

/// A frustum that has corners, prepared for many boxes.
template <class Scalar, int Dim>
class FrustumSat {
 public:
  /// Errors: as of corners_of.
  static tl::expected<FrustumSat, InputError> make(const Frustum<Scalar, Dim>& frustum);

  /// Whether they share a point; touching ones do. Exact on the numbers as they are, flat boxes too; of an OBB as
  /// classify has it. Its axes must be linearly independent.
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
  double size_ = 0;  // their largest coordinate; infinite where one is beyond every double
};

/// How the plane test's answers compare with what is true.
struct CullTally {
  std::int64_t inside = 0, intersecting = 0, outside = 0;  // as the plane test has it
  std::int64_t really_outside = 0;                         // of those it calls intersecting
};

/// Errors: as of corners_of. boxes: as of classify.
template <class Scalar, int Dim>
[[nodiscard]] tl::expected<CullTally, InputError> tally(const Frustum<Scalar, Dim>& frustum,
                                                        std::span<const Obb<Scalar, Dim>> boxes);

}  // namespace snug::query
