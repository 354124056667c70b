// CGAL's Min_sphere_of_spheres_d, as one function: its headers want compiler flags of their own.
#pragma once

#include "geometry/point_set.hpp"

namespace snug::bench {

/// The radius of its smallest ball of the points, taken as they lie in memory.
double cgal_ball_radius(PointSpan<double, 3> points);

}  // namespace snug::bench
