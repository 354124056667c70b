#include "app/numbers.hpp"

#include <cmath>

namespace snug::app {

double nice_at_least(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= value) return factor * power;
  return 10 * power;
}

}  // namespace snug::app
