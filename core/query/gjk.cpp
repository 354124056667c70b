#include "query/gjk.hpp"

#include "query/power_of_two.hpp"

namespace snug::query {

template class Gjk<Ignore>;

ScaledCores scaled_cores(Corners<3> a, double radius_a, Corners<3> b, double radius_b) {
  double largest = std::max(radius_a, radius_b);
  for (const Corners<3>* corners : {&a, &b})
    for (const auto& corner : *corners) largest = std::max(largest, corner.cwiseAbs().maxCoeff());
  const double unit = power_of_two_above(largest);
  for (Corners<3>* corners : {&a, &b})
    for (auto& corner : *corners) corner *= 1 / unit;
  return {std::move(a), std::move(b), radius_a / unit, radius_b / unit, unit};
}

}  // namespace snug::query
