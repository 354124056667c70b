// What you write: see sat.cpp.
#pragma once

#include <snug/geometry/obb.hpp>

/// Whether two oriented boxes have a point in common, by the separating axis test. Boxes that touch do. The columns of
/// axes are unit and perpendicular: a.axes.col(0) is the first axis of A.
bool overlap(const snug::Obb<double, 3>& a, const snug::Obb<double, 3>& b);
