// Trees over 100,000 boxes: what building takes against sorting as many 64-bit keys, and how many tests traversals make
// against testing all. Prints the tables that RESULTS.md keeps.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "bench/ratio.hpp"
#include "geometry/random.hpp"
#include "hierarchy/build.hpp"
#include "hierarchy/traverse.hpp"
#include "hierarchy/traverse_pair.hpp"
#include "query/overlap/aabb_overlap.hpp"
#include "query/overlap/ray_aabb.hpp"

using namespace snug;

namespace {

constexpr std::size_t kBodies = 100'000;
constexpr int kRounds = 31;

template <class Scalar>
using Boxes = std::vector<Aabb<Scalar, 3>>;

enum class Scene { kSpread, kClusters, kSizes };
constexpr const char* kNames[]{"spread evenly", "in clusters", "of all sizes"};

template <class Scalar>
Boxes<Scalar> boxes(Scene scene, std::uint64_t seed) {
  Random random(seed);
  Boxes<Scalar> all;
  Vector<double, 3> cluster = Vector<double, 3>::Zero();
  for (std::size_t i = 0; i < kBodies; ++i) {
    const auto any = [&](double size) {
      return Vector<double, 3>(random.between(0, size), random.between(0, size), random.between(0, size));
    };
    if (i % 500 == 0) cluster = any(100);
    const Vector<double, 3> low = scene == Scene::kClusters ? Vector<double, 3>(cluster + any(3)) : any(100);
    double size = 1;
    if (scene == Scene::kSizes)
      for (auto halvings = random.below(10); halvings > 0; --halvings) size /= 2;
    const Vector<double, 3> high = low + any(size);
    all.push_back({low.cast<Scalar>(), high.cast<Scalar>()});
  }
  return all;
}

template <class Scalar>
void building(Scene scene) {
  using Box = Aabb<Scalar, 3>;
  const Boxes<Scalar> bodies = boxes<Scalar>(scene, 1);
  Random random(2);
  std::vector<std::uint64_t> keys(kBodies), sorted;
  for (auto& key : keys) key = random.bits();
  sorted = keys;
  const auto sort = [&] {
    std::copy(keys.begin(), keys.end(), sorted.begin());
    std::sort(sorted.begin(), sorted.end());
    bench::keep(sorted);
  };
  const auto print = [&](const char* name, int rounds, auto&& build) {
    const auto tree = build();
    const auto ratio = bench::ratio([&] { bench::keep(build()); }, sort, rounds);
    std::printf("| %s | %s | %s | %.2f (%.2f to %.2f) | %.1f ms | %zu | %d |\n",
                sizeof(Scalar) == 4 ? "float" : "double", kNames[static_cast<int>(scene)], name, ratio.median,
                ratio.low, ratio.high, ratio.median * ratio.base * 1e3, tree.nodes.size(), tree.depth());
  };
  print("surface area", kRounds, [&] { return hierarchy::build_surface_area<Box>(bodies); });
  print("median", kRounds, [&] { return hierarchy::build_median<Box>(bodies); });
  print("insertion", 3, [&] { return hierarchy::build_by_insertion<Box>(bodies); });
  auto tree = hierarchy::build_surface_area<Box>(bodies);
  print("refitting alone", kRounds, [&]() -> const hierarchy::Tree<Box>& {
    hierarchy::refit(tree, bodies);
    return tree;
  });
}

/// How many tests a query makes, in parts of testing all.
void counting(Scene scene) {
  using Box = Aabb<double, 3>;
  const Boxes<double> bodies = boxes<double>(scene, 1), others = boxes<double>(scene, 3);
  const auto line = [&](const char* name, const hierarchy::Tree<Box>& tree, const hierarchy::Tree<Box>& other) {
    Random random(4);
    std::int64_t culling = 0, culled_to = 0, rays = 0;
    constexpr int kQueries = 200;
    for (int i = 0; i < kQueries; ++i) {
      // A box of a tenth of the scene's width stands for a frustum.
      const Vector<double, 3> corner(random.between(0, 90), random.between(0, 90), random.between(0, 90));
      const Box window{corner, corner + Vector<double, 3>::Constant(10)};
      const auto visit = [&](const Box& box, int) {
        if (!query::aabbs_overlap(box, window)) return hierarchy::Answer::kPrune;
        const bool inside =
            (box.min.array() >= window.min.array()).all() && (box.max.array() <= window.max.array()).all();
        return inside ? hierarchy::Answer::kAccept : hierarchy::Answer::kDescend;
      };
      culling +=
          hierarchy::traverse(tree, bodies, 0, visit, [&](Index, hierarchy::Answer) { ++culled_to; }).volume_tests();
      const Ray<double, 3> ray{corner, Vector<double, 3>(random.normal(), random.normal(), random.normal())};
      rays += hierarchy::first_hit<double>(tree, bodies, [&](const Box& box) {
                return query::ray_enters(box, ray);
              }).counts.volume_tests();
    }
    std::int64_t pairs = 0;
    const auto counts = hierarchy::overlapping_pairs(tree, bodies, other, others, [&](Index, Index) { ++pairs; });
    std::printf("| %s | %s | %.0f (%.0f found) | %.0f | %.1f million (%lld found) |\n", kNames[static_cast<int>(scene)],
                name, double(culling) / kQueries, double(culled_to) / kQueries, double(rays) / kQueries,
                double(counts.volume_tests()) / 1e6, static_cast<long long>(pairs));
  };
  line("surface area", hierarchy::build_surface_area<Box>(bodies), hierarchy::build_surface_area<Box>(others));
  line("median", hierarchy::build_median<Box>(bodies), hierarchy::build_median<Box>(others));
  line("insertion", hierarchy::build_by_insertion<Box>(bodies), hierarchy::build_by_insertion<Box>(others));
}

}  // namespace

int main() {
  std::printf(
      "| scalar | boxes | built by | in sorts of 100,000 keys | | nodes | depth |\n|---|---|---|---|---:|---:|---:|\n");
  for (const Scene scene : {Scene::kSpread, Scene::kClusters, Scene::kSizes})
    building<float>(scene), building<double>(scene);
  std::printf("\n| boxes | built by | tests to cull by a box | tests for a ray | tests for two trees "
              "|\n|---|---|---:|---:|---:|\n");
  for (const Scene scene : {Scene::kSpread, Scene::kClusters, Scene::kSizes}) counting(scene);
}
