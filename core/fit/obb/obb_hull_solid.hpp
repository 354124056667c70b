// A convex hull in space, prepared for the search for its smallest box: edges with the normals of box faces that may be
// flush with them, and the vertex farthest along any direction.
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "fit/obb/obb_trials.hpp"
#include "geometry/hull.hpp"

namespace snug::fit {

/// The unit normals of planes that contain an edge and have the hull on one side: an arc of a great circle, from one
/// face's normal to the other's. Long arcs are cut, so that each spans at most 60 degrees. Source: the Gauss map, as J.
/// O'Rourke, "Finding minimal enclosing boxes", 1985, uses it.
struct NormalArc {
  Index edge = 0;               // index in HullSolid::edges
  Index from = 0, to = 0;       // indices in HullSolid::normals
  Vector<double, 3> a, b;       // the same, unit
  double angle = 0;             // between them
  Index opposite = 0;           // the vertex farthest behind the arc's middle
  Vector<double, 3> thickness;  // from that vertex to the edge's first vertex
};

/// A hull whose affine_dim is 3.
class HullSolid {
 public:
  /// count: Ignore or PartCounter, as below.
  template <class Scalar, class Count>
  HullSolid(const ConvexHull<Scalar, 3>& hull, Count& count) : local_(hull.vertices) {
    Corners corners;
    for (const auto& p : hull.vertices) corners.push_back(p.template cast<double>());
    count.count(Operation::kPointsTouched, static_cast<std::int64_t>(corners.size()));
    build(std::move(corners), hull.facets, count);
  }
  template <class Scalar>
  explicit HullSolid(const ConvexHull<Scalar, 3>& hull) : HullSolid(hull, unwatched()) {}

  using Edge = std::array<Index, 2>;  // indices of the hull's vertices

  /// The vertices in the coordinates of LocalPoints: relative to the first, scaled to about 1.
  [[nodiscard]] const std::vector<Vector<double, 3>>& vertices() const { return local_.at; }
  [[nodiscard]] const Vector<double, 3>& at(Index i) const { return local_.at[i]; }
  [[nodiscard]] double size() const { return local_.size; }

  /// The hull's edges, without those inside a triangulated face.
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  /// The normals, those of the hull's facets first.
  [[nodiscard]] const std::vector<Vector<double, 3>>& normals() const { return normals_; }
  [[nodiscard]] const std::vector<NormalArc>& arcs() const { return arcs_; }

  /// The vertex farthest along the direction, within rounding: climbs from a near vertex until no neighbour lies
  /// beyond.
  template <class Count>
  [[nodiscard]] Index farthest(const Vector<double, 3>& direction, Index near, Count& count) const;
  [[nodiscard]] Index farthest(const Vector<double, 3>& direction, Index near) const {
    return farthest(direction, near, unwatched());
  }
  /// Looks up the vertex farthest along a direction close to this one: nearly the farthest, without a search.
  [[nodiscard]] Index far(const Vector<double, 3>& direction) const;
  /// The vertices on the hull's outline as seen along a direction: those of the edges between faces that face it and
  /// faces that face away, and of faces parallel to it. O(their number) time, about O(sqrt n) on a round hull.
  /// direction: unit.
  template <class Count>
  [[nodiscard]] std::vector<Index> outline(const Vector<double, 3>& direction, Count& count) const;
  [[nodiscard]] std::vector<Index> outline(const Vector<double, 3>& direction) const {
    return outline(direction, unwatched());
  }

 private:
  using Corners = std::vector<Vector<double, 3>>;
  using Triangle = std::array<Index, 3>;

  /// Another vertex across an edge, and the facets on both sides of it.
  struct Neighbour {
    Index vertex, left, right;
  };

  static Ignore& unwatched() {
    static Ignore ignore;
    return ignore;
  }

  template <class Count>
  void build(Corners corners, const std::vector<Triangle>& facets, Count& count);
  template <class Edges>
  void link_neighbours(const Edges& edges);
  [[nodiscard]] std::span<const Neighbour> neighbours(Index vertex) const {
    const auto* from = &neighbours_from_[vertex];
    return std::span(neighbours_).subspan(from[0], from[1] - from[0]);
  }
  template <class Count>
  void make_table(Count& count);
  template <class Count>
  void add_arc(const Vector<double, 3>& along, Index from, Index to, Count& count);
  [[nodiscard]] Vector<double, 3> table_direction(int face, int row, int column) const;

  LocalPoints<3> local_;
  std::vector<Edge> edges_;
  std::vector<Vector<double, 3>> normals_;
  std::vector<NormalArc> arcs_;
  std::vector<Neighbour> neighbours_;  // those of vertex i: from neighbours_from_[i] to neighbours_from_[i + 1]
  std::vector<std::size_t> neighbours_from_;
  std::vector<Index> table_;  // a vertex for each cell of a cube's surface
  int cells_ = 1;             // along each side of the cube
};

}  // namespace snug::fit
