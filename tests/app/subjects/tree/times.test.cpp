// The panel of what building costs, once a way has been timed.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../../bench.hpp"
#include "../../course_lessons.hpp"

namespace snug::app {
namespace {

constexpr Layout kBesideStage{{0, 0, 628, 616}, {0, 616, 628, 136}, {628, 0, 280, 752}, false, 88};

}  // namespace

TEST_CASE("no title stands over what its way costs") {
  Bench bench(course_lesson("bvh-build", false), kBesideStage);
  for (const char* const way : {"top_down_median", "top_down_sah", "bottom_up", "insertion"}) {
    CAPTURE(way);
    REQUIRE(bench.session().player().choose(0, way).has_value());
    bench.session().go(bench.session().player().steps());
    bench.frames(30);  // it is timed once the view has been still
    const std::vector<DrawnWords> drawn = bench.drawn_words();
    const std::string title(bench.session().player().method(0)->title);
    bool timed = false;
    for (const DrawnWords& words : drawn) {
      if (words.words != title || words.low.x < 628) continue;
      for (const DrawnWords& other : drawn) {
        if (other.low.x <= words.low.x + 1 || std::abs(other.low.y - words.low.y) > 6) continue;
        timed = true;
        CHECK(other.low.x > words.high.x);
      }
    }
    CHECK(timed);
  }
}

}  // namespace snug::app
