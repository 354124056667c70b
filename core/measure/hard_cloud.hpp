// Measures how far an algorithm is from the smallest volume of its kind: on many clouds, and on small ones made to be
// hard for it.
#pragma once

#include <cstdint>

#include "fit/catalogue.hpp"

namespace snug::cost {

struct Excess {
  double median = 0, most = 0;  // size over the smallest, minus 1, over clouds of every kind
  int clouds = 0;
  double found = 0;  // the greatest that was found by moving the points of a small cloud
  int tried = 0;     // how many such clouds were tried
};

/// In 3-D. algorithm: of a volume with an exact algorithm.
[[nodiscard]] Excess excess_of(const fit::Algorithm& algorithm, std::uint64_t seed);

/// The excess on one set; 0 if the smallest volume is flat, its size only rounding.
[[nodiscard]] double excess_on(const fit::Algorithm& algorithm, const AnyPointSet& points, std::uint64_t seed);

}  // namespace snug::cost
