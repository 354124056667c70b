// Sorting that gives the same order everywhere and is compiled once. std::sort orders equal items differently in each
// library, and it and std::stable_sort each add two kilobytes to the page for every type of item. This is for what is
// sorted now and then; std::sort is for numbers, and where a run's time is measured.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace snug {

/// Whether the item at place a comes before that at place b. given: the pointer that was passed along with the
/// function.
using PlaceBefore = bool (*)(const void* given, std::size_t a, std::size_t b);

/// Returns the place that each of n items belongs to. Equal items keep their order. O(n log n).
[[nodiscard]] std::vector<std::size_t> places_in_order(std::size_t n, PlaceBefore before, const void* given);

/// items: with size() and a subscript. before(a, b): whether item a comes before item b.
template <class Items, class Before = std::less<>>
void sort_stably(Items& items, const Before& before = {}) {
  const auto at = [&](std::size_t a, std::size_t b) { return before(items[a], items[b]); };
  const PlaceBefore call = [](const void* given, std::size_t a, std::size_t b) -> bool {
    return (*static_cast<decltype(&at)>(given))(a, b);
  };
  std::vector<std::size_t> places = places_in_order(items.size(), call, &at);
  for (std::size_t i = 0; i < places.size(); ++i)
    while (places[i] != i) {
      const std::size_t to = places[i];
      std::swap(items[i], items[to]);
      std::swap(places[i], places[to]);
    }
}

}  // namespace snug
