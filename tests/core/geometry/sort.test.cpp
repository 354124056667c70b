#include "geometry/sort.hpp"

#include <algorithm>
#include <array>
#include <doctest/doctest.h>
#include <string>
#include <utility>
#include <vector>

#include "geometry/random.hpp"

using namespace snug;

TEST_CASE("items are sorted as std::stable_sort sorts them, those of which neither comes first in their order") {
  Random random(16);
  for (int n = 0; n < 60; ++n)
    for (const int keys : {1, 3, 1000}) {
      std::vector<std::pair<int, std::string>> items;
      for (int i = 0; i < n; ++i) items.emplace_back(static_cast<int>(random.between(0, keys)), std::to_string(i));
      auto expected = items;
      const auto by_key = [](const auto& a, const auto& b) { return a.first < b.first; };
      std::stable_sort(expected.begin(), expected.end(), by_key);
      sort_stably(items, by_key);
      CHECK(items == expected);
    }
}

TEST_CASE("an array is sorted by what comes first of itself") {
  std::array<std::string, 4> words{"plane", "box", "sphere", "axis"};
  sort_stably(words);
  CHECK(words == std::array<std::string, 4>{"axis", "box", "plane", "sphere"});
}
