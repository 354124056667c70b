// Bullet's btConvexHullComputer, as one function: its headers want compiler flags of their own.
#pragma once

#include "geometry/point_set.hpp"

namespace snug::bench {

/// How many vertices its hull has.
int bullet_vertices(PointSpan<double, 3> points);

}  // namespace snug::bench
