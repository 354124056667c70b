// What you write: see overlap.cpp.
#pragma once

#include <snug/geometry/aabb.hpp>

/// Whether two axis-aligned boxes have a point in common. Boxes that touch do. A box may be flat: min and max may be
/// equal along any axis.
bool overlap(const snug::Aabb<double, 3>& a, const snug::Aabb<double, 3>& b);
