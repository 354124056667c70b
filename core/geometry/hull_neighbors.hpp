// Which vertices of a hull are joined by an edge. Hill climbing walks along these edges.
#pragma once

#include <span>
#include <vector>

#include "geometry/hull.hpp"

namespace snug {

/// The neighbours of every vertex in one array: those of vertex v are ends[begin[v]] ... ends[begin[v + 1] - 1],
/// rising. In 3-D facets[i] is the facet to the left of the edge to ends[i], as seen from outside; for flat hulls and
/// in 2-D facets is empty.
struct HullNeighbors {
  std::vector<Index> begin;
  std::vector<Index> ends;
  std::vector<Index> facets;

  [[nodiscard]] std::span<const Index> of(Index vertex) const {
    const std::size_t from = begin[vertex];
    const std::size_t to = begin[vertex + 1];
    return {ends.data() + from, to - from};
  }
  /// The index in ends of the edge from one vertex to another; kNoIndex if there is none. O(log degree) time.
  [[nodiscard]] Index edge(Index from, Index to) const;
};

/// hull: any whose facets index its vertices. In a hull from quickhull, for any direction, each vertex either is
/// farthest along it or has a neighbour that is farther; edges that only cut a flat face into triangles count too. O(n
/// log n) time.
template <class Scalar, int Dim>
[[nodiscard]] HullNeighbors hull_neighbors(const ConvexHull<Scalar, Dim>& hull);

}  // namespace snug
