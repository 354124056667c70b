#include "app/labels.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "geometry/random.hpp"

namespace snug::app {
namespace {

const Rect kBounds{0, 0, 800, 600};

bool inside(const Rect& r) {
  return r.x >= 0 && r.y >= 0 && r.x + r.width <= kBounds.width && r.y + r.height <= kBounds.height;
}

}  // namespace

TEST_CASE("no two labels overlap, and none leaves the stage, however crowded it is") {
  int placed = 0, left_out = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    std::vector<LabelRequest> requests;
    Obstacles obstacles;
    obstacles.circles.push_back({400, 300, 220});
    obstacles.taken.push_back({300, 540, 200, 50});
    for (int i = 0; i < 30; ++i) {
      // A third of them in one small heap.
      const double spread = i % 3 == 0 ? 20 : 280;
      const float x = static_cast<float>(400 + random.between(-spread, spread)),
                  y = static_cast<float>(300 + random.between(-spread, spread));
      requests.push_back({x, y, 8, 34, 16, x - 400, y - 300, i > 6});
      obstacles.discs.push_back({x, y, 6});
    }
    const auto places = place_labels(requests, obstacles, kBounds);
    REQUIRE(places.size() == requests.size());
    for (std::size_t a = 0; a < places.size(); ++a) {
      if (!places[a]) {
        REQUIRE(requests[a].optional);
        ++left_out;
        continue;
      }
      ++placed;
      REQUIRE(inside(*places[a]));
      REQUIRE_FALSE(overlap(*places[a], obstacles.taken[0]));
      if (requests[a].optional) REQUIRE_FALSE(crosses(*places[a], obstacles.circles[0]));
      for (std::size_t b = 0; b < a; ++b)
        if (places[b]) REQUIRE_FALSE(overlap(*places[a], *places[b]));
    }
  }
  CHECK(placed > 600);   // most find a place
  CHECK(left_out > 10);  // and the heap really is too crowded for all
}

TEST_CASE("a free label stands where it would rather stand") {
  const LabelRequest request{400, 300, 8, 30, 14, 1, 0, false};
  const auto place = place_labels({&request, 1}, {}, kBounds)[0];
  REQUIRE(place);
  CHECK(place->x == doctest::Approx(408));
  CHECK(place->y + place->height / 2 == doctest::Approx(300));
}

TEST_CASE("a label at the stage's edge turns inwards") {
  const LabelRequest request{797, 300, 8, 60, 14, 1, 0, false};
  const auto place = place_labels({&request, 1}, {}, kBounds)[0];
  REQUIRE(place);
  CHECK(inside(*place));
}

TEST_CASE("whether a line passes through a label") {
  const Rect rect{10, 10, 20, 10};
  CHECK(crosses(rect, Obstacles::Segment{0, 15, 100, 15}));
  CHECK(crosses(rect, Obstacles::Segment{15, 12, 16, 13}));  // within
  CHECK(crosses(rect, Obstacles::Segment{20, -100, 20, 100}));
  CHECK_FALSE(crosses(rect, Obstacles::Segment{0, 25, 100, 25}));
  CHECK_FALSE(crosses(rect, Obstacles::Segment{0, 15, 5, 15}));  // it ends before
  CHECK_FALSE(crosses(rect, Obstacles::Segment{0, 30, 12, 21}));
  CHECK(crosses(rect, Obstacles::Circle{20, 115, 100}));
  CHECK_FALSE(crosses(rect, Obstacles::Circle{20, 15, 100}));  // the label is inside, the line is far
  CHECK_FALSE(crosses(rect, Obstacles::Circle{200, 15, 20}));
}

}  // namespace snug::app
