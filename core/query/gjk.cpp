#include "query/gjk.hpp"

#include "query/power_of_two.hpp"

namespace snug::query {

template class Gjk<Ignore>;
SNUG_GJK(float, 2)
SNUG_GJK(float, 3)
SNUG_GJK(double, 2)
SNUG_GJK(double, 3)

double scale_to_unit(GrownCore& a, GrownCore& b) {
  double largest = std::max(a.radius, b.radius);
  for (const GrownCore* core : {&a, &b})
    for (const auto& corner : core->corners) largest = std::max(largest, corner.cwiseAbs().maxCoeff());
  const double unit = power_of_two_above(largest);
  for (GrownCore* core : {&a, &b}) {
    core->radius /= unit;
    for (auto& corner : core->corners) corner *= 1 / unit;
  }
  return unit;
}

}  // namespace snug::query
