// Boxes, k-DOPs and hulls in one form for drawing: vertices and flat faces.
#pragma once

#include <vector>

#include "fit/any_step.hpp"

namespace snug::app {

struct Polytope {
  std::vector<Vector<double, 3>> corners;
  /// The faces as indices into corners, counter-clockwise as seen from outside. In 2-D there is one, the polygon.
  std::vector<std::vector<int>> faces;
};

[[nodiscard]] Polytope polytope_of(const Obb<double, 3>& box, int dim);
[[nodiscard]] Polytope polytope_of(const Aabb<double, 3>& box, int dim);
[[nodiscard]] Polytope polytope_of(const Kdop<double, 3>& kdop, int dim);
[[nodiscard]] Polytope polytope_of(const ConvexHull<double, 3>& hull, int dim);

/// The point of a volume farthest in a direction.
[[nodiscard]] Vector<double, 3> farthest_in(const fit::Volume3& volume, const Vector<double, 3>& direction, int dim);

/// A ball around a volume, to frame the view.
[[nodiscard]] fit::Sphere3 ball_around(const fit::Volume3& volume, int dim);
/// The smallest ball that contains both.
[[nodiscard]] fit::Sphere3 ball_around(const fit::Sphere3& a, const fit::Sphere3& b);

}  // namespace snug::app
