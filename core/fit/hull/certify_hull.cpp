#include "fit/hull/certify_hull.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/hull_neighbors.hpp"
#include "geometry/orientation.hpp"
#include "geometry/sort.hpp"
#include "query/contain/contains_hull.hpp"

namespace snug::fit {
namespace {

using Point2 = Vector<double, 2>;
using Point3 = Vector<double, 3>;

// -- Flat -------------------------------------------------------------------------------------------------------------

/// Whether the ring turns left at each vertex, and goes around exactly once.
bool is_convex_ring(const std::vector<Point2>& ring) {
  const std::size_t n = ring.size();
  if (n < 3) return false;
  for (std::size_t i = 0; i < n; ++i)
    if (orient2d(ring[i], ring[(i + 1) % n], ring[(i + 2) % n]) <= 0) return false;
  for (std::size_t i = 1; i + 1 < n; ++i)
    if (orient2d(ring[0], ring[i], ring[i + 1]) <= 0) return false;
  return true;
}

bool is_flat_polygon(const std::vector<Point3>& corners) {
  if (corners.size() < 3) return false;
  const int axis = shadow_axis(corners[0], corners[1], corners[2]);
  if (axis == kNoIndex) return false;
  std::vector<Point2> ring;
  for (const Point3& corner : corners) {
    if (orient3d(corners[0], corners[1], corners[2], corner) != 0) return false;
    ring.push_back(shadow(corner, axis));
  }
  if (orient2d(ring[0], ring[1], ring[2]) < 0) std::reverse(ring.begin(), ring.end());
  return is_convex_ring(ring);
}

// -- Solid ------------------------------------------------------------------------------------------------------------

/// The claimed surface of a hull in space, which may be anything. Call the checks below in their order.
class Surface {
 public:
  using Facets = std::vector<std::array<Index, 3>>;

  Surface(std::vector<Point3> corners, const Facets& facets, HullNeighbors neighbors)
      : corners_(std::move(corners)), facets_(facets), neighbors_(std::move(neighbors)) {}

  /// Whether the surface is closed, no edge bends inward, and it goes around its inside once.
  bool is_convex() {
    if (!is_closed() || !bends_outward()) return false;
    find_center();
    if (const std::optional<bool> once = is_met_once(); once.has_value()) return *once;
    has_center_ = false;
    return no_corner_above();
  }

  /// Whether each vertex of a convex surface is extreme. A vertex inside an edge has two edges that bend, one inside a
  /// face has none.
  [[nodiscard]] bool all_extreme() const {
    return std::all_of(bent_edges_.begin(), bent_edges_.end(), [](Index edges) { return edges >= 3; });
  }

  /// Whether the point lies inside a convex surface or on it. Walks from the last facet found towards the facet that
  /// the ray from the centre to the point passes through.
  [[nodiscard]] bool holds(const Point3& p) {
    if (has_center_)
      for (std::size_t steps = 0; steps < 2 * facets_.size(); ++steps) {
        const std::size_t way_out = edge_towards(at_, p, steps);
        if (way_out == 3) return side_of(at_, p) <= 0;
        at_ = across_[at_][way_out];
      }
    for (std::size_t f = 0; f < facets_.size(); ++f)
      if (side_of(f, p) > 0) return false;
    return true;
  }

 private:
  [[nodiscard]] const Point3& corner(std::size_t f, std::size_t i) const { return corners_[facets_[f][i % 3]]; }
  [[nodiscard]] int side_of(std::size_t f, const Point3& p) const {
    return orient3d(corner(f, 0), corner(f, 1), corner(f, 2), p);
  }
  [[nodiscard]] int side_of_cone(std::size_t f, std::size_t e, const Point3& p) const {
    return orient3d(center_, corner(f, e), corner(f, e + 1), p);
  }

  /// An edge of the facet beyond which the point lies, as seen from the centre; 3 if there is none. Each step begins at
  /// another edge, so that the walk cannot circle for ever in a ring of coplanar facets.
  [[nodiscard]] std::size_t edge_towards(std::size_t f, const Point3& p, std::size_t step) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (side_of_cone(f, (step + i) % 3, p) < 0) return (step + i) % 3;
    return 3;
  }

  /// Finds the facets on both sides of each edge, and returns whether there is exactly one on each side.
  bool is_closed() {
    if (facets_.size() < 4) return false;
    across_.resize(facets_.size());
    for (std::size_t f = 0; f < facets_.size(); ++f)
      for (std::size_t e = 0; e < 3; ++e) {
        const Index from = facets_[f][e], to = facets_[f][(e + 1) % 3];
        const Index there = neighbors_.edge(from, to), back = neighbors_.edge(to, from);
        if (back == kNoIndex || left_of(there) != f) return false;  // an edge is there twice: one facet is missed
        across_[f][e] = left_of(back);
      }
    return true;
  }
  [[nodiscard]] std::size_t left_of(Index edge) const { return neighbors_.facets[edge]; }

  bool bends_outward() {
    bent_edges_.assign(corners_.size(), 0);
    for (std::size_t f = 0; f < facets_.size(); ++f)
      for (std::size_t e = 0; e < 3; ++e) {
        const int side = side_of(f, apex_beyond(f, e));
        if (side > 0) return false;
        if (side < 0) ++bent_edges_[facets_[f][e]];
      }
    return true;
  }
  [[nodiscard]] const Point3& apex_beyond(std::size_t f, std::size_t e) const {
    const std::size_t g = across_[f][e];
    for (std::size_t i = 0; i < 2; ++i)
      if (facets_[g][i] != facets_[f][e] && facets_[g][i] != facets_[f][(e + 1) % 3]) return corner(g, i);
    return corner(g, 2);
  }

  /// Takes the mean of the vertices as the centre, if every facet has it on its inner side.
  void find_center() {
    center_ = Point3::Zero();
    for (const Point3& c : corners_) center_ += (c - corners_[0]) / static_cast<double>(corners_.size());
    center_ += corners_[0];
    has_center_ = true;
    for (std::size_t f = 0; f < facets_.size() && has_center_; ++f) has_center_ = side_of(f, center_) < 0;
  }

  /// Whether a ray from the centre meets one facet only. None if there is no centre, or if rounding leaves no ray
  /// inside any facet.
  [[nodiscard]] std::optional<bool> is_met_once() const {
    for (std::size_t f = 0; f < facets_.size() && has_center_; ++f) {
      const Point3& a = corner(f, 0);
      const Point3 ahead = a + ((corner(f, 1) - a) / 3 + (corner(f, 2) - a) / 3);
      const auto within = [&](std::size_t g, int least) {
        return std::min({side_of_cone(g, 0, ahead), side_of_cone(g, 1, ahead), side_of_cone(g, 2, ahead)}) >= least;
      };
      if (!within(f, 1)) continue;
      for (std::size_t g = 0; g < facets_.size(); ++g)
        if (g != f && within(g, 0)) return false;
      return true;
    }
    return std::nullopt;
  }

  /// Whether no vertex is above a facet: then each is a part of the surface, and none overlap, as no edge occurs twice.
  [[nodiscard]] bool no_corner_above() const {
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      if (collinear(corner(f, 0), corner(f, 1), corner(f, 2))) return false;
      for (const Point3& c : corners_)
        if (side_of(f, c) > 0) return false;
    }
    return true;
  }

  std::vector<Point3> corners_;
  const Facets& facets_;
  HullNeighbors neighbors_;
  std::vector<std::array<std::size_t, 3>> across_;
  std::vector<Index> bent_edges_;  // for each vertex
  Point3 center_;
  bool has_center_ = false;
  std::size_t at_ = 0;
};

// -- Both -------------------------------------------------------------------------------------------------------------

/// Finds vertices by their coordinates.
template <class Scalar, int Dim>
class VertexPlaces {
 public:
  explicit VertexPlaces(const ConvexHull<Scalar, Dim>& hull) : hull_(hull), order_(hull.vertices.size()) {
    std::iota(order_.begin(), order_.end(), Index{0});
    sort_stably(order_, [&](Index a, Index b) { return before(at(a), at(b)); });
  }

  /// The vertex with these coordinates; kNoIndex if there is none.
  [[nodiscard]] Index find(const Vector<Scalar, Dim>& p) const {
    const auto found = std::lower_bound(order_.begin(), order_.end(), p,
                                        [&](Index a, const Vector<Scalar, Dim>& q) { return before(at(a), q); });
    return found != order_.end() && at(*found) == p ? *found : kNoIndex;
  }

 private:
  [[nodiscard]] const Vector<Scalar, Dim>& at(Index i) const { return hull_.vertices[i]; }
  [[nodiscard]] static bool before(const Vector<Scalar, Dim>& a, const Vector<Scalar, Dim>& b) {
    for (int axis = 0; axis < Dim; ++axis)
      if (a[axis] != b[axis]) return a[axis] < b[axis];
    return false;
  }

  const ConvexHull<Scalar, Dim>& hull_;
  std::vector<Index> order_;
};

template <class Scalar, int Dim>
class Prover {
 public:
  Prover(const ConvexHull<Scalar, Dim>& hull, PointSpan<Scalar, Dim> points) : hull_(hull), points_(points) {}

  HullProof run() {
    if (!well_formed()) return {.outside = points_.size()};
    prove_shape();
    hold_points();
    return proof_;
  }

  double max_outside(std::span<const double> at_most) {
    if (!well_formed()) return 0;
    prove_shape();
    std::vector<Index> order(static_cast<std::size_t>(points_.size()));
    std::iota(order.begin(), order.end(), Index{0});
    std::sort(order.begin(), order.end(),
              [&](Index a, Index b) { return at_most[a] != at_most[b] ? at_most[a] > at_most[b] : a < b; });
    double most = 0;
    for (const Index i : order) {
      if (at_most[i] <= most) break;
      if (!holds(points_[i])) most = std::max(most, query::outside_by(hull_, points_[i]));
    }
    return most;
  }

 private:
  /// Whether every index is in range, and there are as many vertices and facets as the dimension asks for.
  [[nodiscard]] bool well_formed() const {
    const std::size_t n = hull_.vertices.size();
    const int dim = hull_.affine_dim;
    if (dim < 0 || dim > Dim || hull_.indices.size() != n) return false;
    if (dim < 2 ? n != static_cast<std::size_t>(dim) + 1 : n < 3) return false;
    if (dim < Dim && !hull_.facets.empty()) return false;
    const auto in = [](Index i, std::size_t size) { return i >= 0 && static_cast<std::size_t>(i) < size; };
    for (const Index i : hull_.indices)
      if (!in(i, points_.size())) return false;
    for (const auto& facet : hull_.facets)
      for (const Index i : facet)
        if (!in(i, n)) return false;
    return true;
  }

  [[nodiscard]] std::vector<Vector<double, Dim>> corners() const {
    std::vector<Vector<double, Dim>> corners;
    for (const auto& v : hull_.vertices) corners.push_back(v.template cast<double>());
    return corners;
  }

  void prove_shape() {
    proof_.extreme = true;  // a ring, or fewer points, leave nothing to check
    if (hull_.affine_dim < 2) {
      proof_.convex = hull_.affine_dim == 0 || hull_.vertices[0] != hull_.vertices[1];
      return;
    }
    if constexpr (Dim == 2) {
      proof_.convex = is_convex_ring(corners()) && hull_.facets.size() == hull_.vertices.size();
      for (std::size_t i = 0; i < hull_.facets.size(); ++i)
        if (hull_.facets[i] != std::array{static_cast<Index>(i), static_cast<Index>((i + 1) % hull_.vertices.size())})
          proof_.convex = false;
    } else if (hull_.affine_dim == 2) {
      proof_.convex = is_flat_polygon(corners());
    } else {
      surface_.emplace(corners(), hull_.facets, hull_neighbors(hull_));
      proof_.convex = surface_->is_convex();
      proof_.extreme = proof_.convex && surface_->all_extreme();
    }
  }

  /// Checks that all points are inside, and that each vertex is the point of its index, the first if some coincide.
  void hold_points() {
    proof_.of_points = true;
    const VertexPlaces<Scalar, Dim> places(hull_);
    for (std::size_t i = 0; i < hull_.indices.size(); ++i)
      if (points_[hull_.indices[i]] != hull_.vertices[i]) proof_.of_points = false;
    for (Index i = 0; i < points_.size(); ++i) {
      const Index vertex = places.find(points_[i]);
      if (vertex != kNoIndex && i < hull_.indices[vertex]) proof_.of_points = false;
      const bool is_held = vertex != kNoIndex && proof_.convex;
      if (!is_held && !holds(points_[i])) {
        ++proof_.outside;
        proof_.max_outside = std::max(proof_.max_outside, query::outside_by(hull_, points_[i]));
      }
    }
  }

  [[nodiscard]] bool holds(const Vector<Scalar, Dim>& p) {
    if constexpr (Dim == 3)
      if (surface_ && proof_.convex) return surface_->holds(p.template cast<double>());
    return query::contains(hull_, p);
  }

  const ConvexHull<Scalar, Dim>& hull_;
  PointSpan<Scalar, Dim> points_;
  std::optional<Surface> surface_;
  HullProof proof_;
};

}  // namespace

template <class Scalar, int Dim>
HullProof prove_hull(const ConvexHull<Scalar, Dim>& hull, PointSpan<Scalar, Dim> points) {
  return Prover<Scalar, Dim>(hull, points).run();
}

template <class Scalar, int Dim>
Certificate certify(const Fit<ConvexHull<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points, bool claims_optimal) {
  const HullProof proof = prove_hull(fit.volume, points);
  Certificate certificate;
  certificate.outside = proof.outside;
  certificate.max_outside = proof.max_outside;
  certificate.contains = proof.outside == 0;
  certificate.on_boundary = proof.of_points && proof.extreme && fit.support == fit.volume.indices;
  if (claims_optimal) certificate.optimal = proof.holds();
  return certificate;
}

template <class Scalar, int Dim>
double max_outside(const ConvexHull<Scalar, Dim>& hull, PointSpan<Scalar, Dim> points,
                   std::span<const double> at_most) {
  return Prover<Scalar, Dim>(hull, points).max_outside(at_most);
}

template double max_outside(const ConvexHull<double, 2>&, PointSpan<double, 2>, std::span<const double>);
template double max_outside(const ConvexHull<double, 3>&, PointSpan<double, 3>, std::span<const double>);

#define SNUG_INSTANTIATE(Scalar, Dim)                                                                                  \
  template HullProof prove_hull(const ConvexHull<Scalar, Dim>&, PointSpan<Scalar, Dim>);                               \
  template Certificate certify(const Fit<ConvexHull<Scalar, Dim>>&, PointSpan<Scalar, Dim>, bool);
SNUG_INSTANTIATE(float, 2)
SNUG_INSTANTIATE(float, 3)
SNUG_INSTANTIATE(double, 2)
SNUG_INSTANTIATE(double, 3)
#undef SNUG_INSTANTIATE

}  // namespace snug::fit
