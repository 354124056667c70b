// Two trees against each other, node by node.
#include "lesson/subjects/tree/tree_pair.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/lesson/subjects/tree/stages.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/tree/entries.hpp"
#include "lesson/subjects/tree/tree_figures.hpp"

using namespace snug;
using namespace snug::lesson;
using namespace snug::test;

namespace {

/// A stage whose copy lies over it as often as beside it.
TreeStage any_pair_of_trees(std::uint64_t seed) {
  TreeStage stage = any_tree_stage(seed);
  Random random(seed + 77);
  stage.query->at[1] = stage.query->at[0] + Point2(random.between(-1.5, 1.5), random.between(-1.5, 1.5));
  return stage;
}

}  // namespace

TEST_CASE("two trees find the pairs that testing every pair of boxes finds") {
  std::size_t found = 0, left_out = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    const TreeStage stage = any_pair_of_trees(seed);
    const std::string_view rule = build_methods()[seed % build_methods().size()].name;
    const TreeRun run(kTwoTrees, stage.aabbs(), rule, *stage.query);
    REQUIRE(run.pairing() != nullptr);
    std::vector<NodePair> pairs = run.pairing()->found();
    std::sort(pairs.begin(), pairs.end());
    CHECK(pairs == pairs_one_by_one(stage.aabbs(), *stage.query));
    const PairState& end = run.pairing()->states.back();
    CHECK(end.waiting.empty());
    CHECK(end.left_out + end.box_tests == static_cast<std::int64_t>(stage.boxes.size() * stage.boxes.size()));
    const auto& done = std::get<hierarchy::Done>(run.trace().back().step.fact);
    CHECK(end.tests() == done.volume_tests);
    CHECK(end.visited == done.nodes);
    found += pairs.size(), left_out += static_cast<std::size_t>(end.left_out);
    const Method* method = find_method(query_methods(), kTwoTrees);
    REQUIRE(method != nullptr);
    for (const Proof& proof : tree_proofs({{Slot{method, &run}, Slot{}}, 0, run.steps()}, &*stage.query))
      CHECK_MESSAGE(proof.holds, proof.text);
  }
  CHECK(found > 1000);
  CHECK(left_out > 5000);
}

TEST_CASE("the pair on top of the stack is the one that is tested next") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const TreeStage stage = any_pair_of_trees(seed);
    const TreeRun run(kTwoTrees, stage.aabbs(), "top_down_median", *stage.query);
    const auto& states = run.pairing()->states;
    for (int step = 0; step + 1 < run.steps(); ++step) {
      REQUIRE_FALSE(states[step].waiting.empty());
      CHECK(states[step].waiting.back() == *states[step + 1].now);
      CHECK(states[step].waiting.back()[0] == run.branch_of(step));
    }
    CHECK_FALSE(states.back().now.has_value());
  }
}

TEST_CASE("sentences name the copy's boxes in small letters, and count the pairs that are left out") {
  TreeStage stage;
  for (const double x : {-2.0, -1.5, 1.0, 1.5}) stage.boxes.push_back({{x, 0}, {0.2, 0.2}});
  stage.query = QueryPlaces{{Point2(0, 0), Point2(2.5, 0.1)}};  // C's place is then taken by b, D's by none
  const TreeRun run(kTwoTrees, stage.aabbs(), "top_down_median", *stage.query);
  std::vector<std::string> said;
  for (int step = 0; step < run.steps(); ++step) said.push_back(run.sentence(step, {}));
  CHECK(said.front() == "The roots overlap, so each child of one node is paired with each child of the other.");
  CHECK(std::count(said.begin(), said.end(), "AB and ab are apart, so the 4 pairs of boxes below are left out.") == 1);
  CHECK(std::count(said.begin(), said.end(), "Boxes C and b are tested: they overlap.") == 1);
  CHECK(said.back().find("testing every pair of boxes takes 16") != std::string::npos);
}

TEST_CASE("whether two nodes are apart can be asked, and the model answer is right") {
  int apart = 0, overlap = 0;
  for (std::uint64_t seed = 1; seed < 30; ++seed) {
    const TreeStage stage = any_pair_of_trees(seed);
    Lesson lesson = tree_lesson_on(stage, kTreeQuery);
    lesson.algorithms = {std::string(kTwoTrees)};
    for (int nth = 1; nth < 4; ++nth) {
      Question& question = lesson.questions.emplace_back();
      question.id = "apart" + std::to_string(nth);
      question.gate = {std::string(kTwoTrees), "pair_tested", nth, ""};
      question.asks = "apart";
    }
    auto session = Session::open(std::move(lesson));
    REQUIRE(session.has_value());
    for (const Asked& asked : session->conversation().questions()) {
      const auto& fact =
          std::get<hierarchy::PairTested>(tree_run(session->player().run(0)).trace()[asked.fact].step.fact);
      ++(fact.overlap ? overlap : apart);
      CHECK(model_answer(asked, session->player().run(0)) == Answer(OneChoice{fact.overlap ? kNo : kYes}));
    }
  }
  CHECK(apart > 5);
  CHECK(overlap > 5);
}
