// Which of a tree's bodies a frustum sees. One test can skip or accept a whole subtree.
// Source: U. Assarsson, T. Möller, "Optimized View Frustum Culling Algorithms for Bounding Boxes", 2000.
#pragma once

#include <cstdint>

#include "hierarchy/traverse.hpp"
#include "query/cull/classify.hpp"

namespace snug::hierarchy {

struct Culled {
  Counts counts;                   // of volumes' tests
  std::int64_t planes_tested = 0;  // for all volumes together
};

/// Reports every body that is not outside one of the planes, with query::classify's verdict: report(body, Culling). The
/// verdict is that of the body's own volume against all planes, because a node contains its bodies exactly. Bodies
/// outside are not reported. An observer may also have tested(Place, PlaneSet, const query::CullResult&): it is told
/// each volume's test, with the planes that were not masked out. masks: whether children skip the planes that their
/// parent is inside of, as they should; without it one sees what that is worth.
template <class Scalar, int Dim, class VolumeType, class Report, StepObserver<Step> Observer = Ignore>
Culled cull(const Tree<VolumeType>& tree, std::type_identity_t<std::span<const VolumeType>> volumes,
            const Frustum<Scalar, Dim>& frustum, Report&& report, Observer&& observe = {}, bool masks = true) {
  Culled culled;
  const auto visit = [&](const VolumeType& volume, PlaneSet& planes, Place place) {
    const query::CullResult result = query::classify(frustum, volume, {.planes = planes});
    culled.planes_tested += result.planes_tested;
    if constexpr (requires { observe.tested(place, planes, result); }) observe.tested(place, planes, result);
    if (masks) planes = result.crossing;
    if (result.verdict == query::Culling::kOutside) return Answer::kPrune;
    return result.verdict == query::Culling::kInside ? Answer::kAccept : Answer::kDescend;
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
