// The axis-aligned box, as an oriented one.
// Source: C. Ericson, "Real-Time Collision Detection", 2005, section 4.2.
#pragma once

#include <array>
#include <string_view>

#include "fit/obb/obb_from_axes.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 3> kObbAabbPseudocode{
    "axes ← the coordinate axes x, y, z",
    "extents ← least and greatest along each",
    "return box",
};

/// The box on the axes that the points' coordinates are measured along: an AABB that can turn with its object.
/// points: n >= 1 finite points, scene units. O(n) time: one pass.
template <class Scalar, int Dim, StepObserver<ObbStep<Scalar, Dim>> Observer = Ignore>
Fit<Obb<Scalar, Dim>> obb_aabb(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  return finish_on_axes<Scalar, Dim>(Matrix<Scalar, Dim>::Identity(), points, 1, observe);
}

}  // namespace snug::fit
