// What the stage shows of an update at each step, and what it keeps to itself while a question is open.
#include "app/subjects/update/shown.hpp"

#include <doctest/doctest.h>

#include "../../viewed_lessons.hpp"

namespace snug::app {
namespace {

lesson::Session climbing(std::string_view question = "") {
  lesson::Lesson lesson = test::viewed("volume = \"update\"\nalgorithms = [\"hill_climb\", \"rotated_box\", \"loose\"]",
                                       "[points]\nlist = [[2, 0], [1, 1], [-1, 1], [-2, 0], [-1, -1], [1, -1]]\n"
                                       "[body]\nturn = 50\n" +
                                           std::string(question));
  return *lesson::Session::open(std::move(lesson));
}

}  // namespace

TEST_CASE("a climb's way grows vertex by vertex, and each climb begins anew") {
  lesson::Session session = climbing();
  std::size_t longest = 0, bounds = 0;
  for (int step = 1; step <= session.player().steps(); ++step) {
    session.jump(step);
    const UpdateShown shown = update_shown_at(session);
    const auto& fact = shown.run->trace()[step - 1].step.fact;
    if (const auto* walk = std::get_if<fit::NeighborsCompared>(&fact)) {
      REQUIRE(shown.climb);
      CHECK(shown.climb->best == walk->best);
      if (!shown.climb->edges.empty()) CHECK(shown.climb->edges.back()[1] == walk->best);
      longest = std::max(longest, shown.climb->edges.size());
    }
    if (const auto* climbed = std::get_if<fit::ExtremeClimbed>(&fact)) {
      CHECK(shown.climb->over);
      CHECK(shown.climb->edges.size() == climbed->path.size() - 1);
      CHECK(shown.bounds.size() == ++bounds);
      CHECK(shown.bounds.back().fresh);
    }
    if (std::holds_alternative<lesson::VolumeUpdated>(fact)) CHECK((!shown.climb && shown.bounds.empty()));
  }
  CHECK(longest > 0);
  CHECK(bounds == 4);
}

TEST_CASE("a question about the next vertex shows where the climb is, and nothing of where it goes") {
  lesson::Session session = climbing(R"(
[[question]]
id = "next"
algorithm = "hill_climb"
before = "neighbors_compared"
asks = "point"
prompt = "Which is next?"
because = "It reaches farthest."
)");
  session.go(0);
  REQUIRE(session.conversation().asked() != nullptr);
  const UpdateShown shown = update_shown_at(session);
  REQUIRE(shown.climb);
  const auto& walk = *std::get_if<fit::NeighborsCompared>(&shown.run->trace()[0].step.fact);
  CHECK(shown.climb->vertex == walk.vertex);
  CHECK(shown.climb->best == walk.vertex);
  CHECK(shown.climb->neighbors.empty());
  CHECK(shown.climb->edges.empty());
}

TEST_CASE("both bounds of an axis are shown at once, and the sphere's point once it is known") {
  lesson::Session session = climbing();
  REQUIRE(session.player().choose(0, "rotated_box").has_value());
  session.jump(1);
  CHECK(update_shown_at(session).bounds.size() == 2);
  REQUIRE(session.player().choose(0, "loose").has_value());
  session.jump(1);
  CHECK(update_shown_at(session).farthest.has_value());
}

}  // namespace snug::app
