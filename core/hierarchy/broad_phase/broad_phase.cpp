#include "hierarchy/broad_phase/broad_phase.hpp"

#include <algorithm>
#include <variant>

#include "hierarchy/broad_phase/grid.hpp"
#include "hierarchy/build.hpp"
#include "hierarchy/traverse_self.hpp"
#include "query/overlap/aabb_overlap.hpp"

namespace snug::hierarchy {
namespace {

/// Appends the bodies that a traversal compares.
struct SeeBodies {
  std::vector<BodyPair>& seen;
  void operator()(const Step& step) const {
    const auto* tested = std::get_if<PairTested>(&step.fact);
    if (tested != nullptr && tested->bodies) seen.push_back(BodyPair::of(tested->a, tested->b));
  }
  void count(Operation, std::int64_t) const {}
};

PairsFound pairs_by_tree(std::span<const Aabb<double, 3>> boxes, std::vector<BodyPair>* seen) {
  PairsFound found;
  const Tree<Aabb<double, 3>> tree = build_median<Aabb<double, 3>>(boxes);
  const auto report = [&](Index i, Index j) { found.pairs.push_back(BodyPair::of(i, j)); };
  const Counts counts = seen == nullptr ? overlapping_pairs_within(tree, boxes, report)
                                        : overlapping_pairs_within(tree, boxes, report, SeeBodies{*seen});
  found.compared = counts.volume_tests();
  return found;
}

PairsFound all_pairs(std::span<const Aabb<double, 3>> boxes, std::vector<BodyPair>* seen) {
  PairsFound found;
  const auto n = static_cast<Index>(boxes.size());
  for (Index i = 0; i < n; ++i)
    for (Index j = i + 1; j < n; ++j) {
      if (seen != nullptr) seen->push_back({i, j});
      if (query::aabbs_overlap(boxes[i], boxes[j])) found.pairs.push_back({i, j});
    }
  found.compared = std::int64_t{n} * (n - 1) / 2;
  return found;
}

PairsFound pairs_by(PairSearch search, std::span<const Aabb<double, 3>> boxes, SweepOrder& sweep,
                    std::vector<BodyPair>* seen) {
  switch (search) {
    case PairSearch::kTree: return pairs_by_tree(boxes, seen);
    case PairSearch::kAllPairs: return all_pairs(boxes, seen);
    case PairSearch::kGrid: return pairs_by_grid(boxes, seen);
    case PairSearch::kSweepAndPrune: break;
  }
  return sweep_and_prune(boxes, sweep, seen);
}

}  // namespace

PairsFound broad_phase(std::span<const Aabb<double, 3>> boxes, PairSearch search, SweepOrder* sweep,
                       std::vector<BodyPair>* seen) {
  SweepOrder none;
  PairsFound found = pairs_by(search, boxes, sweep != nullptr ? *sweep : none, seen);
  std::sort(found.pairs.begin(), found.pairs.end());
  return found;
}

}  // namespace snug::hierarchy
