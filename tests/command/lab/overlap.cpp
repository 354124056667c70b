#include "overlap.hpp"

bool overlap(const snug::Aabb<double, 3>& a, const snug::Aabb<double, 3>& b) {
  for (int i = 0; i < 3; ++i)
    if (a.max[i] < b.min[i] || b.max[i] < a.min[i]) return false;
  return true;
}
