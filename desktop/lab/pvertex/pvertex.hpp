// What you write: see pvertex.cpp.
#pragma once

#include <snug/geometry/aabb.hpp>

struct Vertices {
  snug::Vector<double, 3> p, n;
};

/// The vertices of a box that lie farthest along the normal (p) and farthest against it (n), from the signs of the
/// normal's coordinates alone. Where a coordinate is 0, either end will do.
Vertices vertices(const snug::Aabb<double, 3>& box, const snug::Vector<double, 3>& normal);
