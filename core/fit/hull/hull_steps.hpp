// The steps of the hull's construction. The hull after each step can be rebuilt from them alone: SimplexChosen
// names the first facets, EdgeSplit and FacetsReplaced the facets that are removed and added. Facets have numbers,
// which are reused once a facet is gone; their vertices are the indices of points, counter-clockwise as seen from
// outside.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "fit/facts.hpp"
#include "fit/fit.hpp"
#include "geometry/hull.hpp"
#include "trace/fields.hpp"

namespace snug::fit {

/// The first facets: of a tetrahedron (3-D) or of a segment seen from both sides (2-D), on those points.
/// vertices: those of facet 0, then those of facet 1, ...: three each, in 2-D two.
struct SimplexChosen {
  static constexpr std::string_view kName = "simplex_chosen";
  std::vector<Index> points;
  std::vector<Index> vertices;
  SNUG_FIELDS(points, vertices);
};

/// All points lie in a plane (affine_dim 2), on a line (1) or in one place (0); points: a simplex that spans them.
struct FlatFound {
  static constexpr std::string_view kName = "flat_found";
  int affine_dim = 0;
  std::vector<Index> points;
  SNUG_FIELDS(affine_dim, points);
};

/// Points outside were assigned to facets that see them: counts[i] to facets[i]. points: those of facets[0], then those
/// of facets[1], ...; inside: those that no facet sees, which are dropped.
struct PointsAssigned {
  static constexpr std::string_view kName = "points_assigned";
  std::vector<Index> facets;
  std::vector<Index> counts;
  std::vector<Index> points;
  std::vector<Index> inside;
  Index dropped = 0;  // how many are inside
  SNUG_FIELDS(facets, counts, points, inside, dropped);
};

/// The farthest of the facet's points was chosen. distance: from the facet's line or plane, scene units, rounded; of:
/// how many points the facet has.
struct EyeChosen {
  static constexpr std::string_view kName = "eye_chosen";
  Index point = kNoIndex;
  Index facet = kNoIndex;
  double distance = 0;
  Index of = 0;
  SNUG_FIELDS(point, facet, distance, of);
};

/// 2-D: the edge was replaced by two, from its start a to the point and from there to its end b.
struct EdgeSplit {
  static constexpr std::string_view kName = "edge_split";
  Index edge = kNoIndex;
  Index a = kNoIndex, b = kNoIndex;
  Index point = kNoIndex;
  Index first = kNoIndex, second = kNoIndex;  // the new edges
  SNUG_FIELDS(edge, a, b, point, first, second);
};

/// The facets that see the eye, and their border, a ring of points counter-clockwise as seen from the eye.
struct HorizonFound {
  static constexpr std::string_view kName = "horizon_found";
  Index eye = kNoIndex;
  std::vector<Index> facets;
  std::vector<Index> horizon;
  SNUG_FIELDS(eye, facets, horizon);
};

/// The facets that saw the eye were replaced by a cone: added[i] has the vertices horizon[i], horizon[i + 1] (the first
/// again after the last) and eye.
struct FacetsReplaced {
  static constexpr std::string_view kName = "facets_replaced";
  Index eye = kNoIndex;
  std::vector<Index> removed;
  std::vector<Index> horizon;
  std::vector<Index> added;
  SNUG_FIELDS(eye, removed, horizon, added);
};

/// Coplanar facets were merged into faces, and the faces were triangulated again without the dropped points, which lie
/// inside a face or an edge and so are not vertices. faces: how many faces had more than one facet.
struct FacesMerged {
  static constexpr std::string_view kName = "faces_merged";
  Index faces = 0;
  std::vector<Index> dropped;
  SNUG_FIELDS(faces, dropped);
};

/// Only the last step has a volume: with a hull in every step, a trace would grow as the square of the hull.
template <class Scalar, int Dim>
using HullStep = Step<ConvexHull<Scalar, Dim>, SimplexChosen, FlatFound, PointsAssigned, EyeChosen, EdgeSplit,
                      HorizonFound, FacetsReplaced, FacesMerged, Finished>;

/// What fits hulls.
[[nodiscard]] std::span<const Algorithm> rows_of(const ConvexHull<double, 3>*);

}  // namespace snug::fit
