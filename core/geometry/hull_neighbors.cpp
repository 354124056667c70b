#include "geometry/hull_neighbors.hpp"

#include <algorithm>
#include <array>

namespace snug {
namespace {

struct Edge {
  Index from, to;
  Index facet;  // on its left

  friend bool operator<(const Edge& a, const Edge& b) { return a.from != b.from ? a.from < b.from : a.to < b.to; }
};

/// Every edge in both directions: each of the two facets at an edge gives one.
template <class Scalar, int Dim>
std::vector<Edge> edges_of(const ConvexHull<Scalar, Dim>& hull) {
  std::vector<Edge> edges;
  if (Dim == 3 && hull.affine_dim == 3) {
    for (std::size_t f = 0; f < hull.facets.size(); ++f)
      for (std::size_t i = 0; i < Dim; ++i)
        edges.push_back({hull.facets[f][i], hull.facets[f][(i + 1) % Dim], static_cast<Index>(f)});
    return edges;
  }
  const auto n = static_cast<Index>(hull.vertices.size());
  for (Index i = 0; i < n && n > 1; ++i) {  // a ring; for two vertices, there and back
    const Index next = i + 1 < n ? i + 1 : 0;
    edges.push_back({i, next, kNoIndex});
    if (n > 2) edges.push_back({next, i, kNoIndex});
  }
  return edges;
}

}  // namespace

Index HullNeighbors::edge(Index from, Index to) const {
  const std::span<const Index> neighbors = of(from);
  const auto found = std::lower_bound(neighbors.begin(), neighbors.end(), to);
  return found != neighbors.end() && *found == to ? static_cast<Index>(&*found - ends.data()) : kNoIndex;
}

template <class Scalar, int Dim>
HullNeighbors hull_neighbors(const ConvexHull<Scalar, Dim>& hull) {
  std::vector<Edge> edges = edges_of(hull);
  std::sort(edges.begin(), edges.end());
  HullNeighbors result;
  result.begin.assign(hull.vertices.size() + 1, 0);
  result.ends.reserve(edges.size());
  for (const Edge& edge : edges) {
    ++result.begin[edge.from + 1];
    result.ends.push_back(edge.to);
    if (edge.facet != kNoIndex) result.facets.push_back(edge.facet);
  }
  for (std::size_t v = 0; v < hull.vertices.size(); ++v) result.begin[v + 1] += result.begin[v];
  return result;
}

template HullNeighbors hull_neighbors(const ConvexHull<float, 2>&);
template HullNeighbors hull_neighbors(const ConvexHull<float, 3>&);
template HullNeighbors hull_neighbors(const ConvexHull<double, 2>&);
template HullNeighbors hull_neighbors(const ConvexHull<double, 3>&);

}  // namespace snug
