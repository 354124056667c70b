// libFuzzer: trees whose nodes are volumes of any kind, built in each of the four ways, and refitted after their bodies
// have moved. Nodes contain their bodies exactly; searches, culling, and pairs within a tree and between two find what
// trying all bodies finds.
#include <set>

#include "core/fit/exact_holds.hpp"
#include "fuzz/volumes.hpp"
#include "hierarchy/build.hpp"
#include "hierarchy/cull.hpp"
#include "hierarchy/traverse_pair.hpp"
#include "hierarchy/traverse_self.hpp"

namespace {

using namespace snug;
using fuzz::require;

constexpr unsigned kMostBodies = 8, kMostPoints = 4;

template <class Kind>
struct Of;
template <template <class, int> class Kind, class S, int D>
struct Of<Kind<S, D>> {
  using Scalar = S;
  static constexpr int kDim = D;
};

/// Fitted round a few points; k-DOPs of one k, for merging leaves the slabs that both have.
template <class Kind>
Kind any_body(fuzz::Bytes& bytes) {
  using Scalar = typename Of<Kind>::Scalar;
  constexpr int kDim = Of<Kind>::kDim;
  constexpr std::string_view kName = kVolumeNames[query::VolumeKind<Kind>::kIndex];
  const auto points = bytes.cloud<Scalar, kDim>(kMostPoints);
  const auto volume = fuzz::fitted<Scalar, kDim>(bytes, points, [&](const fit::Algorithm& algorithm) {
    return algorithm.volume == kName && (kName != "kdop" || algorithm.name == "k14");
  });
  return *std::get_if<Kind>(&volume);
}

/// Each node contains its children or bodies, and so all that is below it.
template <class Kind>
void check_nodes(const hierarchy::Tree<Kind>& tree, const std::vector<Kind>& bodies) {
  using AnyVolume = Volume<typename Of<Kind>::Scalar, Of<Kind>::kDim>;
  require(tree.bodies.size() == bodies.size() && tree.nodes.empty() == bodies.empty());
  require(std::set<Index>(tree.bodies.begin(), tree.bodies.end()).size() == bodies.size());
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const auto contains = [&](const Kind& inner) {
      require(exact::holds(AnyVolume(tree.nodes[i].volume), AnyVolume(inner)));
    };
    const auto first = static_cast<std::size_t>(tree.nodes[i].first);
    if (tree.nodes[i].is_leaf())
      for (const Index body : tree.bodies_below(static_cast<Index>(i))) contains(bodies[body]);
    else contains(tree.nodes[first].volume), contains(tree.nodes[first + 1].volume);
  }
}

template <class Kind>
void check_search(const hierarchy::Tree<Kind>& tree, const std::vector<Kind>& bodies, const Kind& sought) {
  std::set<Index> found, wanted;
  const auto visit = [&](const Kind& volume, char&) {
    return query::overlaps(volume, sought) ? hierarchy::Answer::kDescend : hierarchy::Answer::kPrune;
  };
  hierarchy::traverse<Kind>(tree, bodies, char{}, visit,
                            [&](Index body, hierarchy::Answer) { require(found.insert(body).second); });
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (query::overlaps(bodies[i], sought)) wanted.insert(static_cast<Index>(i));
  require(found == wanted);
}

template <class Kind>
void check_cull(const hierarchy::Tree<Kind>& tree, const std::vector<Kind>& bodies,
                const Frustum<typename Of<Kind>::Scalar, Of<Kind>::kDim>& frustum) {
  std::vector<query::Culling> verdicts(bodies.size(), query::Culling::kOutside);
  hierarchy::cull(tree, bodies, frustum, [&](Index body, query::Culling verdict) {
    require(verdicts[body] == query::Culling::kOutside);  // once each
    verdicts[body] = verdict;
  });
  for (std::size_t i = 0; i < bodies.size(); ++i) require(verdicts[i] == query::classify(frustum, bodies[i]).verdict);
}

using Pairs = std::set<std::pair<Index, Index>>;

template <class Kind>
void check_pairs(const hierarchy::Tree<Kind>& tree, const hierarchy::Tree<Kind>& other,
                 const std::vector<Kind>& bodies) {
  Pairs within, between, wanted, each;
  hierarchy::overlapping_pairs_within(tree, bodies,
                                      [&](Index i, Index j) { require(within.insert(std::minmax(i, j)).second); });
  hierarchy::overlapping_pairs(tree, bodies, other, bodies, [&](Index i, Index j) {
    require(between.insert({i, j}).second);
  });
  const auto count = static_cast<Index>(bodies.size());
  for (Index i = 0; i < count; ++i)
    for (Index j = 0; j < count; ++j)
      if (query::overlaps(bodies[i], bodies[j])) {
        each.insert({i, j});
        if (i < j) wanted.insert({i, j});
      }
  require(within == wanted);
  require(between == each);
}

template <class Kind>
void check(fuzz::Bytes& bytes) {
  std::vector<Kind> bodies;
  for (unsigned count = bytes.below(kMostBodies), i = 0; i < count; ++i) bodies.push_back(any_body<Kind>(bytes));
  const Kind sought = any_body<Kind>(bytes);
  const auto frustum = fuzz::any_frustum<typename Of<Kind>::Scalar, Of<Kind>::kDim>(bytes);
  const hierarchy::Options options{1 + static_cast<Index>(bytes.below(4))};
  std::array<hierarchy::Tree<Kind>, 4> trees{
      hierarchy::build_median<Kind>(bodies, options), hierarchy::build_surface_area<Kind>(bodies, options),
      hierarchy::build_bottom_up<Kind>(bodies), hierarchy::build_by_insertion<Kind>(bodies)};
  const unsigned proven = bytes.below(4);  // rationals take long
  for (int round = 0; round < 2; ++round) {
    if (round > 0)
      for (hierarchy::Tree<Kind>& tree : trees) hierarchy::refit<Kind>(tree, bodies);  // all, for pairs between two
    for (std::size_t i = 0; i < trees.size(); ++i) {
      if (i == proven) check_nodes(trees[i], bodies);
      check_search(trees[i], bodies, sought);
      check_pairs(trees[i], trees[(i + 1) % trees.size()], bodies);
      if (frustum) check_cull(trees[i], bodies, *frustum);
    }
    for (Kind& body : bodies)
      if (bytes.below(2) == 0) body = any_body<Kind>(bytes);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  switch (bytes.below(8)) {
    case 0: check<Aabb<double, 3>>(bytes); break;
    case 1: check<Sphere<double, 3>>(bytes); break;
    case 2: check<Obb<double, 3>>(bytes); break;
    case 3: check<Capsule<double, 3>>(bytes); break;
    case 4: check<Lozenge<double, 3>>(bytes); break;
    case 5: check<Kdop<double, 3>>(bytes); break;
    case 6: check<ConvexHull<double, 3>>(bytes); break;
    default: check<Aabb<float, 2>>(bytes); break;
  }
  return 0;
}
