// A ray whose order the student chooses: which child comes next, and what that costs.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "core/lesson/lesson_files.hpp"
#include "core/lesson/subjects/tree/stages.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/tree/tree_figures.hpp"

using namespace snug;
using namespace snug::lesson;
using namespace snug::test;

namespace {

/// Answers every choice that is due by chance, until the ray is at its end.
std::vector<Index> choices_by_chance(const TreeStage& stage, std::uint64_t seed) {
  Random random(seed);
  std::vector<Index> choices;
  for (;;) {
    const TreeRun run(kRayByHand, stage.aabbs(), "top_down_median", *stage.query, choices);
    if (run.undecided() == kNoIndex) return choices;
    CHECK(run.result().chosen == choices.size());
    CHECK(run.result().found.empty());
    choices.push_back(static_cast<Index>(random.below(2)));
  }
}

}  // namespace

TEST_CASE("in any order the ray finds the same first box, and the order by distance takes as many tests as the rule") {
  int steered = 0, fewer = 0, more = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    const TreeStage stage = any_tree_stage(seed);
    const std::vector<Box2> boxes = stage.aabbs();
    const TreeRun near("ray_nearest", boxes, "top_down_median", *stage.query);
    const std::vector<Index> choices = choices_by_chance(stage, seed);
    const TreeRun run(kRayByHand, boxes, "top_down_median", *stage.query, choices);
    CHECK(run.result().found == found_one_by_one(kRayByHand, *stage.query, boxes));
    CHECK(run.result().found == near.result().found);
    CHECK(run.result().chosen == choices.size());
    const QueryState& end = run.state(run.steps());
    CHECK(end.visited == run.result().counts.nodes_visited);
    CHECK(end.tests() == run.result().counts.volume_tests());
    steered += !choices.empty();
    fewer += end.tests() < near.state(near.steps()).tests();
    more += end.tests() > near.state(near.steps()).tests();
  }
  CHECK(steered > 100);
  CHECK(more > 20);
  CHECK(fewer > 2);
}

TEST_CASE("where a choice is due the steps end, both children wait, and nothing is proved") {
  int due = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const TreeStage stage = any_tree_stage(seed);
    const TreeRun run(kRayByHand, stage.aabbs(), "top_down_median", *stage.query);
    if (run.undecided() == kNoIndex) continue;
    ++due;
    const auto& children = run.forest(0).at(run.undecided()).children;
    const QueryState& end = run.state(run.steps());
    for (const Index child : children) CHECK(end.nodes[child] == Met::kOpen);
    CHECK(end.waiting.size() >= 2);
    CHECK(run.sentence(run.steps() - 1, {}).find("choose which one comes next") != std::string::npos);
    const Method* method = find_method(query_methods(), kRayByHand);
    const View view{{Slot{method, &run}, Slot{}}, 0, run.steps()};
    CHECK(tree_proofs(view, &*stage.query).empty());
    for (const Figure& figure : tree_figures(view))
      if (figure.key.starts_with("of_")) CHECK_FALSE(figure.known);
  }
  CHECK(due > 20);
}

TEST_CASE("the order is kept in the rows, undone, and refused where it is none") {
  TreeStage stage = any_tree_stage(11);
  stage.order.emplace();
  Lesson lesson = tree_lesson_on(stage, kTreeQuery);
  auto session = Session::open(std::move(lesson));
  REQUIRE(session.has_value());
  const Rows own = session->stage().subject().rows();
  REQUIRE(own.size() == stage.row_of_order() + 1);
  CHECK(own.back() == std::vector<double>{0});
  Rows steered = own;
  steered.back() = {2, 1, 0};
  REQUIRE(session->stage().set_rows(steered).has_value());
  CHECK(session->stage().subject().rows() == steered);
  session->stage().undo();
  CHECK(session->stage().subject().rows() == own);
  for (const std::vector<double>& wrong : {std::vector<double>{}, {1}, {1, 2}, {2, 1}, {1, 0.5}}) {
    Rows rows = own;
    rows.back() = wrong;
    CHECK_FALSE(session->stage().set_rows(rows).has_value());
  }
  CHECK(session->stage().subject().rows() == own);
}

TEST_CASE("a task that leaves a point alone to be moved is passed by an order, and by the point's typed place") {
  Session session = session_of("bvh-traverse");
  constexpr std::size_t kOrderTask = 2, kPointTask = 0;
  session.stage().start_task(kOrderTask);
  Rows steered = session.stage().subject().rows();
  steered.back() = {2, 0, 0};
  REQUIRE(session.stage().set_rows(steered).has_value());
  CHECK(session.grade(kOrderTask).done);

  const auto type = [&](std::string_view drive, std::size_t row, const std::array<double, 2>& values) {
    const std::vector<NumberGroup> groups = session.stage().subject().numbers();
    for (std::size_t i = 0; i < groups.size(); ++i)
      if (groups[i].drive == drive) REQUIRE(session.stage().set_numbers(i, row, values).has_value());
  };
  session.stage().start_task(kPointTask);
  type("Q", 0, {-0.6, 0.9});
  CHECK(session.grade(kPointTask).done);
  session.stage().start_task(kPointTask);
  type("A", 1, {0.01, 0.01});  // a half extent, which has no handle
  type("Q", 0, {-0.6, 0.9});
  CHECK_FALSE(session.grade(kPointTask).done);
}
