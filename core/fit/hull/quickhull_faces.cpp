#include "fit/hull/quickhull_faces.hpp"

#include <utility>

namespace snug::fit {
namespace {

template <class Scalar>
class FaceMerger {
 public:
  FaceMerger(const HullSurface<Scalar>& surface, PointSpan<Scalar, 3> points)
      : surface_(surface), points_(points), edges_(surface.facets().size()), place_(points.size(), kNoIndex) {}

  MergedFaces<Scalar> run() {
    judge_edges();
    keep_extreme_points();
    for (Index f = 0; f < static_cast<Index>(edges_.size()); ++f)
      for (std::size_t e = 0; e < 3; ++e)
        if (facet(f).alive() && edge(f, e) == Edge::kSharp) cut_face(f, e);
    return std::move(result_);
  }

 private:
  enum class Edge : unsigned char { kSharp, kFlat, kWalked };

  [[nodiscard]] const Facet& facet(Index f) const { return surface_.facets()[f]; }
  [[nodiscard]] Edge& edge(Index f, std::size_t e) { return edges_[f][e]; }
  [[nodiscard]] Index& place(Index point) { return place_[point]; }

  /// Counts each point's sharp edges in its place, until keep_extreme_points puts the vertex there.
  void judge_edges() {
    for (Index f = 0; f < static_cast<Index>(edges_.size()); ++f) {
      if (!facet(f).alive()) continue;
      for (std::size_t e = 0; e < 3; ++e) {
        const bool flat = surface_.flat(f, static_cast<int>(e));
        edge(f, e) = flat ? Edge::kFlat : Edge::kSharp;
        Index& sharp = place(facet(f).vertices[e]);
        sharp = (sharp == kNoIndex ? 0 : sharp) + (flat ? 0 : 1);
      }
    }
  }

  /// A point of the surface with no sharp edge lies inside a face, one with two inside an edge.
  void keep_extreme_points() {
    ConvexHull<Scalar, 3>& hull = result_.hull;
    for (Index i = 0; i < points_.size(); ++i) {
      if (place(i) == kNoIndex) continue;
      if (place(i) < 3) {
        place(i) = kNoIndex;
        result_.dropped.push_back(i);
        continue;
      }
      place(i) = static_cast<Index>(hull.indices.size());
      hull.indices.push_back(i);
      hull.vertices.push_back(points_[i]);
    }
  }

  /// Walks around the face on the left of a sharp edge, and cuts it into triangles. A face is convex, so it has one
  /// border.
  void cut_face(const Index first_facet, const std::size_t first_edge) {
    corners_.clear();
    bool merged = false;
    Index f = first_facet;
    std::size_t e = first_edge;
    do {
      edge(f, e) = Edge::kWalked;
      if (const Index corner = place(facet(f).vertices[e]); corner != kNoIndex) corners_.push_back(corner);
      e = (e + 1) % 3;
      for (; edge(f, e) == Edge::kFlat; merged = true) {
        const Index pivot = facet(f).vertices[e];
        f = facet(f).across[e];
        e = facet(f).corner_of(pivot);
      }
    } while (f != first_facet || e != first_edge);
    if (merged) ++result_.faces;
    for (std::size_t i = 1; i + 1 < corners_.size(); ++i)
      result_.hull.facets.push_back({corners_[0], corners_[i], corners_[i + 1]});
  }

  const HullSurface<Scalar>& surface_;
  PointSpan<Scalar, 3> points_;
  std::vector<std::array<Edge, 3>> edges_;
  std::vector<Index> place_;    // of each point among the hull's vertices
  std::vector<Index> corners_;  // of the current face
  MergedFaces<Scalar> result_;
};

}  // namespace

template <class Scalar>
MergedFaces<Scalar> merge_faces(const HullSurface<Scalar>& surface, PointSpan<Scalar, 3> points) {
  return FaceMerger<Scalar>(surface, points).run();
}
template MergedFaces<float> merge_faces(const HullSurface<float>&, PointSpan<float, 3>);
template MergedFaces<double> merge_faces(const HullSurface<double>&, PointSpan<double, 3>);

}  // namespace snug::fit
