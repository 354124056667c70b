// A tree's panels and its place on the stage.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "../../bench.hpp"

namespace snug::app {
namespace {

lesson::Lesson queried(const std::string& algorithm) {
  const std::string text =
      "version = 2\ntitle = \"Rays\"\nsummary = \"Rays.\"\nminutes = 1\nvolume = \"bvh_query\"\nalgorithms = [\"" +
      algorithm +
      "\"]\n[objects]\ncenter = [[-2, 0.8], [-1.2, -0.4], [-0.4, 0.6], [0.6, -0.7]]\nhalf_extents = [[0.25, 0.2]]\n"
      "[query]\nfrom = [-2.1, 0.9]\nto = [1.3, -1]\n[[section]]\ntitle = \"One\"\ntext = \"A text.\"\n";
  auto lesson = lesson::read_lesson(text, "rays.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  return *std::move(lesson);
}

bool says(const std::vector<std::string>& words, std::string_view what) {
  return std::any_of(words.begin(), words.end(),
                     [&](const std::string& one) { return one.find(what) != std::string::npos; });
}

}  // namespace

TEST_CASE("while a choice of the ray's order is due, its figures are no final result") {
  const Layout layout{{0, 0, 628, 616}, {0, 616, 628, 136}, {628, 0, 280, 752}};
  Bench bench(queried("ray_by_hand"), layout);
  bench.session().last();
  const std::vector<std::string> due = bench.words();
  REQUIRE(says(due, "Which child comes next?"));
  CHECK(says(due, "So far: the next choice is yours"));
  CHECK_FALSE(says(due, "Final result"));

  Bench done(queried("ray_nearest"), layout);
  done.session().last();
  CHECK(says(done.words(), "Final result"));
}

TEST_CASE("a point query has one place on the stage, and every other query two") {
  for (const char* const algorithm : {"point_query", "box_query", "ray_query", "frustum_query"}) {
    CAPTURE(algorithm);
    Bench bench(queried(algorithm));
    const std::vector<Handle> handles = bench.app.handles();
    const auto has = [&](std::string_view id) {
      return std::any_of(handles.begin(), handles.end(), [&](const Handle& handle) { return handle.id == id; });
    };
    CHECK(has("Q"));
    CHECK(has("R") == (std::string_view(algorithm) != "point_query"));
    const std::vector<std::string> words = bench.words();
    CHECK((std::find(words.begin(), words.end(), "R") != words.end()) == has("R"));
  }
}

TEST_CASE("on a stage that is much wider than high the tree stands beside the boxes") {
  // A leaf and its box have the same letter: of both, the highest and the leftmost are looked at.
  const auto spread = [](const Layout& layout) {
    Bench bench(queried("point_query"), layout);
    bench.session().jump(0);
    std::vector<DrawnWords> drawn;
    bench.app.note_words(&drawn);
    bench.frames(2);
    bench.app.note_words(nullptr);
    ImVec2 low{1e9f, 1e9f}, high{-1e9f, -1e9f};
    for (const DrawnWords& one : drawn)
      if (one.words.size() == 1 && one.words[0] >= 'A' && one.words[0] <= 'D') {
        low = {std::min(low.x, one.low.x), std::min(low.y, one.low.y)};
        high = {std::max(high.x, one.high.x), std::max(high.y, one.high.y)};
      }
    return ImVec2{high.x - low.x, high.y - low.y};
  };
  const ImVec2 lying = spread({{0, 0, 506, 206}, {0, 246, 506, 96}, {}, true, 56});
  CHECK(lying.x > 1.6f * lying.y);
  const ImVec2 usual = spread({{0, 0, 628, 616}, {0, 616, 628, 136}});
  CHECK(usual.x < 1.3f * usual.y);
}

}  // namespace snug::app
