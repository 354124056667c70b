// The area or volume of a k-DOP.
#pragma once

#include "geometry/kdop.hpp"

namespace snug {

/// Area (2-D) or volume (3-D), within a few roundings of its size to the power of Dim; 0 if the slabs have no common
/// point. In 3-D the sum of the pyramids from a point to each face; each face is its plane, clipped by all other
/// slabs.
/// Source of the clipping: I. E. Sutherland, G. W. Hodgman, "Reentrant polygon clipping", 1974.
template <class Scalar, int Dim>
[[nodiscard]] double measure(const Kdop<Scalar, Dim>& kdop);

}  // namespace snug
