#include "app/subjects/pair/table_unit.hpp"

#include <algorithm>
#include <cmath>

#include "lesson/figures.hpp"

namespace snug::app {

double TableUnit::in(double length) const { return power == 0 ? length : length / std::pow(10.0, power); }

std::string TableUnit::words() const { return power == 0 ? "units" : "10" + lesson::raised(power) + " units"; }

TableUnit table_unit(const lesson::BoxPair& pair) {
  constexpr double kLarge = 1e4, kSmall = 1e-2;  // between them a length has at most six signs
  const auto& [a, b] = pair.boxes;
  const double size = std::max({(b.center - a.center).norm(), a.half_extents.maxCoeff(), b.half_extents.maxCoeff()});
  if (size == 0 || (size >= kSmall && size < kLarge)) return {};
  return {static_cast<int>(std::floor(std::log10(size)))};
}

}  // namespace snug::app
