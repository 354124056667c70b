// How far an algorithm is from the smallest volume of its kind: on many clouds, and on one that was made to be hard for
// it.
#pragma once

#include <cstdint>

#include "fit/catalogue.hpp"

namespace snug::cost {

struct Excess {
  double median = 0, most = 0;  // size over the smallest, less 1, over clouds of every kind
  int clouds = 0;
  double found = 0;  // the most that was found by moving points of a small cloud
  int tried = 0;     // such clouds
};

/// In 3-D. algorithm: of a volume with an exact algorithm.
[[nodiscard]] Excess excess_of(const fit::Algorithm& algorithm, std::uint64_t seed);

/// The excess on one set; 0 where the smallest is flat, its size nothing but rounding.
[[nodiscard]] double excess_on(const fit::Algorithm& algorithm, const AnyPointSet& points, std::uint64_t seed);

}  // namespace snug::cost
