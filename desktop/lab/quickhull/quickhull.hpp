// What you write: see quickhull.cpp.
#pragma once

#include <snug/geometry/vector.hpp>
#include <vector>

/// Quickhull's step at an edge: the index of the point that lies farthest to the left of the line from points[a] to
/// points[b], or -1 if no point lies to its left. If several points are equally far, any of them will do.
/// points[a] and points[b] differ.
int farthest(const std::vector<snug::Vector<double, 2>>& points, int a, int b);
