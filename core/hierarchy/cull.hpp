// Which of a tree's bodies a frustum sees. One test can skip or accept a whole subtree.
// Source: U. Assarsson, T. Möller, "Optimized View Frustum Culling Algorithms for Bounding Boxes", 2000.
#pragma once

#include <cstdint>
#include <vector>

#include "hierarchy/traverse.hpp"
#include "query/classify.hpp"

namespace snug::hierarchy {

/// The planes that rejected nodes and bodies last time, which are tested first this time; -1 for none. It starts empty,
/// and the caller keeps it from frame to frame for the same tree.
struct LastRejected {
  std::vector<std::int8_t> nodes, bodies;
};

struct Culled {
  Counts counts;                   // of volumes' tests
  std::int64_t planes_tested = 0;  // for all volumes together; without savings 2 Dim for each
};

/// Which savings are made: normally all; a lesson or a benchmark switches one off to show what it is worth.
struct CullSavings {
  bool masking = true;    // children skip the planes that their parent is inside of
  bool coherence = true;  // the plane that rejected last time is tested first; needs last
};

/// Reports every body that is not outside one of the planes, with query::classify's verdict: report(body, Culling). The
/// verdict is that of the body's own volume against all planes, because a node contains its bodies exactly. Bodies
/// outside are not reported. last: see LastRejected, or null. An observer may also have tested(Place, PlaneSet, const
/// query::CullResult&): it is told each volume's test, with the planes that were not masked out.
template <class Scalar, int Dim, class VolumeType, class Report, StepObserver<Step> Observer = Ignore>
Culled cull(const Tree<VolumeType>& tree, std::type_identity_t<std::span<const VolumeType>> volumes,
            const Frustum<Scalar, Dim>& frustum, LastRejected* last, Report&& report, const CullSavings& savings = {},
            Observer&& observe = {}) {
  if (last != nullptr) last->nodes.resize(tree.nodes.size(), -1), last->bodies.resize(volumes.size(), -1);
  Culled culled;
  const auto visit = [&](const VolumeType& volume, PlaneSet& planes, Place place) {
    query::CullPlan plan{.planes = planes};
    std::int8_t* rejected = nullptr;
    if (last != nullptr && savings.coherence) rejected = &(place.is_body ? last->bodies : last->nodes)[place.index];
    if (rejected != nullptr) plan.first = *rejected;
    const query::CullResult result = query::classify(frustum, volume, plan);
    culled.planes_tested += result.planes_tested;
    if constexpr (requires { observe.tested(place, planes, result); }) observe.tested(place, planes, result);
    if (rejected != nullptr && result.rejected_by >= 0) *rejected = static_cast<std::int8_t>(result.rejected_by);
    if (savings.masking) planes = result.crossing;
    return result.verdict == query::Culling::kOutside  ? Answer::kPrune
           : result.verdict == query::Culling::kInside ? Answer::kAccept
                                                       : Answer::kDescend;
  };
  culled.counts = traverse(
      tree, volumes, kAllPlanes<Dim>, visit,
      [&](Index body, Answer answer) {
        report(body, answer == Answer::kAccept ? query::Culling::kInside : query::Culling::kIntersecting);
      },
      observe);
  return culled;
}

}  // namespace snug::hierarchy
