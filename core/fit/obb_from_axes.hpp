// The box of given axes, whose slabs hold every point exactly: what every box fitter ends with.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "fit/obb_steps.hpp"
#include "geometry/point_set.hpp"

namespace snug::fit {

/// A box, and the points that reach farthest to either side along each of its axes.
template <class Scalar, int Dim>
struct BoxOnAxes {
  Obb<Scalar, Dim> box;
  std::vector<Index> least, greatest;
};

/// The smallest box of these axes, but for rounding: its centre is the rounded middle, and each half extent is the least
/// with which the slab around that centre holds all points in exact arithmetic (where more than a few thousand points lie
/// on its faces, perhaps the one after). So a half extent is 0 only if the points are flat exactly.
/// axes: unit, perpendicular and right-handed within rounding. One pass, and a second look at the blocks of points that
/// reach a face.
template <class Scalar, int Dim>
[[nodiscard]] BoxOnAxes<Scalar, Dim> obb_from_axes(const Matrix<Scalar, Dim>& axes, PointSpan<Scalar, Dim> points);

/// The same as a step.
template <class Scalar, int Dim, class Observer>
BoxOnAxes<Scalar, Dim> watched_extents(const Matrix<Scalar, Dim>& axes, PointSpan<Scalar, Dim> points, int line,
                                       Observer& observe) {
  BoxOnAxes<Scalar, Dim> found = obb_from_axes(axes, points);
  observe.count(Operation::kPointsTouched, points.size());
  observe.count(Operation::kDotProducts, Dim * std::int64_t{points.size()});
  observe.count(Operation::kComparisons, 2 * Dim * std::int64_t{points.size()});
  observe(ObbStep<Scalar, Dim>{
      line, true, found.box,
      ExtentsFound<Scalar, Dim>{found.least, found.greatest, Vector<Scalar, Dim>(2 * found.box.half_extents)}});
  return found;
}

/// Every way out of a box fitter: the last step, and the box with the points that reach its faces, each once.
template <class Scalar, int Dim, class Observer>
Fit<Obb<Scalar, Dim>> finish_box(const BoxOnAxes<Scalar, Dim>& found, int line, Observer& observe) {
  std::vector<Index> support;
  for (const auto* ends : {&found.least, &found.greatest})
    for (const Index i : *ends)
      if (std::find(support.begin(), support.end(), i) == support.end()) support.push_back(i);
  observe(ObbStep<Scalar, Dim>{line, true, found.box, Finished{support}});
  return {found.box, std::move(support)};
}

/// Both, on two lines of the pseudocode.
template <class Scalar, int Dim, class Observer>
Fit<Obb<Scalar, Dim>> finish_on_axes(const Matrix<Scalar, Dim>& axes, PointSpan<Scalar, Dim> points, int line,
                                     Observer& observe) {
  return finish_box(watched_extents(axes, points, line, observe), line + 1, observe);
}

}  // namespace snug::fit
