// What of a tree's bodies a frustum sees: whole branches are left out, or taken, at one test.
// Source: U. Assarsson, T. Möller, "Optimized View Frustum Culling Algorithms for Bounding Boxes", 2000.
#pragma once

#include <cstdint>
#include <vector>

#include "hierarchy/traverse.hpp"
#include "query/classify.hpp"

namespace snug::hierarchy {

/// The planes that rejected nodes and bodies last time, to be tested first this time; -1 for none. Kept from frame to
/// frame by whoever culls the same tree again; begins empty.
struct LastRejected {
  std::vector<std::int8_t> nodes, bodies;
};

struct Culled {
  Counts counts;                   // of volumes
  std::int64_t planes_tested = 0;  // of all volumes together; each alone has 2 Dim
};

/// Which of the savings are made: all of them, but where a lesson or a benchmark shows what each is worth.
struct CullSavings {
  bool masking = true;    // children are not tested against planes that their parent is inside of
  bool coherence = true;  // the plane that rejected last time goes first; needs last
};

/// Reports every body that is not outside of one of the planes, as query::classify says, and how: report(body,
/// Culling). Each verdict is that of the body's own volume against all planes, for a node holds its bodies exactly; but
/// of bodies outside, none is told of. last: as LastRejected says, or null.
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
