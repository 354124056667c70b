// The hull that Quickhull has grown at a step of a trace, rebuilt from its facts alone.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "lesson/subjects/cloud/fit_run.hpp"

namespace snug::lesson {

struct GrowingFacet {
  std::vector<Index> vertices;  // counter-clockwise as seen from outside: three, in 2-D two; empty if it is gone
  std::vector<Index> outside;   // the points that are assigned to it
  [[nodiscard]] bool alive() const { return !vertices.empty(); }
};

struct GrowingHull {
  std::vector<GrowingFacet> facets;  // by their numbers
  std::vector<Index> dropped;        // the points that no facet sees any more, in the order in which they were dropped
  std::vector<Index> just_dropped;   // those that this step dropped
  /// The facet that the step works on: that of the farthest point; and once its points are assigned, the next one that
  /// has points outside, of which the farthest is not known yet.
  Index at = kNoIndex;
  Index eye = kNoIndex;         // its farthest point, until facets to it replace others
  double distance = 0;          // of the eye from the facet's line or plane, scene units
  std::vector<Index> seen;      // the facets that see the eye, if that is known
  std::vector<Index> horizon;   // their border, a ring of points
  std::vector<Index> added;     // the facets that this step added
  std::vector<Index> replaced;  // 2-D: the ends of the edge that this step replaced
  std::vector<Index> waiting;   // points whose facet is gone, and which are still to be assigned
  int rounds = 0;               // how many farthest points have been chosen
  bool merged = false;          // whether coplanar facets were merged
  [[nodiscard]] int alive() const;
  [[nodiscard]] int still_outside() const;
  /// The points that facets have as vertices, rising.
  [[nodiscard]] std::vector<Index> vertices() const;
};

/// The hull after the first `steps` steps; none if there is no first facet yet. One pass over the trace.
[[nodiscard]] std::optional<GrowingHull> growing_hull(FitTrace trace, int steps);

/// The edges between coplanar facets, as pairs of points: decided exactly.
[[nodiscard]] std::vector<std::pair<Index, Index>> flat_edges(const GrowingHull& hull, const AnyPointSet& points);

}  // namespace snug::lesson
