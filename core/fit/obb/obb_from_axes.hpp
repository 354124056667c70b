// The box of given axes, whose slabs hold every point exactly: what every box fitter ends with.
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

/// Whether each axis runs along a coordinate, so that nothing has to be projected.
template <class Scalar, int Dim>
[[nodiscard]] bool along_coordinates(const Matrix<Scalar, Dim>& axes) {
  const auto sizes = axes.cwiseAbs().array();
  return (sizes == 0 || sizes == 1).all() && (sizes.colwise().sum() == 1).all();
}

/// The smallest box of these axes, but for rounding: its centre is the rounded middle, and each half extent is the
/// least with which the slab around that centre holds all points in exact arithmetic (where more than a few thousand
/// points lie on its faces, perhaps the one after). So a half extent is 0 only if the points are flat exactly. axes:
/// unit, perpendicular and right-handed within rounding. One pass, and a second look at the blocks of points that reach
/// a face. Along the coordinates nothing is in doubt: least and greatest are exact, and one pass is all.
template <class Scalar, int Dim>
[[nodiscard]] BoxOnAxes<Scalar, Dim> obb_from_axes(const Matrix<Scalar, Dim>& axes, PointSpan<Scalar, Dim> points);

/// Tells of the extents along a box's axes, of so many points.
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

/// Every way out of a box fitter that knows the axes, as two steps from a line of the pseudocode on.
template <class Scalar, int Dim, class Observer>
Fit<Obb<Scalar, Dim>> finish_on_axes(const Matrix<Scalar, Dim>& axes, PointSpan<Scalar, Dim> points, int line,
                                     Observer& observe) {
  const BoxOnAxes<Scalar, Dim> found = obb_from_axes(axes, points);
  tell_extents(found, points.size(), line, observe);
  return finish_box(found, line + 1, observe);
}

}  // namespace snug::fit
