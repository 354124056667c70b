// The random order in which points are taken.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "geometry/random.hpp"
#include "geometry/vector.hpp"

namespace snug::fit {

/// The numbers from 0 to n - 1, each order as likely as any other.
[[nodiscard]] inline std::vector<Index> random_order(Index n, std::uint64_t seed) {
  std::vector<Index> order(n);
  std::iota(order.begin(), order.end(), Index{0});
  Random random(seed);
  for (std::size_t i = order.size(); i-- > 1;)
    std::swap(order[i], order[random.below(static_cast<std::uint32_t>(i + 1))]);
  return order;
}

}  // namespace snug::fit
