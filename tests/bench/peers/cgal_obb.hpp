// CGAL's oriented_bounding_box, as one function: its headers want compiler flags of their own.
#pragma once

#include "geometry/point_set.hpp"

namespace snug::bench {

/// The volume of its box, with its own convex hull first and its own choice of everything else.
double cgal_obb_volume(PointSpan<double, 3> points);

}  // namespace snug::bench
