// The convex hull, as a polygon (2-D) or a closed surface of triangles (3-D).
#pragma once

#include <array>
#include <string_view>
#include <tuple>
#include <vector>

#include "geometry/vector.hpp"

namespace snug {

/// Vertices are points of the set, unrounded: in 2-D counter-clockwise around it, in 3-D by rising index. facets name
/// places in vertices: in 2-D edges, facet i from vertex i to the next; in 3-D triangles, counter-clockwise as seen
/// from outside. Where the points span less than Dim dimensions (affine_dim) the hull is a point, a segment's two ends,
/// or in 3-D a flat polygon's vertices in their order around it; facets is then empty.
template <class Scalar, int Dim>
struct ConvexHull {
  std::vector<Vector<Scalar, Dim>> vertices;
  std::vector<Index> indices;  // of each vertex in the point set
  std::vector<std::array<Index, Dim>> facets;
  int affine_dim = Dim;
  static constexpr std::array<std::string_view, 4> kFields{"vertices", "indices", "facets", "affine_dim"};
  static auto tie(auto& own) { return std::tie(own.vertices, own.indices, own.facets, own.affine_dim); }
};

}  // namespace snug
