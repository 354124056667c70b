// The box with given axes, whose slabs contain every point exactly. Every box fitter ends with it.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "fit/obb/obb_steps.hpp"
#include "geometry/point_set.hpp"

namespace snug::fit {

/// A box, and the points that reach farthest to either side along each of its axes.
template <class Scalar, int Dim>
struct BoxOnAxes {
  Obb<Scalar, Dim> box;
  std::vector<Index> least, greatest;
};

/// Whether each axis is a coordinate axis, so that nothing has to be projected.
template <class Scalar, int Dim>
[[nodiscard]] bool along_coordinates(const Matrix<Scalar, Dim>& axes) {
  const auto sizes = axes.cwiseAbs().array();
  return (sizes == 0 || sizes == 1).all() && (sizes.colwise().sum() == 1).all();
}

/// The smallest box with these axes, but for rounding: its centre is the rounded middle, and each half extent is the
/// least number with which the slab around that centre contains all points in exact arithmetic (or the next larger one,
/// if more than a few thousand points lie on its faces). So a half extent is 0 only if the points are exactly flat.
/// axes: unit, perpendicular and right-handed within rounding. One pass, and a second over the blocks of points that
/// reach a face. Along coordinate axes, least and greatest are exact, and one pass is enough.
template <class Scalar, int Dim>
[[nodiscard]] BoxOnAxes<Scalar, Dim> obb_from_axes(const Matrix<Scalar, Dim>& axes, PointSpan<Scalar, Dim> points);

/// Reports the extents along a box's axes. points: how many there were.
template <class Scalar, int Dim, class Observer>
void tell_extents(const BoxOnAxes<Scalar, Dim>& found, std::int64_t points, int line, Observer& observe) {
  observe.count(Operation::kPointsTouched, points);
  const bool projected = !along_coordinates<Scalar, Dim>(found.box.axes);
  observe.count(Operation::kDotProducts, projected ? Dim * points : 0);
  observe.count(Operation::kComparisons, 2 * Dim * points);
  observe(ObbStep<Scalar, Dim>{
      line, true, found.box,
      ExtentsFound<Scalar, Dim>{found.least, found.greatest, Vector<Scalar, Dim>(2 * found.box.half_extents)}});
}

/// The last step, and the box with the points that reach its faces, each once.
template <class Scalar, int Dim, class Observer>
Fit<Obb<Scalar, Dim>> finish_box(const BoxOnAxes<Scalar, Dim>& found, int line, Observer& observe) {
  std::vector<Index> support;
  for (const auto* ends : {&found.least, &found.greatest})
    for (const Index i : *ends)
      if (std::find(support.begin(), support.end(), i) == support.end()) support.push_back(i);
  observe(ObbStep<Scalar, Dim>{line, true, found.box, Finished{support}});
  return {found.box, std::move(support)};
}

/// Ends a box fitter that knows the axes, with two steps, on the given line of the pseudocode and the next.
template <class Scalar, int Dim, class Observer>
Fit<Obb<Scalar, Dim>> finish_on_axes(const Matrix<Scalar, Dim>& axes, PointSpan<Scalar, Dim> points, int line,
                                     Observer& observe) {
  const BoxOnAxes<Scalar, Dim> found = obb_from_axes(axes, points);
  tell_extents(found, points.size(), line, observe);
  return finish_box(found, line + 1, observe);
}

}  // namespace snug::fit
