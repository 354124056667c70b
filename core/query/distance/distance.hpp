// Distances between points, segments and rectangles, which are the cores of sphere-swept volumes.
// Source: C. Ericson, Real-Time Collision Detection, 2005, 5.1; of two rectangles
// query/distance/distance_rectangles.hpp.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/tolerance.hpp"
#include "geometry/vector.hpp"

namespace snug::query {

// All are in space; planar ones have z = 0. Coordinates are relative to some near point and at most about 1 in size
// (query/overlap/overlaps_swept.hpp ensures it), so that no product of four of them overflows and none that matters
// underflows. Each distance is within kTouching of the exact one, even between parallel, short or crossing cores.

/// The set of all start + t edge, 0 <= t <= 1; the edge may be zero.
template <class Scalar>
struct Segment {
  Vector<Scalar, 3> start, edge;
};

/// The set of all center + s axis_0 + t axis_1, |s|, |t| <= half_extents; either or both may be zero.
template <class Scalar>
struct Rectangle {
  Vector<Scalar, 3> center;
  Matrix<Scalar, 3> axes;  // one a column: unit and perpendicular, the last the normal
  std::array<Scalar, 2> half_extents;
};

template <class Scalar>
struct ClosestPoints {
  Vector<Scalar, 3> a, b;     // one on each, in the order of the arguments
  Vector<Scalar, 3> between;  // b - a, with digits that the difference of a and b may have lost
  Scalar square = 0;          // the squared distance
  int tests = 1;              // pairs of features compared
};

template <class Scalar>
[[nodiscard]] ClosestPoints<Scalar> pair_of(const Vector<Scalar, 3>& a, const Vector<Scalar, 3>& b) {
  return {a, b, b - a, (b - a).squaredNorm()};
}

/// Whether an edge of that squared length counts as a point.
template <class Scalar>
[[nodiscard]] bool vanishes(Scalar square) {
  return square <= tolerance::kVanishing<Scalar> * tolerance::kVanishing<Scalar>;
}

/// Where on a segment, from 0 to 1, the point nearest to p is.
template <class Scalar>
[[nodiscard]] Scalar nearest_place(const Vector<Scalar, 3>& p, const Segment<Scalar>& segment) {
  const Scalar square = segment.edge.squaredNorm();
  if (vanishes(square)) return 0;
  return std::clamp((p - segment.start).dot(segment.edge) / square, Scalar(0), Scalar(1));
}

template <class Scalar>
[[nodiscard]] ClosestPoints<Scalar> closest_points(const Vector<Scalar, 3>& p, const Segment<Scalar>& segment) {
  return pair_of<Scalar>(p, segment.start + nearest_place(p, segment) * segment.edge);
}

/// Projected along the first segment, that segment is a point, and the parameter on the second is where it passes
/// nearest to that point. It is computed from perpendicular components, not as 1 - cos^2, so it keeps its digits
/// between nearly parallel segments. For parallel ones any parameter will do, because the next steps correct it.
template <class Scalar>
[[nodiscard]] ClosestPoints<Scalar> closest_points(const Segment<Scalar>& a, const Segment<Scalar>& b) {
  const Scalar a_square = a.edge.squaredNorm();
  if (vanishes(a_square)) return closest_points(a.start, b);
  const Vector<Scalar, 3> between = b.start - a.start;
  const Vector<Scalar, 3> between_across = between - a.edge * (between.dot(a.edge) / a_square);
  const Vector<Scalar, 3> b_across = b.edge - a.edge * (b.edge.dot(a.edge) / a_square);
  const Scalar across = b_across.squaredNorm();
  Scalar t = across > 0 ? std::clamp(-between_across.dot(b_across) / across, Scalar(0), Scalar(1)) : Scalar(0);
  const Scalar s = (between + t * b.edge).dot(a.edge) / a_square;
  const Vector<Scalar, 3> on_a = a.start + std::clamp(s, Scalar(0), Scalar(1)) * a.edge;
  if (s < 0 || s > 1) t = nearest_place(on_a, b);
  return pair_of<Scalar>(on_a, b.start + t * b.edge);
}

template <class Scalar>
[[nodiscard]] ClosestPoints<Scalar> closest_points(const Vector<Scalar, 3>& p, const Rectangle<Scalar>& rectangle) {
  Vector<Scalar, 3> on = rectangle.center;
  for (int i = 0; i < 2; ++i) {
    const Scalar half = rectangle.half_extents[i];
    on += rectangle.axes.col(i) * std::clamp((p - rectangle.center).dot(rectangle.axes.col(i)), -half, half);
  }
  return pair_of<Scalar>(p, on);
}

/// The rectangle corner + s edges[0] + t edges[1], 0 <= s, t <= 1. edges: perpendicular, either or both may be zero.
template <class Scalar>
[[nodiscard]] Rectangle<Scalar> rectangle_of(const Vector<Scalar, 3>& corner,
                                             const std::array<Vector<Scalar, 3>, 2>& edges) {
  const std::array squares{edges[0].squaredNorm(), edges[1].squaredNorm()};
  Rectangle<Scalar> rectangle{corner + (edges[0] + edges[1]) / 2, Matrix<Scalar, 3>::Identity(), {0, 0}};
  Matrix<Scalar, 3>& axes = rectangle.axes;
  for (std::size_t i = 0; i < 2; ++i) {
    if (vanishes(squares[i])) continue;
    const Scalar length = std::sqrt(squares[i]);
    axes.col(static_cast<int>(i)) = edges[i] / length;
    rectangle.half_extents[i] = length / 2;
  }
  if (vanishes(squares[0]) && vanishes(squares[1])) return rectangle;
  for (int i = 0; i < 2; ++i) {  // a zero edge takes any direction perpendicular to the other
    if (!vanishes(squares[i])) continue;
    int least = 0;
    axes.col(1 - i).cwiseAbs().minCoeff(&least);
    axes.col(i) = axes.col(1 - i).cross(Vector<Scalar, 3>::Unit(least)).normalized();
  }
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return rectangle;
}

}  // namespace snug::query
