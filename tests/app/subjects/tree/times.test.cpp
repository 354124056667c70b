// The panel of what building costs, once a way has been timed.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "../../bench.hpp"

namespace snug::app {
namespace {

constexpr Layout kBesideStage{{0, 0, 628, 616}, {0, 616, 628, 136}, {628, 0, 280, 752}, false, 88};

lesson::Lesson building_lesson() {
  std::ifstream file(lessons_folder() + "bvh-build.toml", std::ios::binary);
  const std::string toml{std::istreambuf_iterator<char>(file), {}};
  auto lesson = lesson::read_lesson(toml, "bvh-build.toml", lesson::Checked::kAsWritten);
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  lesson->questions.clear();
  return *std::move(lesson);
}

}  // namespace

TEST_CASE("no title stands over what its way costs") {
  Bench bench(building_lesson(), kBesideStage);
  for (const char* const way : {"top_down_median", "top_down_sah", "bottom_up", "insertion"}) {
    CAPTURE(way);
    REQUIRE(bench.session().choose(0, way).has_value());
    bench.session().go(bench.session().steps());
    bench.frames(30);  // it is timed once the view has been still
    std::vector<DrawnWords> drawn;
    bench.app.note_words(&drawn);
    bench.frames(1);
    bench.app.note_words(nullptr);
    const std::string title(bench.session().method(0)->title);
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
