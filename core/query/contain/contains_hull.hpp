// Whether a convex hull contains a point, in exact arithmetic on the stored numbers, and if not, how far outside the
// point is.
#pragma once

#include <type_traits>

#include "geometry/hull.hpp"
#include "geometry/orientation.hpp"

namespace snug::query {

/// Whether a convex polygon, with its boundary, contains the point. Its vertices are at(0), ..., at(n - 1), three or
/// more, counter-clockwise and no three on a line, as Vector<double, 2>. O(log n) time.
template <class At>
[[nodiscard]] bool polygon_contains(Index n, At&& at, const Vector<double, 2>& point) noexcept {
  const Vector<double, 2> apex = at(0);
  if (orient2d(apex, at(1), point) < 0 || orient2d(apex, at(n - 1), point) > 0) return false;
  Index low = 1, high = n - 1;  // the point is left of or on the line from the apex to low, right of or on that to high
  while (high - low > 1) {
    const Index middle = low + (high - low) / 2;
    (orient2d(apex, at(middle), point) >= 0 ? low : high) = middle;
  }
  return orient2d(at(low), at(low + 1), point) >= 0;
}

/// Whether the hull, flat or not, contains the point, its boundary included. hull: from quickhull.
/// O(log n) time in 2-D; in 3-D linear in the hull.
template <class Scalar, int Dim>
[[nodiscard]] bool contains(const ConvexHull<Scalar, Dim>& hull,
                            const std::type_identity_t<Vector<Scalar, Dim>>& point);

/// The distance from the facet's line or plane that the point is farthest outside of, a lower bound on its distance
/// from the hull; for a flat hull also its distance from the hull's plane or line. Scene units, within a few roundings
/// of the coordinates: 0 exactly if the hull contains the point, and positive otherwise, even if only exact arithmetic
/// can tell.
template <class Scalar, int Dim>
[[nodiscard]] double outside_by(const ConvexHull<Scalar, Dim>& hull,
                                const std::type_identity_t<Vector<Scalar, Dim>>& point);

}  // namespace snug::query
