#include "lesson/subjects/cloud/hull_growth.hpp"

#include <algorithm>
#include <map>

#include "geometry/orientation.hpp"

namespace snug::lesson {
namespace {

using namespace fit;

/// Follows the facts from the beginning.
struct HullFollower {
  GrowingHull hull;
  bool begun = false;

  void operator()(const SimplexChosen& fact) {
    begun = true;
    const std::size_t dim = fact.points.size() == 2 ? 2 : 3;
    for (std::size_t i = 0; i < fact.vertices.size(); i += dim) {
      hull.added.push_back(static_cast<Index>(hull.facets.size()));
      hull.facets.push_back({{fact.vertices.begin() + static_cast<std::ptrdiff_t>(i),
                              fact.vertices.begin() + static_cast<std::ptrdiff_t>(i + dim)},
                             {}});
    }
  }
  void operator()(const PointsAssigned& fact) {
    forget_step();
    auto from = fact.points.begin();
    for (std::size_t i = 0; i < fact.facets.size(); ++i, from += fact.counts[i - 1])
      facet(fact.facets[i]).outside.assign(from, from + fact.counts[i]);
    hull.just_dropped = fact.inside;
    hull.dropped.insert(hull.dropped.end(), fact.inside.begin(), fact.inside.end());
    hull.waiting.clear();
  }
  void operator()(const EyeChosen& fact) {
    forget_step();
    hull.at = fact.facet;
    hull.eye = fact.point;
    hull.distance = fact.distance;
    ++hull.rounds;
  }
  void operator()(const EdgeSplit& fact) {
    forget_step();
    remove(fact.edge, fact.point);
    facet(fact.first).vertices = {fact.a, fact.point};
    facet(fact.second).vertices = {fact.point, fact.b};
    hull.added = {fact.first, fact.second};
    hull.replaced = {fact.a, fact.b};
  }
  void operator()(const HorizonFound& fact) {
    hull.seen = fact.facets;
    hull.horizon = fact.horizon;
  }
  void operator()(const FacetsReplaced& fact) {
    forget_step();
    drop_swallowed(fact);
    for (const Index f : fact.removed) remove(f, fact.eye);
    for (std::size_t i = 0; i < fact.added.size(); ++i)
      facet(fact.added[i]).vertices = {fact.horizon[i], fact.horizon[(i + 1) % fact.horizon.size()], fact.eye};
    hull.added = fact.added;
    hull.horizon = fact.horizon;
  }
  void operator()(const FacesMerged& fact) {
    forget_step();
    hull.merged = true;
    hull.just_dropped = fact.dropped;
    hull.dropped.insert(hull.dropped.end(), fact.dropped.begin(), fact.dropped.end());
  }
  void operator()(const Finished&) { forget_step(); }
  void operator()(const auto&) {}

  [[nodiscard]] GrowingFacet& facet(Index f) {
    if (static_cast<std::size_t>(f) >= hull.facets.size()) hull.facets.resize(static_cast<std::size_t>(f) + 1);
    return hull.facets[f];
  }
  /// A vertex with facets around it that all see the eye is inside, or in a face, once they are gone.
  void drop_swallowed(const FacetsReplaced& fact) {
    const auto among = [](const std::vector<Index>& points, Index i) {
      return std::find(points.begin(), points.end(), i) != points.end();
    };
    for (const Index f : fact.removed)
      for (const Index i : facet(f).vertices)
        if (!among(fact.horizon, i) && !among(hull.just_dropped, i)) hull.just_dropped.push_back(i);
    hull.dropped.insert(hull.dropped.end(), hull.just_dropped.begin(), hull.just_dropped.end());
  }
  /// Its points wait, all but the one that becomes a vertex.
  void remove(Index f, Index eye) {
    for (const Index i : facet(f).outside)
      if (i != eye) hull.waiting.push_back(i);
    facet(f) = {};
  }
  /// Forgets what was true of the last step only.
  void forget_step() {
    hull.at = hull.eye = kNoIndex;
    for (auto* list : {&hull.just_dropped, &hull.seen, &hull.horizon, &hull.added, &hull.replaced}) list->clear();
  }
};

/// The facet of the next farthest point, if points have just been assigned.
Index next_facet(FitTrace trace, int steps) {
  const std::size_t at = steps;
  if (!std::holds_alternative<PointsAssigned>(trace[at - 1].step.fact) || at >= trace.size()) return kNoIndex;
  const auto* eye = std::get_if<EyeChosen>(&trace[at].step.fact);
  return eye != nullptr ? eye->facet : kNoIndex;
}

}  // namespace

int GrowingHull::alive() const {
  return static_cast<int>(std::count_if(facets.begin(), facets.end(), [](const auto& facet) { return facet.alive(); }));
}

int GrowingHull::still_outside() const {
  std::size_t count = waiting.size();
  for (const GrowingFacet& facet : facets) count += facet.outside.size();
  return static_cast<int>(count) - (eye != kNoIndex ? 1 : 0);
}

std::vector<Index> GrowingHull::vertices() const {
  std::vector<Index> all;
  for (const GrowingFacet& facet : facets) all.insert(all.end(), facet.vertices.begin(), facet.vertices.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::optional<GrowingHull> growing_hull(FitTrace trace, int steps) {
  HullFollower follower;
  for (const auto& entry : trace.first(steps)) std::visit(follower, entry.step.fact);
  if (!follower.begun) return std::nullopt;
  if (const Index next = next_facet(trace, steps); next != kNoIndex) follower.hull.at = next;
  return std::move(follower.hull);
}

std::vector<std::pair<Index, Index>> flat_edges(const GrowingHull& hull, const AnyPointSet& points) {
  std::map<std::pair<Index, Index>, Index> apex;  // beyond each edge, as its facet has it
  for (const GrowingFacet& facet : hull.facets)
    for (std::size_t i = 0; facet.vertices.size() == 3 && i < 3; ++i)
      apex[{facet.vertices[i], facet.vertices[(i + 1) % 3]}] = facet.vertices[(i + 2) % 3];
  const auto at = [&](Index i) { return fit::point_of(points, i); };
  std::vector<std::pair<Index, Index>> flat;
  for (const auto& [edge, own] : apex) {
    const auto other = apex.find({edge.second, edge.first});
    if (edge.first > edge.second || other == apex.end()) continue;
    if (orient3d(at(edge.first), at(edge.second), at(own), at(other->second)) == 0) flat.push_back(edge);
  }
  return flat;
}

}  // namespace snug::lesson
