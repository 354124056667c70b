// Trees whose nodes have circles or oriented boxes, and how long it takes to build and to refit.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/lesson/subjects/tree/stages.hpp"
#include "geometry/random.hpp"
#include "hierarchy/cost.hpp"
#include "lesson/subjects/tree/tree_figures.hpp"

using namespace snug;
using namespace snug::lesson;
using namespace snug::test;

namespace {

double ticks() {
  static double now = 0;
  return now += 2e6;
}

/// How many tests lines at random make in a tree: by shooting them.
double tests_by_shooting(const Forest& forest, int lines) {
  Random random(5);
  double tests = 0;
  for (int i = 0; i < lines; ++i) {
    const double angle = random.between(0, std::numbers::pi), offset = random.between(-8, 8);
    const Point2 normal(std::cos(angle), std::sin(angle));
    for (const Index node : forest.there()) {
      const Branch& branch = forest.at(node);
      double center = 0, reach = 0;
      if (const auto* circle = std::get_if<Sphere<double, 2>>(&branch.volume))
        center = normal.dot(circle->center), reach = circle->radius;
      else if (const auto* box = std::get_if<Obb<double, 2>>(&branch.volume))
        center = normal.dot(box->center), reach = (box->axes.transpose() * normal).cwiseAbs().dot(box->half_extents);
      else {
        const Box2& own = std::get<Box2>(branch.volume);
        center = normal.dot((own.min + own.max) / 2), reach = normal.cwiseAbs().dot((own.max - own.min) / 2);
      }
      if (std::abs(center - offset) <= reach) tests += branch.divides() ? 2 : 1;
    }
  }
  return tests;
}

}  // namespace

TEST_CASE("whatever its nodes have around them, a tree has the same shape, and each volume contains what is below") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const TreeStage stage = any_tree_stage(seed);
    for (const Method& method : build_methods())
      for (const NodeKind kind : {NodeKind::kAabb, NodeKind::kSphere, NodeKind::kObb}) {
        CAPTURE(seed);
        CAPTURE(method.name);
        const TreeRun plain(method.name, stage.aabbs()), run(method.name, stage.aabbs(), kind);
        CHECK(tree_nodes_of(run.forest(run.steps())) == tree_nodes_of(plain.forest(plain.steps())));
        CHECK(run.hash() == plain.hash());
        const View view{{Slot{&method, &run}, Slot{}}, 0, run.steps()};
        REQUIRE(tree_proofs(view, nullptr).size() == 1);
        CHECK(tree_proofs(view, nullptr).front().holds);
        for (const Index node : run.forest(run.steps()).there())
          CHECK(run.forest(run.steps()).at(node).volume.index() == static_cast<std::size_t>(kind));
        // However the steps were followed, the volumes at the end are those of the whole tree.
        if (run.way() != Growth::Way::kInserting)
          CHECK(run.cost() == doctest::Approx(expected_cost(run.forest(run.steps()))));
      }
  }
}

TEST_CASE("the cost by the nodes' own perimeters is that of the heuristic where they are AABBs") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const std::vector<Box2> boxes = any_tree_stage(seed).aabbs();
    const TreeOfBoxes tree = build_tree("top_down_sah", boxes);
    CHECK(expected_cost(forest_of(tree, boxes)) == doctest::Approx(hierarchy::expected_cost(tree)));
    CHECK(tests_of_lines(forest_of(tree, boxes), forest_of(tree, boxes)) == 1);
  }
}

TEST_CASE("lines at random make as many more tests in circles and oriented boxes as their perimeters say") {
  for (const std::uint64_t seed : {3u, 8u}) {
    const std::vector<Box2> boxes = any_tree_stage(seed).aabbs();
    const TreeOfBoxes tree = build_tree("top_down_median", boxes);
    const Forest plain = forest_of(tree, boxes);
    for (const NodeKind kind : {NodeKind::kSphere, NodeKind::kObb}) {
      const Forest other = forest_of(tree, boxes, kind);
      const double shot = tests_by_shooting(other, 40000) / tests_by_shooting(plain, 40000);
      CHECK(tests_of_lines(other, plain) == doctest::Approx(shot).epsilon(0.03));
    }
  }
}

TEST_CASE("crowds move with their boxes, are built and refitted, and are timed only by a clock") {
  const std::vector<Box2> boxes = any_tree_stage(4).aabbs();
  std::vector<Box2> moved = boxes;
  const Point2 way(3, -2);
  moved[1] = {moved[1].min + way, moved[1].max + way};
  const std::vector<Box2> crowd = crowd_of(boxes), after = crowd_of(moved);
  REQUIRE(crowd.size() == kCrowd);
  for (std::size_t i = 0; i < crowd.size(); ++i) {
    const Point2 own = i % boxes.size() == 1 ? way : Point2(0, 0);
    CHECK((after[i].min - crowd[i].min - own).norm() < 1e-12);
  }
  for (const Method& method : build_methods()) {
    CHECK_FALSE(time_of_building(method.name, crowd, nullptr).ns.has_value());
    const TreeTime timed = time_of_building(method.name, crowd, &ticks);
    CHECK(*timed.ns == 2e6);
    CHECK(timed.cost > 2);
  }
  CHECK(time_of_refitting(crowd, crowd, nullptr).cost == time_of_building("top_down_sah", crowd, nullptr).cost);
  const TreeTime refitted = time_of_refitting(crowd, after, &ticks);
  CHECK(*refitted.ns == 2e6);
  CHECK(refitted.cost > time_of_building("top_down_sah", after, nullptr).cost);
}
