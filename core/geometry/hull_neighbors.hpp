// Which vertices of a hull an edge joins: what hill climbing walks on.
#pragma once

#include <span>
#include <vector>

#include "geometry/hull.hpp"

namespace snug {

/// The neighbours of every vertex in one array: those of vertex v are ends[begin[v]] ... ends[begin[v + 1] - 1],
/// rising. In 3-D facets[i] is the facet on the left, as seen from outside, of the way to ends[i]; of flat hulls and in
/// 2-D it is empty.
struct HullNeighbors {
  std::vector<Index> begin;
  std::vector<Index> ends;
  std::vector<Index> facets;

  [[nodiscard]] std::span<const Index> of(Index vertex) const {
    const auto from = static_cast<std::size_t>(begin[vertex]);
    const auto to = static_cast<std::size_t>(begin[static_cast<std::size_t>(vertex) + 1]);
    return {ends.data() + from, to - from};
  }
  /// The place in ends of the edge from a vertex to another; kNoIndex where there is none. O(log degree) time.
  [[nodiscard]] Index edge(Index from, Index to) const;
};

/// hull: any whose facets name its vertices. From each vertex of a hull that quickhull gives, one of its neighbours is
/// farther along any direction, or none of all vertices is; edges that only cut a flat face into triangles count too.
/// O(n log n) time.
template <class Scalar, int Dim>
[[nodiscard]] HullNeighbors hull_neighbors(const ConvexHull<Scalar, Dim>& hull);

}  // namespace snug
