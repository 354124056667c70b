// What trees are expected to cost, against lines drawn by chance, and the prices of splits against splits made.
#include "hierarchy/cost.hpp"

#include <numbers>

#include "core/hierarchy/scenes.hpp"
#include "trace/observer.hpp"

using namespace snug;

namespace {

using FlatBox = Aabb<double, 2>;
using FlatPoint = Vector<double, 2>;

/// Whether the line of all p with normal . p = offset meets the box.
bool meets(const FlatBox& box, const FlatPoint& normal, double offset) {
  const FlatPoint middle = (box.min + box.max) / 2, half = (box.max - box.min) / 2;
  return std::abs(normal.dot(middle) - offset) <= normal.cwiseAbs().dot(half);
}

double half_perimeter(const std::vector<Index>& bodies, const std::vector<FlatBox>& boxes) {
  FlatBox all = boxes[bodies.front()];
  for (const Index body : bodies) all = {all.min.cwiseMin(boxes[body].min), all.max.cwiseMax(boxes[body].max)};
  return (all.max - all.min).sum();
}

}  // namespace

TEST_CASE("the expected cost is the mean cost of lines that meet the root") {
  const auto boxes = test::spread<double, 2>(12, 9, 6);
  for (const auto& tree :
       {hierarchy::build_median<FlatBox>(boxes, {1}), hierarchy::build_surface_area<FlatBox>(boxes, {3})}) {
    const FlatBox root = tree.nodes[0].volume;
    const FlatPoint middle = (root.min + root.max) / 2;
    const double reach = (root.max - root.min).norm() / 2;
    Random random(3);
    double tests = 0;
    int lines = 0;
    for (int i = 0; i < 400000; ++i) {
      const double angle = random.between(0, 2 * std::numbers::pi);
      const FlatPoint normal(std::cos(angle), std::sin(angle));
      const double offset = normal.dot(middle) + random.between(-reach, reach);
      if (!meets(root, normal, offset)) continue;
      ++lines;
      for (const auto& node : tree.nodes)
        if (meets(node.volume, normal, offset)) tests += static_cast<double>(node.is_leaf() ? node.count : 2);
    }
    CHECK(tests / lines == doctest::Approx(hierarchy::expected_cost(tree)).epsilon(0.01));
  }
}

TEST_CASE("a tree of boxes in one place, and one of nothing, have a cost as well") {
  const std::vector<FlatBox> points(4, FlatBox{{1, 1}, {1, 1}});
  CHECK(hierarchy::expected_cost(hierarchy::build_median<FlatBox>(points, {1})) == 2 * 3 + 4);
  CHECK(hierarchy::expected_cost(hierarchy::build_median<FlatBox>(std::vector<FlatBox>{})) == 0);
}

TEST_CASE("the prices of splits are those of the boxes on either side, and the least is taken") {
  int priced = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto boxes = test::spread<double, 2>(3 + static_cast<int>(seed % 12), seed, 5);
    Recorder<hierarchy::Step> steps;
    const auto tree = hierarchy::build_surface_area<FlatBox>(boxes, {1}, steps);
    const hierarchy::SplitsPriced* prices = nullptr;
    for (const auto& entry : steps.entries) {
      const auto* split = std::get_if<hierarchy::SplitChosen>(&entry.step.fact);
      if (const auto* fact = std::get_if<hierarchy::SplitsPriced>(&entry.step.fact)) prices = fact;
      if (split == nullptr || split->axis == kNoIndex) continue;
      REQUIRE(prices != nullptr);
      REQUIRE(prices->node == split->node);
      CHECK(prices->axis == split->axis);
      CHECK(prices->cost_at(prices->axis, prices->border) == split->cost);
      CHECK(prices->position(prices->axis, prices->border) == doctest::Approx(split->position));
      const auto below = tree.bodies_below(split->node);
      const std::vector<Index> bodies(below.begin(), below.end());
      for (const int axis : {0, 1})
        for (int border = 1; border <= prices->borders(); ++border) {
          const double cost = prices->cost_at(axis, border);
          CHECK(cost >= split->cost);
          std::array<std::vector<Index>, 2> sides;
          for (const Index body : bodies)
            sides[(boxes[body].min[axis] + boxes[body].max[axis]) / 2 < prices->position(axis, border) ? 0 : 1]
                .push_back(body);
          if (sides[0].empty() || sides[1].empty()) continue;
          const double expected = 2 + (half_perimeter(sides[0], boxes) * static_cast<double>(sides[0].size()) +
                                       half_perimeter(sides[1], boxes) * static_cast<double>(sides[1].size())) /
                                          half_perimeter(bodies, boxes);
          CHECK(cost == doctest::Approx(expected));
          ++priced;
        }
      prices = nullptr;
    }
  }
  CHECK(priced > 1000);
}
