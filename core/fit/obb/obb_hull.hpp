// What box fitters do with the convex hull: compute it, measure their box on its vertices alone, and fit a rectangle
// around its projection.
#pragma once

#include <utility>
#include <vector>

#include "fit/counters.hpp"
#include "fit/hull/quickhull.hpp"
#include "fit/obb/min_area_rectangle.hpp"
#include "fit/obb/obb_frame.hpp"
#include "fit/obb/obb_from_axes.hpp"

namespace snug::fit {

/// Computes the hull and reports it as a single step, without the hull's own steps.
template <class Scalar, int Dim, class Observer>
ConvexHull<Scalar, Dim> watched_hull(PointSpan<Scalar, Dim> points, int line, Observer& observe) {
  ConvexHull<Scalar, Dim> hull;
  if constexpr (kWatched<Observer>) hull = quickhull(points, CountsOnly<Observer>{observe}).volume;
  else hull = quickhull(points).volume;
  observe(ObbStep<Scalar, Dim>{line, false, {}, HullFound{hull.indices, static_cast<Index>(hull.facets.size())}});
  return hull;
}

template <class Scalar, int Dim>
[[nodiscard]] PointSet<Scalar, Dim> vertices_of(const ConvexHull<Scalar, Dim>& hull) {
  return *PointSet<Scalar, Dim>::make(hull.vertices);  // points of a set: nothing is refused
}

/// Does what finish_on_axes does, on the hull's vertices alone. A box that contains them exactly contains their hull,
/// and so every point.
template <class Scalar, int Dim, class Observer>
Fit<Obb<Scalar, Dim>> finish_on_hull(const Matrix<Scalar, Dim>& axes, const ConvexHull<Scalar, Dim>& hull, int line,
                                     Observer& observe) {
  const PointSet<Scalar, Dim> vertices = vertices_of(hull);
  BoxOnAxes<Scalar, Dim> found = obb_from_axes(axes, vertices.span());
  for (auto* ends : {&found.least, &found.greatest})
    for (Index& i : *ends) i = hull.indices[i];
  tell_extents(found, vertices.size(), line, observe);
  return finish_box(found, line + 1, observe);
}

/// A smallest rectangle, as its frame: the first side lies on the edge between two of the points (kNoIndex if all
/// coincide).
template <int Dim>
struct RectangleFrame {
  Matrix<double, Dim> axes;
  Index edge_a = kNoIndex, edge_b = kNoIndex;
};

/// The smallest rectangle around a hull in the plane, even a flat one. edge_a, edge_b: the points' indices.
template <class Scalar, class Observer>
RectangleFrame<2> smallest_rectangle(const ConvexHull<Scalar, 2>& hull, Observer& observe) {
  if (hull.affine_dim == 0) return {Matrix<double, 2>::Identity()};
  std::size_t on = 0;
  if (hull.affine_dim == 2) on = static_cast<std::size_t>(Calipers<Scalar, Observer>(hull, observe).run().on);
  const std::size_t to = (on + 1) % hull.vertices.size();
  const Vector<double, 2> a = hull.vertices[on].template cast<double>(), b = hull.vertices[to].template cast<double>();
  return {frame(Vector<double, 2>(b - a)), hull.indices[on], hull.indices[to]};
}

/// The smallest rectangle around the points' projection along a direction, which is the frame's first axis. points: n
/// >= 1, with coordinates of about 1; the edge is given by their indices. count: Ignore or PartCounter. O(n log n)
/// time.
template <class Count>
[[nodiscard]] RectangleFrame<3> rectangle_along(const Vector<double, 3>& direction,
                                                const std::vector<Vector<double, 3>>& points, Count& count);

[[nodiscard]] inline RectangleFrame<3> rectangle_along(const Vector<double, 3>& direction,
                                                       const std::vector<Vector<double, 3>>& points) {
  Ignore ignore;
  return rectangle_along(direction, points, ignore);
}

/// A normal of the plane of a flat hull, of any length. Its line is the one from the first vertex to the farthest, the
/// vertex farthest from that line gives the plane, and the normal is perpendicular to both within their roundings: so a
/// sliver lies in its plane as well as a square does. vertices: three or more, of about 1 in size. count: as above.
/// O(n) time.
template <class Count>
[[nodiscard]] Vector<double, 3> flat_normal(const std::vector<Vector<double, 3>>& vertices, Count& count);

/// The same for an observer: it is told the counts, but no steps.
template <class Observer>
[[nodiscard]] Vector<double, 3> watched_flat_normal(const std::vector<Vector<double, 3>>& vertices, Observer& observe) {
  PartCounterFor<Observer> tally;
  const Vector<double, 3> normal = flat_normal(vertices, tally);
  hand_on(tally, observe);
  return normal;
}

/// A rectangle on which the calipers stand while they turn around a projection.
struct CalipersTurn {
  RectangleFrame<3> rectangle;
  std::vector<Index> touching;  // the ends of its edge first
  bool better = false;          // whether it is the smallest so far
};

/// The same, and appends every rectangle in the order of the turn. None if the projection is flat.
[[nodiscard]] RectangleFrame<3> rectangle_along(const Vector<double, 3>& direction,
                                                const std::vector<Vector<double, 3>>& points, PartCounter& count,
                                                std::vector<CalipersTurn>& turns);

/// The same for an observer: it is told the counts, but no steps.
template <class Observer>
[[nodiscard]] RectangleFrame<3> watched_rectangle_along(const Vector<double, 3>& direction,
                                                        const std::vector<Vector<double, 3>>& points,
                                                        Observer& observe) {
  PartCounterFor<Observer> tally;
  RectangleFrame<3> found = rectangle_along(direction, points, tally);
  hand_on(tally, observe);
  return found;
}

}  // namespace snug::fit
