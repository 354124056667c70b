// Traversals find just what testing all bodies finds, with far fewer tests.
#include "hierarchy/traverse.hpp"

#include <set>
#include <utility>

#include "core/hierarchy/scenes.hpp"
#include "hierarchy/broad_phase/broad_phase.hpp"
#include "hierarchy/traverse_pair.hpp"
#include "hierarchy/traverse_self.hpp"
#include "query/overlap/aabb_overlap.hpp"
#include "query/overlap/ray_aabb.hpp"

using namespace snug;
using hierarchy::Answer;

namespace {

/// A few half-spaces, normals out: what a frustum is made of. The mask has a bit for each plane still in question.
template <class Scalar, int Dim>
struct HalfSpaces {
  struct Plane {
    Vector<double, Dim> normal;
    double d;
  };
  std::vector<Plane> planes;

  Answer classify(const Aabb<Scalar, Dim>& box, unsigned& mask) const {
    for (std::size_t i = 0; i < planes.size(); ++i) {
      if ((mask >> i & 1) == 0) continue;
      double near = planes[i].d, far = planes[i].d;
      for (int k = 0; k < Dim; ++k) {
        const double low = planes[i].normal[k] * static_cast<double>(box.min[k]),
                     high = planes[i].normal[k] * static_cast<double>(box.max[k]);
        near += std::min(low, high), far += std::max(low, high);
      }
      if (near > 0) return Answer::kPrune;
      if (far <= 0) mask &= ~(1u << i);
    }
    return mask == 0 ? Answer::kAccept : Answer::kDescend;
  }
  [[nodiscard]] unsigned all() const { return (1u << planes.size()) - 1; }
};

/// Around a point of the scene, about a quarter of it.
template <class Scalar, int Dim>
HalfSpaces<Scalar, Dim> some_half_spaces(Random& random, double width) {
  HalfSpaces<Scalar, Dim> spaces;
  const auto middle = test::any_in<Dim>(random, 0, width);
  for (int i = 0; i < 2 * Dim; ++i) {
    Vector<double, Dim> normal = test::any_in<Dim>(random, -1, 1);
    normal[i / 2] += i % 2 == 0 ? 2 : -2;
    spaces.planes.push_back({normal, -normal.dot(middle) - 0.2 * width * normal.norm()});
  }
  return spaces;
}

template <class Scalar, int Dim>
void check_classifier(const std::vector<Aabb<Scalar, Dim>>& boxes, double width) {
  Random random(3);
  for (const auto& named : test::all_trees(boxes)) {
    CAPTURE(named.name);
    for (int i = 0; i < 20; ++i) {
      const auto spaces = some_half_spaces<Scalar, Dim>(random, width);
      std::vector<Index> found, expected;
      const auto visit = [&](const Aabb<Scalar, Dim>& box, unsigned& mask) { return spaces.classify(box, mask); };
      const auto report = [&](Index body, Answer answer) {
        found.push_back(body);
        unsigned mask = spaces.all();
        CHECK(spaces.classify(boxes[body], mask) == answer);
      };
      const auto counts = hierarchy::traverse(named.tree, boxes, spaces.all(), visit, report);
      for (std::size_t body = 0; body < boxes.size(); ++body) {
        unsigned mask = spaces.all();
        if (spaces.classify(boxes[body], mask) != Answer::kPrune) expected.push_back(static_cast<Index>(body));
      }
      std::sort(found.begin(), found.end());
      CHECK(found == expected);
      CHECK(counts.nodes_visited <= static_cast<std::int64_t>(named.tree.nodes.size()));
    }
  }
}

template <class Scalar, int Dim>
void check_rays(const std::vector<Aabb<Scalar, Dim>>& boxes, double low, double high) {
  Random random(4);
  int hits = 0;
  for (const auto& named : test::all_trees(boxes)) {
    CAPTURE(named.name);
    for (int i = 0; i < 50; ++i) {
      Ray<Scalar, Dim> ray{test::any_in<Dim>(random, low, high).template cast<Scalar>(),
                           test::any_in<Dim>(random, -1, 1).template cast<Scalar>()};
      if (i % 5 == 0) ray.direction[i % Dim] = 0;
      if (i % 7 == 0 && !boxes.empty()) ray.origin = boxes[i % boxes.size()].min;
      const auto hit = [&](const Aabb<Scalar, Dim>& box) { return query::ray_enters(box, ray); };
      Index expected = kNoIndex;
      Scalar t = 0;
      std::vector<Index> all, found;
      for (std::size_t body = 0; body < boxes.size(); ++body)
        if (const auto at = hit(boxes[body])) {
          all.push_back(static_cast<Index>(body));
          if (expected == kNoIndex || *at < t) expected = static_cast<Index>(body), t = *at;
        }
      const auto first = hierarchy::first_hit<Scalar>(named.tree, boxes, hit);
      CHECK(first.body == expected);
      CHECK(first.t == t);
      hits += first.body == kNoIndex ? 0 : 1;
      const auto visit = [&](const Aabb<Scalar, Dim>& box, int) {
        return hit(box) ? Answer::kDescend : Answer::kPrune;
      };
      hierarchy::traverse(named.tree, boxes, 0, visit, [&](Index body, Answer) { found.push_back(body); });
      std::sort(found.begin(), found.end());
      CHECK(found == all);
    }
  }
  if (boxes.size() > 50) CHECK(hits > 10);
}

template <class VolumeA, class VolumeB>
void check_pairs(const std::vector<VolumeA>& a, const std::vector<VolumeB>& b, bool few) {
  std::vector<std::pair<Index, Index>> expected;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      if (query::overlaps(a[i], b[j])) expected.emplace_back(static_cast<Index>(i), static_cast<Index>(j));
  for (const auto& of_a : test::all_trees(a))
    for (const auto& of_b : test::all_trees(b)) {
      if (few && of_a.name != of_b.name) continue;
      INFO(of_a.name << " and " << of_b.name);
      std::vector<std::pair<Index, Index>> found;
      const auto counts =
          hierarchy::overlapping_pairs(of_a.tree, a, of_b.tree, b, [&](Index i, Index j) { found.emplace_back(i, j); });
      std::sort(found.begin(), found.end());
      CHECK(found == expected);
      CHECK(counts.volume_tests() <= 4 * static_cast<std::int64_t>(a.size() * b.size()) + 1);
    }
}

}  // namespace

TEST_CASE_TEMPLATE("a classifier finds what testing all finds", Scalar, float, double) {
  check_classifier<Scalar, 2>(test::spread<Scalar, 2>(500, 1, 20), 20);
  check_classifier<Scalar, 3>(test::spread<Scalar, 3>(500, 2, 20), 20);
  for (const auto& scene : test::hard_scenes<Scalar, 3>(60)) {
    INFO(scene.name);
    check_classifier<Scalar, 3>(scene.boxes, 20);
  }
}

TEST_CASE_TEMPLATE("a ray finds what testing all finds", Scalar, float, double) {
  check_rays<Scalar, 2>(test::spread<Scalar, 2>(300, 3, 20), -5, 25);
  check_rays<Scalar, 3>(test::spread<Scalar, 3>(2000, 4, 20), -5, 25);
  for (const auto& scene : test::hard_scenes<Scalar, 3>(50)) {
    INFO(scene.name);
    for (const double far : {0.0, sizeof(Scalar) == 8 ? 1e12 : 1e5})
      check_rays<Scalar, 3>(
          {scene.boxes.begin(),
           scene.boxes.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(scene.boxes.size(), 50))},
          far - 2, far + 12);
  }
}

TEST_CASE_TEMPLATE("two trees find the pairs that testing all finds", Scalar, float, double) {
  check_pairs(test::spread<Scalar, 2>(150, 5, 8), test::spread<Scalar, 2>(100, 6, 8), false);
  check_pairs(test::spread<Scalar, 3>(200, 7, 6), test::spread<Scalar, 3>(150, 8, 6), false);
  for (const auto& scene : test::hard_scenes<Scalar, 3>(40)) {
    INFO(scene.name);
    check_pairs(scene.boxes, scene.boxes, true);
    check_pairs(scene.boxes, test::spread<Scalar, 3>(9, 9, 20), true);
  }
  const auto balls = test::balls_of(test::spread<Scalar, 3>(80, 10, 6));
  check_pairs(balls, test::balls_of(test::spread<Scalar, 3>(90, 11, 6)), true);
  check_pairs(balls, test::spread<Scalar, 3>(90, 12, 6), true);  // of two kinds
}

TEST_CASE("trees over oriented boxes and k-DOPs find the pairs that testing all finds") {
  Random random(13);
  std::vector<Obb<double, 3>> boxes;
  std::vector<Kdop<double, 3>> kdops;
  for (int i = 0; i < 60; ++i) {
    const auto middle = test::any_in<3>(random, 0, 6);
    Matrix<double, 3> axes =
        Eigen::AngleAxisd(random.between(0, 6), test::any_in<3>(random, -1, 1).normalized()).toRotationMatrix();
    boxes.push_back({middle, axes, test::any_in<3>(random, 0.1, 0.6)});
    Kdop<double, 3> kdop{.k = 14};
    const auto list = kdop_axes<3>(14);
    for (std::size_t s = 0; s < list.size(); ++s) {
      const double along = list[s][0] * middle[0] + list[s][1] * middle[1] + list[s][2] * middle[2];
      kdop.min[s] = along - 0.4, kdop.max[s] = along + 0.4;
    }
    kdops.push_back(kdop);
  }
  check_pairs(boxes, boxes, true);
  check_pairs(kdops, kdops, true);
}

TEST_CASE("a tree against itself reports each pair once, and tests no two volumes twice") {
  for (const auto& scene : test::hard_scenes<double, 3>(60)) {
    INFO(scene.name);
    const std::span<const Aabb<double, 3>> boxes(scene.boxes);
    const auto tree = hierarchy::build_median<Aabb<double, 3>>(boxes);
    std::set<std::pair<Index, Index>> found, wanted, tested, nodes;
    Recorder<hierarchy::Step> recorder;
    const auto counts = hierarchy::overlapping_pairs_within(
        tree, boxes, [&](Index i, Index j) { CHECK(found.insert(std::minmax(i, j)).second); }, recorder);
    for (Index i = 0; i < std::ssize(boxes); ++i)
      for (Index j = i + 1; j < std::ssize(boxes); ++j)
        if (query::overlaps(boxes[i], boxes[j])) wanted.insert({i, j});
    CHECK(found == wanted);
    for (const auto& entry : recorder.entries)
      if (const auto* pair = std::get_if<hierarchy::PairTested>(&entry.step.fact)) {
        CHECK(pair->a != pair->b);
        CHECK((pair->bodies ? tested : nodes).insert(std::minmax(pair->a, pair->b)).second);
      }
    CHECK(counts.body_tests == std::ssize(tested));
    CHECK(counts.node_tests == std::ssize(nodes));
  }
}

TEST_CASE("in a spread-out scene far fewer tests are made than there are bodies") {
  const auto boxes = test::spread<double, 3>(20'000, 14, 100), others = test::spread<double, 3>(20'000, 15, 100);
  using Box = Aabb<double, 3>;
  const auto check = [&](const char* name, const hierarchy::Tree<Box>& tree, const hierarchy::Tree<Box>& other) {
    CAPTURE(name);
    Random random(16);
    std::int64_t culling = 0, rays = 0;
    for (int i = 0; i < 50; ++i) {
      const auto corner = test::any_in<3>(random, 0, 90);
      const Box window{corner, corner + Vector<double, 3>::Constant(10)};
      const auto visit = [&](const Box& box, int) {
        return query::aabbs_overlap(box, window) ? Answer::kDescend : Answer::kPrune;
      };
      culling += hierarchy::traverse(tree, boxes, 0, visit, [](Index, Answer) {}).volume_tests();
      const Ray<double, 3> ray{corner, test::any_in<3>(random, -1, 1)};
      rays += hierarchy::first_hit<double>(tree, boxes, [&](const Box& box) {
                return query::ray_enters(box, ray);
              }).counts.volume_tests();
    }
    CHECK(culling / 50 < 400);  // of 20,000
    CHECK(rays / 50 < 500);
    CHECK(hierarchy::overlapping_pairs(tree, boxes, other, others, [](Index, Index) {}).volume_tests() <
          1'000'000);  // of 400 million
  };
  check("median", hierarchy::build_median<Box>(boxes), hierarchy::build_median<Box>(others));
  check("surface area", hierarchy::build_surface_area<Box>(boxes), hierarchy::build_surface_area<Box>(others));
  check("insertion", hierarchy::build_by_insertion<Box>(boxes), hierarchy::build_by_insertion<Box>(others));
}

TEST_CASE("what is accepted is not tested, and the state of a node goes to what is below it alone") {
  const auto boxes = test::spread<double, 3>(100, 17, 20);
  const auto tree = hierarchy::build_surface_area<Aabb<double, 3>>(boxes);
  int reported = 0;
  const auto accept = [](const Aabb<double, 3>&, int) { return Answer::kAccept; };
  const auto counts = hierarchy::traverse(tree, boxes, 0, accept, [&](Index, Answer) { ++reported; });
  CHECK(reported == 100);
  CHECK(counts.volume_tests() == 1);

  // The depth, counted in the state, is that of the place.
  std::vector<int> depths(tree.nodes.size(), 1);
  for (std::size_t i = 0; i < tree.nodes.size(); ++i)
    if (!tree.nodes[i].is_leaf())
      for (const Index child : {tree.nodes[i].first, tree.nodes[i].first + 1}) depths[child] = depths[i] + 1;
  int nodes = 0;
  const auto deeper = [&](const Aabb<double, 3>&, int& depth, hierarchy::Place place) {
    ++depth;
    if (!place.is_body) {
      CHECK(depth == depths[place.index]);
      ++nodes;
    }
    return Answer::kDescend;
  };
  hierarchy::traverse(tree, boxes, 0, deeper, [](Index, Answer) {});
  CHECK(nodes > 20);
}

TEST_CASE("each step of a traversal names a line, and the last has the counts") {
  const auto boxes = test::spread<float, 3>(100, 18, 5);
  const auto tree = hierarchy::build_surface_area<Aabb<float, 3>>(boxes);
  const auto check = [](const Recorder<hierarchy::Step>& recorder, const hierarchy::Counts& counts, std::size_t lines) {
    std::int64_t tests = 0;
    for (const auto& entry : recorder.entries) {
      CHECK(static_cast<std::size_t>(entry.step.line) < lines);
      const auto& fact = entry.step.fact;
      tests += std::holds_alternative<hierarchy::NodeVisited>(fact) ||
               std::holds_alternative<hierarchy::BodyTested>(fact) ||
               std::holds_alternative<hierarchy::PairTested>(fact);
    }
    CHECK(tests == counts.volume_tests());
    const auto* done = std::get_if<hierarchy::Done>(&recorder.entries.back().step.fact);
    REQUIRE(done != nullptr);
    CHECK(done->volume_tests == counts.volume_tests());
    CHECK(done->nodes == counts.nodes_visited);
  };
  Recorder<hierarchy::Step> culled, shot, paired, within;
  const Aabb<float, 3> window{{0, 0, 0}, {2, 2, 2}};
  const auto visit = [&](const Aabb<float, 3>& box, int) {
    return query::aabbs_overlap(box, window) ? Answer::kDescend : Answer::kPrune;
  };
  check(culled,
        hierarchy::traverse(
            tree, boxes, 0, visit, [](Index, Answer) {}, culled),
        hierarchy::kTraversePseudocode.size());
  const Ray<float, 3> ray{{0, 0, 0}, {1, 1, 1}};
  const auto hit = [&](const Aabb<float, 3>& box) { return query::ray_enters(box, ray); };
  check(shot, hierarchy::first_hit<float>(tree, boxes, hit, shot).counts, hierarchy::kFirstHitPseudocode.size());
  check(paired,
        hierarchy::overlapping_pairs(
            tree, boxes, tree, boxes, [](Index, Index) {}, paired),
        hierarchy::kOverlapPseudocode.size());
  check(within,
        hierarchy::overlapping_pairs_within(
            tree, boxes, [](Index, Index) {}, within),
        hierarchy::kTreePairsPseudocode.size());
  for (const auto& entry : within.entries) {
    const auto* pair = std::get_if<hierarchy::PairTested>(&entry.step.fact);
    const std::string_view line = hierarchy::kTreePairsPseudocode[entry.step.line];
    CHECK(line == (pair != nullptr && pair->bodies ? "  leaves: each body with each"
                                                   : "while a pair of nodes is open: test its AABBs"));
  }
}
