// What the panel beside an update says of its cost and of its looseness over a turn, and what it keeps to itself.
#include "app/subjects/update/turn_panel.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "../../bench.hpp"
#include "../../viewed_lessons.hpp"
#include "lesson/subjects.hpp"

namespace snug::app {
namespace {

constexpr Layout kPanelBeside{{0, 0, 800, 440}, {0, 440, 800, 160}, {800, 0, 300, 1200}};

lesson::Lesson update_of_body(std::string_view question = "") {
  return test::viewed("volume = \"update\"\nalgorithms = [\"rotated_box\", \"rebuild\", \"loose\"]",
                      "[points]\nlist = [[2, 0], [1, 1], [-1, 1], [-2, 0], [-1, -1], [1, -1], [0.1, 0]]\n[body]\n"
                      "turn = 40\n" +
                          std::string(question));
}

bool is_said(const std::vector<std::string>& words, const std::string& one) {
  return std::find(words.begin(), words.end(), one) != words.end();
}

}  // namespace

TEST_CASE("the panel of an update shows its looseness over a turn, and the points that each update examines") {
  Bench bench(update_of_body(), kPanelBeside);
  const auto words = bench.words();
  for (const char* due : {"Looseness over a whole turn", "−180°", "180°", "Points examined in this update", "7"})
    CHECK_MESSAGE(is_said(words, due), due);
}

TEST_CASE("while the cost and the looseness are to be predicted, the panel tells neither") {
  Bench bench(update_of_body(R"(
[[question]]
id = "order"
algorithm = "rotated_box"
before = "volume_updated"
after = "start"
asks = "tightest_order"
prompt = "In which order?"
because = "So."
)"),
              kPanelBeside);
  CHECK_FALSE(is_said(bench.words(), "Looseness over a whole turn"));  // nor before it is asked
  bench.session().go(0);
  REQUIRE(bench.session().conversation().asked() != nullptr);
  CHECK_FALSE(is_said(bench.words(), "Looseness over a whole turn"));
  REQUIRE(bench.session().conversation().give({}, false));
  bench.session().last();
  CHECK(is_said(bench.words(), "Looseness over a whole turn"));
}

}  // namespace snug::app
