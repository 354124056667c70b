// Whether a convex hull holds a point, in exact arithmetic on the numbers as they are; and if not, how far it lies
// outside.
#pragma once

#include <type_traits>

#include "geometry/hull.hpp"
#include "geometry/orientation.hpp"

namespace snug::query {

/// Whether a convex polygon holds the point; the boundary belongs to it. Its corners: at(0), ..., at(n - 1), three or
/// more, counter-clockwise and no three on a line, as Vector<double, 2>. O(log n) time.
template <class At>
[[nodiscard]] bool polygon_contains(Index n, At&& at, const Vector<double, 2>& point) noexcept {
  const Vector<double, 2> apex = at(0);
  if (orient2d(apex, at(1), point) < 0 || orient2d(apex, at(n - 1), point) > 0) return false;
  Index low = 1, high = n - 1;  // the point is left of or on the way from the apex to low, right of or on that to high
  while (high - low > 1) {
    const Index middle = low + (high - low) / 2;
    (orient2d(apex, at(middle), point) >= 0 ? low : high) = middle;
  }
  return orient2d(at(low), at(low + 1), point) >= 0;
}

/// Whether the hull, flat or not, holds the point; the boundary belongs to it. hull: as quickhull gives it.
/// O(log n) time in 2-D; in 3-D linear in the hull.
template <class Scalar, int Dim>
[[nodiscard]] bool contains(const ConvexHull<Scalar, Dim>& hull,
                            const std::type_identity_t<Vector<Scalar, Dim>>& point);

/// How far outside of that facet's line or plane which it is farthest out of the point lies, which is no more than its
/// distance from the hull; of a flat hull also how far off its plane or line. Scene units, within a few roundings of
/// the coordinates: 0 just where the hull contains the point, and positive elsewhere even if only exact arithmetic
/// tells.
template <class Scalar, int Dim>
[[nodiscard]] double outside_by(const ConvexHull<Scalar, Dim>& hull,
                                const std::type_identity_t<Vector<Scalar, Dim>>& point);

}  // namespace snug::query
