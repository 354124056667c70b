#include "app/numbers.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace snug::app {

std::string short_figure(double value) {
  std::array<char, 64> text{};
  const double size = std::abs(value);
  if (size == 0) return "0";
  if (size >= 1e5 || size < 1e-4) {
    std::snprintf(text.data(), text.size(), "%.1e", size);
  } else {
    // Two decimals, or of a smaller length two digits.
    const int decimals = size >= 100 ? 1 : size >= 0.1 ? 2 : 1 - static_cast<int>(std::floor(std::log10(size)));
    std::snprintf(text.data(), text.size(), "%.*f", decimals, size);
  }
  return (value < 0 ? "−" : "") + std::string(text.data());
}

double nice_at_least(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= value) return factor * power;
  return 10 * power;
}

}  // namespace snug::app
