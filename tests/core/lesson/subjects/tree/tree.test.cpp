// Trees of boxes in a lesson: how they grow, what queries do in them, and what is asked about both.
#include "lesson/subjects/tree/tree.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "core/lesson/subjects/tree/stages.hpp"
#include "hierarchy/cost.hpp"
#include "hierarchy/cull.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/tree/entries.hpp"
#include "lesson/subjects/tree/tree_figures.hpp"

using namespace snug;
using namespace snug::lesson;
using namespace snug::test;

TEST_CASE("step by step, each way to build grows into the tree that it builds") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const std::vector<Box2> boxes = any_tree_stage(seed).aabbs();
    for (const Method& method : build_methods()) {
      CAPTURE(seed);
      CAPTURE(method.name);
      const TreeRun run(method.name, boxes);
      const TreeOfBoxes tree = build_tree(method.name, boxes);
      CHECK(tree_nodes_of(run.forest(run.steps())) == tree_nodes_of(forest_of(tree, boxes)));
      for (int step = 0; step <= run.steps(); ++step) {
        const Forest& forest = run.forest(step);
        std::set<Index> below;
        for (const Index root : forest.roots)
          for (const Index box : forest.at(root).boxes) CHECK(below.insert(box).second);
        for (const Index i : forest.there())
          for (const Index box : forest.at(i).boxes) {
            CHECK((forest.at(i).box.min.array() <= boxes[box].min.array()).all());
            CHECK((forest.at(i).box.max.array() >= boxes[box].max.array()).all());
          }
        if (run.way() != Growth::Way::kInserting) CHECK(below.size() == boxes.size());
      }
    }
  }
}

TEST_CASE("the figures at the end are the tree's own") {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const TreeStage stage = any_tree_stage(seed);
    Session session = tree_session_on(stage, kTreeBuild);
    for (const Method& method : build_methods()) {
      REQUIRE(session.player().choose(0, method.name).has_value());
      session.last();
      const TreeOfBoxes tree = build_tree(method.name, stage.aabbs());
      CHECK(tree_figure(session, "nodes") == static_cast<double>(tree.nodes.size()));
      CHECK(tree_figure(session, "depth") == tree.depth());
      REQUIRE(session.player().proofs().size() == 1);
      CHECK(session.player().proofs().front().holds);
      if (method.name == "top_down_median") CHECK(tree_figure(session, "of_median") == 100);
    }
  }
}

TEST_CASE("a query through any tree finds what testing each box finds, and its state is what its steps say") {
  int missed = 0, found = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const TreeStage stage = any_tree_stage(seed);
    const std::vector<Box2> boxes = stage.aabbs();
    const Method& rule = build_methods()[seed % build_methods().size()];
    for (const Method& method : plain_queries()) {
      CAPTURE(seed);
      CAPTURE(method.name);
      const TreeRun run(method.name, boxes, rule.name, *stage.query);
      const QueryState& end = run.state(run.steps());
      const std::vector<Index> one_by_one = found_one_by_one(method.name, *stage.query, boxes);
      if (!finds_first(method.name)) {
        CHECK(run.result().found == one_by_one);
        CHECK(end.found() == one_by_one);
      } else {
        CHECK(run.result().found == one_by_one);
      }
      CHECK(end.visited == run.result().counts.nodes_visited);
      CHECK(end.node_tests == run.result().counts.node_tests);
      CHECK(end.box_tests == run.result().counts.body_tests);
      CHECK(end.waiting.empty());
      for (const Met met : end.boxes) CHECK(met != Met::kOpen);
      for (const Index box : one_by_one)
        if (!finds_first(method.name)) CHECK((end.boxes[box] == Met::kMet || end.boxes[box] == Met::kTaken));
      missed += static_cast<int>(std::count(end.boxes.begin(), end.boxes.end(), Met::kUnder));
      found += static_cast<int>(one_by_one.size());
    }
  }
  CHECK(missed > 1000);
  CHECK(found > 1000);
}

TEST_CASE("the stack's top is the node that is tested next, but for what lies beyond the first box") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const TreeStage stage = any_tree_stage(seed);
    for (const Method& method : plain_queries()) {
      if (finds_first(method.name)) continue;
      const TreeRun run(method.name, stage.aabbs(), "insertion", *stage.query);
      for (int step = 0; step + 1 < run.steps(); ++step) {
        REQUIRE_FALSE(run.state(step).waiting.empty());
        CHECK(run.state(step).waiting.back() == run.branch_of(step));
      }
    }
  }
}

TEST_CASE("a frustum goes through the tree as hierarchy::cull does") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const TreeStage stage = any_tree_stage(seed);
    const std::vector<Box2> boxes = stage.aabbs();
    const TreeOfBoxes tree = build_tree("top_down_sah", boxes);
    const auto result = run_query("frustum_query", *stage.query, tree, boxes);
    std::vector<Index> seen;
    const auto culled = hierarchy::cull(tree, boxes, frustum_of(*stage.query).value(),
                                        [&](Index box, query::Culling) { seen.push_back(box); });
    std::sort(seen.begin(), seen.end());
    CHECK(result.found == seen);
    CHECK(result.counts.volume_tests() == culled.counts.volume_tests());
    CHECK(result.planes_tested == culled.planes_tested);
    // Its outline is that of its planes.
    const auto frustum = frustum_of(*stage.query);
    for (const Point2& corner : corners_of_query(*stage.query))
      for (const auto& plane : frustum->planes())
        CHECK(plane.normal.dot(corner) + plane.d < 1e-12 * (1 + corner.norm()));
  }
}

TEST_CASE("merged volumes are of the kind, hold what is below, and lose nothing where they are AABBs") {
  double circles = 0, boxes_lost = 0;
  for (std::uint64_t seed = 1; seed < 60; ++seed) {
    const TreeStage then = any_tree_stage(seed), now = any_tree_stage(seed + 100);
    TreeStage stage = then;
    stage.query.reset();
    for (const HeldBox& box : then.boxes) stage.built.push_back(box.center);
    for (std::size_t i = 0; i < stage.boxes.size(); ++i) stage.boxes[i].center = now.boxes[i % now.boxes.size()].center;
    for (const Method& method : update_methods()) {
      CAPTURE(seed);
      CAPTURE(method.name);
      const TreeRun run(method.name, stage.aabbs(), stage.aabbs_built());
      CHECK(run.cost_built() ==
            doctest::Approx(hierarchy::expected_cost(build_tree("top_down_sah", stage.aabbs_built()))));
      const View view{{Slot{&method, &run}, Slot{}}, 0, run.steps()};
      for (const Proof& proof : tree_proofs(view, nullptr)) CHECK_MESSAGE(proof.holds, proof.text);
      if (!merges(method.name)) {
        CHECK(run.cost() == hierarchy::expected_cost(build_tree("top_down_sah", stage.aabbs())));
        continue;
      }
      REQUIRE(run.steps() == static_cast<int>(run.tree().nodes.size()) + 1);
      const TreeOfBoxes refit = refitted(build_tree("top_down_sah", stage.aabbs_built()), stage.aabbs());
      CHECK(run.cost() == hierarchy::expected_cost(refit));
      for (std::size_t i = 0; i < run.tree().nodes.size(); ++i) {
        const auto node = static_cast<Index>(i);
        CHECK(run.has_volume(node, run.steps() - 1 - static_cast<int>(i)));
        CHECK_FALSE(run.has_volume(node, run.steps() - 2 - static_cast<int>(i)));
        const double loss = merging_loss(run, node);
        CHECK(loss >= 0);
        if (method.name == "merge_aabb") CHECK(loss == 0);
        if (method.name == "merge_sphere") circles = std::max(circles, loss);
        if (method.name == "merge_obb") boxes_lost = std::max(boxes_lost, loss);
      }
    }
  }
  CHECK(circles > 0.1);
  CHECK(boxes_lost > 0.1);
}

TEST_CASE("the pair that is merged is the smallest of all, and the question says so") {
  int asked_of = 0;
  for (std::uint64_t seed = 1; seed < 40; ++seed) {
    const TreeStage stage = any_tree_stage(seed);
    if (stage.boxes.size() < 4) continue;
    Lesson lesson = tree_lesson_on(stage, kTreeBuild);
    for (int nth = 1; nth + 1 < static_cast<int>(stage.boxes.size()); ++nth) {
      Question& question = lesson.questions.emplace_back();
      question.id = "pair" + std::to_string(nth);
      question.gate = {"bottom_up", "nodes_merged", nth, ""};
      question.asks = "pair";
    }
    auto session = Session::open(std::move(lesson));
    REQUIRE(session.has_value());
    REQUIRE(session->player().choose(0, "bottom_up").has_value());
    for (const Asked& asked : session->conversation().questions()) {
      const Forest& forest = tree_run(session->player().run(0)).forest(asked.fact);
      double least = 1e9;
      for (const Index a : forest.roots)
        for (const Index b : forest.roots)
          if (a != b) {
            const Box2 &one = forest.at(a).box, &two = forest.at(b).box;
            least = std::min(least, (one.max.cwiseMax(two.max) - one.min.cwiseMin(two.min)).sum());
          }
      const auto& fact =
          std::get<hierarchy::NodesMerged>(tree_run(session->player().run(0)).trace()[asked.fact].step.fact);
      CHECK(fact.area == doctest::Approx(least));
      CHECK(asked.choices.size() >= 3);
      const Outcome outcome = judge(asked, model_answer(asked, session->player().run(0)), session->player().run(0));
      CHECK(outcome.right);
      ++asked_of;
    }
  }
  CHECK(asked_of > 100);
}

TEST_CASE("a tree by hand: mergers of any two groups, with the cost of the same tree built from the leaves up") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const std::vector<Box2> boxes = any_tree_stage(seed).aabbs();
    TreeTrace trace;
    const TreeOfBoxes tree = build_tree("bottom_up", boxes, &trace);
    std::vector<HandPair> pairs;
    for (const auto& entry : trace)
      if (const auto* fact = std::get_if<hierarchy::NodesMerged>(&entry.step.fact))
        pairs.push_back({fact->left, fact->right});
    const TreeRun whole(boxes, pairs);
    CHECK(whole.is_whole());
    CHECK(whole.cost() == hierarchy::expected_cost(tree));
    CHECK(tree_nodes_of(whole.forest(whole.steps())) == tree_nodes_of(forest_of(tree, boxes)));
    pairs.pop_back();
    const TreeRun part(boxes, pairs);
    CHECK_FALSE(part.is_whole());
    CHECK(part.forest(part.steps()).roots.size() == 2);
    CHECK(groups_left(boxes.size(), pairs)->size() == 2);
  }
  CHECK(groups_left(3, std::vector<HandPair>{{0, 1}, {2, 3}})->size() == 1);
  for (const HandPair& wrong : {HandPair{0, 0}, HandPair{0, 3}, HandPair{-1, 1}})
    CHECK_FALSE(groups_left(3, std::vector<HandPair>{wrong}).has_value());
  CHECK_FALSE(groups_left(3, std::vector<HandPair>{{0, 1}, {0, 2}}).has_value());
}

TEST_CASE("boxes are moved, sized, scattered, undone and kept as rows") {
  const TreeStage stage = any_tree_stage(11);
  Session session = tree_session_on(stage, kTreeQuery);
  const Rows own = session.stage().subject().rows();
  REQUIRE(own.size() == stage.boxes.size() + 1);
  CHECK(session.stage().subject().name_of(0) == "A");
  CHECK(session.stage().subject().name_of(session.stage().subject().size() - 2) == "Q");
  CHECK(session.stage().subject().name_of(session.stage().subject().size() - 1) == "R");
  REQUIRE(session.stage().move(0, {1, 2, 0}).has_value());
  CHECK(session.stage().subject().at(0) == Point3(1, 2, 0));
  const std::array<double, 2> half{0.5, 0.25};
  REQUIRE(session.stage().set_numbers(0, 1, half).has_value());
  REQUIRE(session.stage().move(session.stage().subject().size() - 1, {-3, 0.5, 0}).has_value());
  const Rows edited = session.stage().subject().rows();
  CHECK(edited[0] == std::vector<double>{1, 2, 0.5, 0.25});
  session.stage().scatter(5);
  CHECK(session.stage().subject().rows() != edited);
  CHECK(session.stage().subject().rows().back() == own.back());
  session.stage().undo();
  CHECK(session.stage().subject().rows() == edited);
  for (int i = 0; i < 3; ++i) session.stage().undo();
  CHECK(session.stage().subject().rows() == own);
  REQUIRE(session.stage().set_rows(edited).has_value());
  CHECK(session.stage().subject().rows() == edited);
  CHECK_FALSE(session.stage().subject().drives().empty());
}

TEST_CASE("what is no stage is refused, and nothing changes") {
  Session session = tree_session_on(any_tree_stage(11), kTreeQuery);
  const Rows own = session.stage().subject().rows();
  Rows few{own[0], own.back()}, negative = own, long_row = own, one_place = own;
  negative[0][2] = -0.1;
  long_row[0].push_back(1);
  one_place.back() = {1, 1, 1, 1};
  for (const Rows& rows : {few, negative, long_row, one_place, Rows{}})
    CHECK_FALSE(session.stage().set_rows(rows).has_value());
  CHECK_FALSE(session.stage()
                  .move(session.stage().subject().size() - 1,
                        session.stage().subject().at(session.stage().subject().size() - 2))
                  .has_value());
  CHECK_FALSE(session.stage().move(0, {std::nan(""), 0, 0}).has_value());
  CHECK_FALSE(session.stage().add({0, 0, 0}).has_value());
  CHECK(session.stage().subject().rows() == own);
}
