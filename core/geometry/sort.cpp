#include "geometry/sort.hpp"

#include <algorithm>
#include <numeric>

namespace snug {

std::vector<std::size_t> places_in_order(std::size_t n, PlaceBefore before, const void* given) {
  std::vector<std::size_t> order(n), places(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return before(given, a, b); });
  for (std::size_t i = 0; i < n; ++i) places[order[i]] = i;
  return places;
}

}  // namespace snug
