#include "pvertex.hpp"

Vertices vertices(const snug::Aabb<double, 3>& box, const snug::Vector<double, 3>& normal) {
  Vertices found;
  for (int i = 0; i < 3; ++i) {
    found.p[i] = normal[i] >= 0 ? box.max[i] : box.min[i];
    found.n[i] = normal[i] >= 0 ? box.min[i] : box.max[i];
  }
  return found;
}
