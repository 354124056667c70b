// The points that reach farthest along each coordinate axis, and along any one direction.
#pragma once

#include "fit/sphere/sphere_steps.hpp"
#include "trace/observer.hpp"

namespace snug::fit {

/// points: n >= 1. One pass, 2 Dim comparisons a point; of equal points, the first is kept.
template <class Scalar, int Dim, class Observer>
ExtremesFound<Scalar, Dim> extreme_points(PointSpan<Scalar, Dim> points, Observer& observe) {
  ExtremesFound<Scalar, Dim> found;
  Vector<Scalar, Dim> least = points[0];
  Vector<Scalar, Dim> greatest = points[0];
  for (Index i = 1; i < points.size(); ++i) {
    for (int axis = 0; axis < Dim; ++axis) {
      const Scalar coordinate = points[i][axis];
      if (coordinate < least[axis]) {
        least[axis] = coordinate;
        found.least[axis] = i;
      }
      if (coordinate > greatest[axis]) {
        greatest[axis] = coordinate;
        found.greatest[axis] = i;
      }
    }
  }
  observe.count(Operation::kPointsTouched, points.size());
  observe.count(Operation::kComparisons, 2 * Dim * std::int64_t{points.size()});
  return found;
}

struct DirectionExtremes {
  Index least = 0;
  Index greatest = 0;
};

/// The points with the least and the greatest projection onto direction, measured from origin. One pass.
template <class Scalar, int Dim, class Observer>
DirectionExtremes extreme_points_along(const Vector<Scalar, Dim>& direction, const Vector<Scalar, Dim>& origin,
                                       PointSpan<Scalar, Dim> points, Observer& observe) {
  DirectionExtremes found;
  Scalar least = direction.dot(points[0] - origin);
  Scalar greatest = least;
  for (Index i = 1; i < points.size(); ++i) {
    const Scalar projection = direction.dot(points[i] - origin);
    if (projection < least) {
      least = projection;
      found.least = i;
    }
    if (projection > greatest) {
      greatest = projection;
      found.greatest = i;
    }
  }
  observe.count(Operation::kPointsTouched, points.size());
  observe.count(Operation::kDotProducts, points.size());
  observe.count(Operation::kComparisons, 2 * std::int64_t{points.size()});
  return found;
}

}  // namespace snug::fit
