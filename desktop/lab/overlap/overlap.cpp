#include "overlap.hpp"

bool overlap(const snug::Aabb<double, 3>& a, const snug::Aabb<double, 3>& b) {
  // The boxes have a.min, a.max, b.min and b.max: three coordinates each, such as a.min[0].
  return a.min[0] < b.max[0];
}
