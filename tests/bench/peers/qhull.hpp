// Qhull, as one function: its C headers want compiler flags of their own.
#pragma once

#include "geometry/point_set.hpp"

namespace snug::bench {

/// How many vertices its hull has; negative where it fails. options: as on its command line.
int qhull_vertices(PointSpan<double, 3> points, const char* options);

}  // namespace snug::bench
