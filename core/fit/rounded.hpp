// What the certificate of a fit in float leaves out: it is about the points as rounded, not about those that were
// given.
#pragma once

#include <span>

#include "fit/any_step.hpp"
#include "fit/certify.hpp"
#include "geometry/point_set.hpp"

namespace snug::fit {

/// Whether the points are held in float.
[[nodiscard]] bool are_float(const AnyPointSet& points);

struct Rounded {
  double by = 0;           // the farthest that rounding moved a point, scene units
  double max_outside = 0;  // the farthest that a point lay outside the volume before it was rounded, scene units
};

/// points: those that the result was fitted to, with its certificate. given: the same before they were rounded, as
/// many; in 2-D z is ignored.
[[nodiscard]] Rounded rounded(const Result& result, const Certificate& certificate, const AnyPointSet& points,
                              std::span<const Vector<double, 3>> given);

}  // namespace snug::fit
