// Every tree of every builder holds each body once, and each node holds what is below it, exactly; after motion too.
#include "hierarchy/build.hpp"
#include "hierarchy/cost.hpp"
#include "hierarchy/insertion.hpp"

#include <set>

#include "core/hierarchy/scenes.hpp"
#include "core/query/volume_pairs.hpp"

using namespace snug;

namespace {

template <class VolumeType>
void check_all(const std::string& scene, const std::vector<VolumeType>& volumes, bool all_below) {
  for (const auto& named : test::all_trees(volumes)) {
    INFO(scene << ", " << named.name);
    test::check_shape(named.tree, volumes.size(), named.most_in_leaf);
    test::check_volumes(named.tree, volumes, all_below);
  }
}

template <class Scalar, int Dim>
void check_scenes() {
  for (const auto& scene : test::hard_scenes<Scalar, Dim>(100)) {
    check_all(scene.name, scene.boxes, true);
    check_all(scene.name, test::balls_of(scene.boxes), false);
  }
}

/// Number for number.
template <class VolumeType>
bool same(const hierarchy::Tree<VolumeType>& a, const hierarchy::Tree<VolumeType>& b) {
  const auto same_node = [](const auto& x, const auto& y) {
    return x.first == y.first && x.count == y.count && x.volume.min == y.volume.min && x.volume.max == y.volume.max;
  };
  return a.bodies == b.bodies && std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(), same_node);
}

}  // namespace

TEST_CASE_TEMPLATE("every builder's tree holds every body once, in nodes that hold it exactly", Scalar, float, double) {
  check_scenes<Scalar, 2>();
  check_scenes<Scalar, 3>();
}

TEST_CASE("trees over the other volumes hold them exactly") {
  test::VolumeMaker<double, 3> maker(3);
  const auto check_kind = [&]<class Kind>(std::size_t kind, const char* name, const Kind*) {
    std::vector<Kind> volumes;
    for (int i = 0; i < 24; ++i) {
      const auto how = i % 5 == 4 ? test::Make::kFlat : i % 7 == 6 ? test::Make::kPoint : test::Make::kSolid;
      auto volume = test::moved<double, 3>(maker.make(kind, how), 10 * maker.direction());
      volumes.push_back(*std::get_if<Kind>(&volume));
      if constexpr (std::is_same_v<Kind, Kdop<double, 3>>)
        volumes.back() = maker.kdop_of(14, {maker.any(9), maker.any(9)});
    }
    check_all(name, volumes, false);
  };
  check_kind(2, "obb", static_cast<const Obb<double, 3>*>(nullptr));
  check_kind(3, "capsule", static_cast<const Capsule<double, 3>*>(nullptr));
  check_kind(4, "lozenge", static_cast<const Lozenge<double, 3>*>(nullptr));
  check_kind(5, "kdop", static_cast<const Kdop<double, 3>*>(nullptr));
}

TEST_CASE("a tree of hulls holds every vertex exactly") {
  test::VolumeMaker<double, 3> maker(4);
  std::vector<ConvexHull<double, 3>> hulls;
  for (int i = 0; i < 6; ++i) {
    ConvexHull<double, 3> hull;
    const Vector<double, 3> middle = maker.any(9);
    for (int corner = 0; corner < 4; ++corner) hull.vertices.push_back(middle + maker.any());
    hulls.push_back(hull);
  }
  const auto tree = hierarchy::build_surface_area<ConvexHull<double, 3>>(hulls, {1});
  test::check_shape(tree, hulls.size(), 1);
  for (const auto& hull : hulls) CHECK(exact::holds(Volume<double, 3>(tree.nodes[0].volume), Volume<double, 3>(hull)));
}

TEST_CASE_TEMPLATE("a refitted tree holds its bodies exactly after they moved", Scalar, float, double) {
  auto boxes = test::spread<Scalar, 3>(300, 8, 10);
  auto trees = test::all_trees(boxes);
  auto balls = test::balls_of(boxes);
  auto ball_tree = hierarchy::build_surface_area<Sphere<Scalar, 3>>(balls);
  Random random(9);
  for (int frame = 0; frame < 5; ++frame) {
    for (auto& box : boxes) {
      const auto by = test::any_in<3>(random, -1, 1).template cast<Scalar>().eval();
      const auto low = (box.min + by).eval(), high = (box.max + by).eval();
      box.min = low, box.max = high;
    }
    for (auto& named : trees) {
      const auto bodies = named.tree.bodies;
      hierarchy::refit(named.tree, boxes);
      CHECK(named.tree.bodies == bodies);
      test::check_volumes(named.tree, boxes, true);
    }
    balls = test::balls_of(boxes);
    hierarchy::refit(ball_tree, balls);
    test::check_volumes(ball_tree, balls, false);
  }
  // If nothing moved, refitting makes what building made.
  auto tree = hierarchy::build_surface_area<Aabb<Scalar, 3>>(boxes);
  const auto before = tree;
  hierarchy::refit(tree, boxes);
  CHECK(same(tree, before));
}

TEST_CASE_TEMPLATE("trees stay shallow", Scalar, float, double) {
  const auto check_dim = []<int Dim>(std::integral_constant<int, Dim>) {
    for (const auto& scene : test::hard_scenes<Scalar, Dim>(1000)) {
      INFO(scene.name << ", dim " << Dim);
      CHECK(hierarchy::build_median<Aabb<Scalar, Dim>>(scene.boxes, {1}).depth() <= 11);
      // Half of a thousand sizes in a row fall to one side: deeper, but never without end.
      CHECK(hierarchy::build_surface_area<Aabb<Scalar, Dim>>(scene.boxes, {1}).depth() <=
            (scene.name == "each twice as far as the last" ? 51 : 40));
    }
    for (const char* name : {"all equal", "all one point", "points on an axis", "boxes on a line, in order",
                             "boxes on a line, backwards", "spread"})
      for (const auto& scene : test::hard_scenes<Scalar, Dim>(1000))
        if (scene.name == name) {
          CAPTURE(name);
          CHECK(hierarchy::build_by_insertion<Aabb<Scalar, Dim>>(scene.boxes).depth() <= 40);
          CHECK(hierarchy::build_bottom_up<Aabb<Scalar, Dim>>(scene.boxes).depth() <= 40);
        }
  };
  check_dim(std::integral_constant<int, 2>{});
  check_dim(std::integral_constant<int, 3>{});
}

TEST_CASE("from depth 40 on, too, a node of few bodies is a leaf") {
  constexpr Index kMostInLeaf = 4;
  for (const auto& scene : test::hard_scenes<double, 3>(1000)) {
    if (scene.name != "each twice as far as the last") continue;
    const auto tree = hierarchy::build_surface_area<Aabb<double, 3>>(scene.boxes, {kMostInLeaf});
    std::vector<int> depth(tree.nodes.size(), 0);
    int deep_leaves = 0;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      const auto& node = tree.nodes[i];
      const auto left = static_cast<std::size_t>(node.first);
      if (!node.is_leaf()) depth[left] = depth[left + 1] = depth[i] + 1;
      if (depth[i] < 40) continue;
      const auto bodies = std::ssize(tree.bodies_below(static_cast<Index>(i)));
      CHECK(node.is_leaf() == (bodies <= kMostInLeaf));
      deep_leaves += node.is_leaf() ? 1 : 0;
    }
    CHECK(deep_leaves > 10);
  }
}

TEST_CASE("bodies one inside of another are not put ever deeper: the next is beside what is no deeper than a limit") {
  std::vector<Aabb<double, 3>> nested;
  for (int i = 0; i < 2000; ++i)
    nested.push_back({Vector<double, 3>::Constant(i - 2000.), Vector<double, 3>::Constant(2000. - i)});
  const auto tree = hierarchy::build_by_insertion<Aabb<double, 3>>(nested);
  test::check_volumes(tree, nested, true);
  // The last one, innermost, hangs where it was put, and not below all others.
  std::vector<int> depth(tree.nodes.size(), 0);
  int of_last = -1;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const auto& node = tree.nodes[i];
    if (node.is_leaf()) {
      if (tree.bodies[node.first] == 1999) of_last = depth[i];
      continue;
    }
    const auto left = static_cast<std::size_t>(node.first);
    depth[left] = depth[left + 1] = depth[i] + 1;
  }
  CHECK(of_last > 0);
  CHECK(of_last <= hierarchy::kDeepestInsertion + 1);
}

TEST_CASE("bodies in one place are divided by index") {
  const std::vector<Aabb<double, 3>> boxes(8, Aabb<double, 3>{{1, 2, 3}, {2, 3, 4}});
  const auto tree = hierarchy::build_median<Aabb<double, 3>>(boxes, {1});
  CHECK(tree.bodies == std::vector<Index>{0, 1, 2, 3, 4, 5, 6, 7});
  CHECK(tree.nodes.size() == 15);
  // Near to one place, and told apart.
  std::vector<Aabb<double, 3>> near;
  for (int i = 0; i < 100; ++i) {
    const Vector<double, 3> low(1e-9 * (i % 7), 0, 0);
    near.push_back({low, low + Vector<double, 3>::Ones()});
  }
  CHECK(hierarchy::build_surface_area<Aabb<double, 3>>(near, {1}).depth() <= 9);
}

TEST_CASE("small scenes beside a far body are told apart") {
  // In floats a billionth of the scene would be one place, and the near bodies be divided by index.
  auto boxes = test::spread<double, 3>(2000, 5, 20);
  const double alone = hierarchy::expected_cost(hierarchy::build_surface_area<Aabb<double, 3>>(boxes));
  boxes.push_back({Vector<double, 3>::Constant(1e12), Vector<double, 3>::Constant(1e12 + 1)});
  auto tree = hierarchy::build_surface_area<Aabb<double, 3>>(boxes);
  boxes.back() = boxes.front();
  hierarchy::refit(tree, boxes);
  CHECK(hierarchy::expected_cost(tree) < 1.1 * alone);
}

TEST_CASE("surfaces are smaller than by the median where sizes differ") {
  Random random(6);
  std::vector<Aabb<float, 3>> boxes;
  for (int i = 0; i < 5000; ++i) {
    const double width = i % 20 == 0 ? 5 : 0.1;
    boxes.push_back(test::box_at<float, 3>(test::any_in<3>(random, 0, 50), test::any_in<3>(random, 0, width)));
  }
  const double median = hierarchy::expected_cost(hierarchy::build_median<Aabb<float, 3>>(boxes));
  CHECK(hierarchy::expected_cost(hierarchy::build_surface_area<Aabb<float, 3>>(boxes)) < 0.9 * median);
}

TEST_CASE("trees from the leaves up and by insertion come near those from the root down") {
  auto boxes = test::spread<float, 3>(1500, 6, 50);
  for (const bool in_order : {false, true}) {
    CAPTURE(in_order);
    if (in_order)
      std::sort(boxes.begin(), boxes.end(), [](const auto& a, const auto& b) { return a.min[0] < b.min[0]; });
    const double median = hierarchy::expected_cost(hierarchy::build_median<Aabb<float, 3>>(boxes, {1}));
    CHECK(hierarchy::expected_cost(hierarchy::build_bottom_up<Aabb<float, 3>>(boxes)) < 1.15 * median);
    CHECK(hierarchy::expected_cost(hierarchy::build_by_insertion<Aabb<float, 3>>(boxes)) < 1.15 * median);
  }
}

TEST_CASE("the nearest pairs are merged first: of any two groups left, the merged make the smallest box") {
  const auto boxes = test::spread<double, 3>(40, 7, 10);
  Recorder<hierarchy::Step> recorder;
  (void)hierarchy::build_bottom_up<Aabb<double, 3>>(boxes, recorder);
  std::vector<Aabb<double, 3>> groups = boxes;
  std::vector<bool> is_left(boxes.size(), true);
  const auto area = [](const Aabb<double, 3>& box) {
    const Vector<double, 3> d = box.max - box.min;
    return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
  };
  std::size_t merges = 0;
  for (const auto& entry : recorder.entries) {
    const auto* fact = std::get_if<hierarchy::NodesMerged>(&entry.step.fact);
    if (fact == nullptr) continue;
    ++merges;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < groups.size(); ++i)
      for (std::size_t j = i + 1; j < groups.size(); ++j)
        if (is_left[i] && is_left[j]) least = std::min(least, area(fit::merge(groups[i], groups[j])));
    const auto left = static_cast<std::size_t>(fact->left), right = static_cast<std::size_t>(fact->right);
    REQUIRE(is_left[left]);
    REQUIRE(is_left[right]);
    CHECK(static_cast<std::size_t>(fact->merged) == groups.size());
    groups.push_back(fit::merge(groups[left], groups[right]));
    is_left[left] = is_left[right] = false;
    is_left.push_back(true);
    CHECK(area(groups.back()) == doctest::Approx(least).epsilon(1e-9));
    CHECK(fact->area == doctest::Approx(least).epsilon(1e-9));
  }
  CHECK(merges == boxes.size() - 1);
}

TEST_CASE("each step of building names a line of its pseudocode, and being watched changes nothing") {
  const auto boxes = test::spread<double, 3>(200, 11, 10);
  using Box = Aabb<double, 3>;
  const auto check = [&](const auto& watched, const auto& unwatched, const Recorder<hierarchy::Step>& recorder,
                         std::size_t lines) {
    CHECK(same(watched, unwatched));
    REQUIRE(!recorder.entries.empty());
    for (const auto& entry : recorder.entries) CHECK(static_cast<std::size_t>(entry.step.line) < lines);
    const auto* done = std::get_if<hierarchy::Done>(&recorder.entries.back().step.fact);
    REQUIRE(done != nullptr);
    CHECK(done->nodes == static_cast<std::int64_t>(watched.nodes.size()));
  };
  Recorder<hierarchy::Step> median, area, merging, insertion;
  check(hierarchy::build_median<Box>(boxes, {}, median), hierarchy::build_median<Box>(boxes), median,
        hierarchy::kMedianPseudocode.size());
  check(hierarchy::build_surface_area<Box>(boxes, {}, area), hierarchy::build_surface_area<Box>(boxes), area,
        hierarchy::kSurfaceAreaPseudocode.size());
  check(hierarchy::build_bottom_up<Box>(boxes, merging), hierarchy::build_bottom_up<Box>(boxes), merging,
        hierarchy::kBottomUpPseudocode.size());
  check(hierarchy::build_by_insertion<Box>(boxes, insertion), hierarchy::build_by_insertion<Box>(boxes), insertion,
        hierarchy::kInsertionPseudocode.size());

  // A split's facts are the tree's: how many on either side, and where the border is.
  const auto tree = hierarchy::build_surface_area<Box>(boxes);
  std::size_t splits = 0;
  for (const auto& entry : area.entries)
    if (const auto* split = std::get_if<hierarchy::SplitChosen>(&entry.step.fact)) {
      ++splits;
      const Index left = tree.nodes[split->node].first;
      CHECK(tree.bodies_below(left).size() == static_cast<std::size_t>(split->left));
      CHECK(tree.bodies_below(left + 1).size() == static_cast<std::size_t>(split->right));
      REQUIRE(split->axis >= 0);
      const auto center = [&](Index body) { return (boxes[body].min + boxes[body].max)[split->axis] / 2; };
      for (const Index body : tree.bodies_below(left)) CHECK(center(body) <= split->position + 1e-5);
      for (const Index body : tree.bodies_below(left + 1)) CHECK(center(body) >= split->position - 1e-5);
    }
  CHECK(splits == tree.nodes.size() / 2);
}

TEST_CASE("of groups as near as each other, the one with fewer bodies is merged first") {
  const auto cube_at = [](double x) { return Aabb<double, 3>{{x - 0.5, -0.5, -0.5}, {x + 0.5, 0.5, 0.5}}; };
  const std::vector<Aabb<double, 3>> boxes{cube_at(-3), cube_at(-3), cube_at(-3), cube_at(3), cube_at(3), cube_at(0)};
  const auto tree = hierarchy::build_bottom_up<Aabb<double, 3>>(boxes);
  const auto left = tree.bodies_below(1), right = tree.bodies_below(2);
  const std::set<Index> one(left.begin(), left.end()), other(right.begin(), right.end());
  const std::set<Index> three{0, 1, 2}, with_middle{3, 4, 5};
  CHECK(((one == three && other == with_middle) || (one == with_middle && other == three)));
}

TEST_CASE("a hundred thousand bodies") {
  const auto boxes = test::spread<float, 3>(100'000, 12, 100);
  for (const auto& tree :
       {hierarchy::build_median<Aabb<float, 3>>(boxes), hierarchy::build_surface_area<Aabb<float, 3>>(boxes)}) {
    test::check_shape(tree, boxes.size(), 4);
    test::check_volumes(tree, boxes, false);
    CHECK(tree.depth() <= 25);
  }
  const auto inserted = hierarchy::build_by_insertion<Aabb<float, 3>>(boxes);
  test::check_shape(inserted, boxes.size(), 1);
  CHECK(inserted.depth() <= 40);
}
