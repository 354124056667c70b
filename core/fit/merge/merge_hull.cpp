#include <algorithm>

#include "fit/hull/quickhull.hpp"
#include "fit/merge/merge.hpp"

namespace snug::fit {
namespace {

/// Whether each vertex of the merged hull is one of the second hull's, which follow `first` others in its point set. Of
/// coincident points, the vertex is the first in the set, so the second hull may have it under another index.
template <class Scalar, int Dim>
bool is_second(const ConvexHull<Scalar, Dim>& merged, const ConvexHull<Scalar, Dim>& second, std::size_t first) {
  for (std::size_t i = 0; i < merged.vertices.size(); ++i) {
    if (static_cast<std::size_t>(merged.indices[i]) >= first) continue;
    if (std::find(second.vertices.begin(), second.vertices.end(), merged.vertices[i]) == second.vertices.end())
      return false;
  }
  return true;
}

}  // namespace

template <class Scalar, int Dim>
ConvexHull<Scalar, Dim> merge(const ConvexHull<Scalar, Dim>& a, const ConvexHull<Scalar, Dim>& b) {
  if (b.vertices.empty()) return a;
  if (a.vertices.empty()) return b;
  std::vector<Vector<Scalar, Dim>> vertices = a.vertices;
  vertices.insert(vertices.end(), b.vertices.begin(), b.vertices.end());
  const auto set = *PointSet<Scalar, Dim>::make(std::move(vertices));  // vertices are points of a set: never refused
  ConvexHull<Scalar, Dim> merged = quickhull(set.span()).volume;
  const std::size_t first = a.vertices.size();
  if (std::all_of(merged.indices.begin(), merged.indices.end(),
                  [&](Index i) { return static_cast<std::size_t>(i) < first; }))
    return a;
  if (is_second(merged, b, first)) return b;
  return merged;
}

template ConvexHull<float, 2> merge(const ConvexHull<float, 2>&, const ConvexHull<float, 2>&);
template ConvexHull<float, 3> merge(const ConvexHull<float, 3>&, const ConvexHull<float, 3>&);
template ConvexHull<double, 2> merge(const ConvexHull<double, 2>&, const ConvexHull<double, 2>&);
template ConvexHull<double, 3> merge(const ConvexHull<double, 3>&, const ConvexHull<double, 3>&);

}  // namespace snug::fit
