// Which places of a long list are shown.
#include "app/subjects/cloud/call_panel.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace snug::app {

TEST_CASE("a short list is shown whole; of a long one the front and the place at hand, in order, within the room") {
  CHECK(shown_places(3, 1, 8) == std::vector<int>{0, 1, 2});
  CHECK(shown_places(8, 7, 8).size() == 8);
  for (const int size : {9, 14, 29, 30, 1839})
    for (const int most : {8, 9, 28})
      for (int at = 0; at < size; ++at) {
        const std::vector<int> places = shown_places(size, at, most);
        REQUIRE(static_cast<int>(places.size()) <= most);
        REQUIRE(std::count(places.begin(), places.end(), at) == 1);
        REQUIRE(places.front() == 0);
        int before = -1;
        bool gap = false;
        for (const int place : places) {
          if (place == kListGap) {
            REQUIRE_FALSE(gap);
            gap = true;
            continue;
          }
          REQUIRE(gap == (place != before + 1));
          REQUIRE(place < size);
          before = place;
          gap = false;
        }
        REQUIRE(gap == (before != size - 1));
      }
}

}  // namespace snug::app
