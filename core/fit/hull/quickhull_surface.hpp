// The closed surface that Quickhull grows in space: triangles with their neighbours, each with the points that it sees.
// Source: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The Quickhull algorithm for convex hulls", 1996, for facets with
// neighbours and outside sets; D. Gregorius, "Implementing QuickHull", Game Developers Conference, 2014, for the
// horizon and the cone in code, there with half-edges.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/point_set.hpp"

namespace snug::fit {

/// A triangle of the surface. Its plane is in the surface's own coordinates: the sign of normal . p + offset is the
/// side of p, if it is beyond the error bound.
struct Facet {
  std::array<Index, 3> vertices{kNoIndex, kNoIndex, kNoIndex};  // points, counter-clockwise as seen from outside
  std::array<Index, 3> across{kNoIndex, kNoIndex, kNoIndex};    // the facet over the edge from vertex i to the next
  Vector<double, 3> normal;
  double offset = 0;
  double error_bound = 0;
  double height = 0;          // of the farthest point, as the plane measures it
  Index farthest = kNoIndex;  // the head of its list of outside points
  Index count = 0;            // how many outside points it has
  std::uint32_t seen = 0;     // the last eye that it was tested against, and whether it saw it

  [[nodiscard]] bool alive() const { return vertices[0] != kNoIndex; }
  /// Which of its vertices a point is. point: one of them.
  [[nodiscard]] int corner_of(Index point) const {
    if (vertices[0] == point) return 0;
    return vertices[1] == point ? 1 : 2;
  }
};

/// The surface is exactly convex at all times. A facet sees a point only if the point lies strictly above its plane, so
/// that points in that plane never make a facet that is folded or has no area. Facets may be coplanar.
template <class Scalar>
class HullSurface {
 public:
  /// points: not all in one plane.
  explicit HullSurface(PointSpan<Scalar, 3> points);

  /// Starts with a tetrahedron, and assigns every other point to the first facet that sees it. simplex: not in one
  /// plane; its last two are swapped if facets would face inward.
  void start(std::array<Index, 4>& simplex);

  /// The oldest facet with outside points; kNoIndex if there is none.
  [[nodiscard]] Index next_open();

  /// Finds the facets that see the farthest point of a facet, and their horizon.
  void find_horizon(Index facet);
  /// Replaces these by a cone to that point, and assigns their points to it.
  void raise_cone();
  /// The points that no facet saw when points were last assigned.
  [[nodiscard]] const std::vector<Index>& dropped() const { return dropped_; }
  /// Adds the facet's outside points to a list, the farthest first.
  void append_outside(Index facet, std::vector<Index>& list) const;

  /// The farthest point that the last find_horizon found.
  [[nodiscard]] Index eye() const { return eye_; }
  [[nodiscard]] const std::vector<Index>& visible() const { return visible_; }
  [[nodiscard]] std::vector<Index> horizon() const;
  [[nodiscard]] const std::vector<Index>& added() const { return added_; }

  [[nodiscard]] const std::vector<Facet>& facets() const { return facets_; }
  /// Whether the facet and the one across its edge are coplanar, exactly.
  [[nodiscard]] bool flat(Index facet, int edge) const;
  /// How many times a point was tested against a facet.
  [[nodiscard]] std::int64_t tests() const { return tests_; }

 private:
  /// A point in the surface's own coordinates, moved and scaled along each axis so that the cloud about fills the cube
  /// from -1 to 1. So rounding is relative to the cloud's extent along each axis, and not to its distance from the
  /// origin.
  struct Site {
    Vector<double, 3> position;
    Index next = kNoIndex;  // in its facet's list of outside points
    Index border = 0;       // the horizon's edge that starts here
  };
  struct BorderEdge {
    Index from, to;  // points
    Index beyond;    // the facet that stays, across it
    int edge;        // of beyond
  };

  [[nodiscard]] Site& site(Index point) { return sites_[point]; }
  [[nodiscard]] const Site& site(Index point) const { return sites_[point]; }
  [[nodiscard]] Facet& facet(Index f) { return facets_[f]; }
  [[nodiscard]] const Facet& facet(Index f) const { return facets_[f]; }

  [[nodiscard]] double height(const Facet& facet, Index point) const;
  [[nodiscard]] bool sees(const Facet& facet, double height, Index point) const;
  [[nodiscard]] int side_exact(const Facet& facet, Index point) const;
  void put_plane(Facet& facet) const;
  Index add_facet(const std::array<Index, 3>& vertices);
  void give(Index point, const std::vector<Index>& to);
  void order_border();
  void gather_points();
  void remove_visible();

  PointSpan<Scalar, 3> points_;
  std::vector<Site> sites_;
  std::vector<Facet> facets_;
  std::vector<Index> free_;   // places of facets that are gone
  std::vector<Index> queue_;  // facets in the order in which they first had points
  std::size_t queue_at_ = 0;
  std::int64_t tests_ = 0;

  Index eye_ = kNoIndex;
  std::vector<Index> visible_;
  std::vector<Index> added_;
  std::vector<BorderEdge> border_;
  std::vector<BorderEdge> border_scratch_;
  std::vector<Index> orphans_;
  std::vector<Index> dropped_;
};

}  // namespace snug::fit
