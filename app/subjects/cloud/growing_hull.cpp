// Draws the hull that Quickhull grows: its edges or facets, the one at hand, what the farthest point sees, and which
// points are still outside of what.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "app/subjects/cloud/draw.hpp"
#include "lesson/figures.hpp"

namespace snug::app {
namespace {

using lesson::GrowingFacet;
using lesson::GrowingHull;

constexpr float kSeenFill = 0.4f, kAddedFill = 0.24f;  // alpha
constexpr std::size_t kMostJoined = 200;               // points that are joined to their edges or facets
constexpr float kFaded = 0.72f;

/// The hull's part of the stage, for one frame.
class HullPicture {
 public:
  HullPicture(Brush& brush, const GrowingHull& hull) : brush_(brush), p_(brush.p), hull_(hull) {}

  void draw_plane() {
    fill_polygon();
    if (hull_.replaced.size() == 2) segment(hull_.replaced[0], hull_.replaced[1], Stroke::kDotted, p_.previous, 1);
    for (std::size_t f = 0; f < hull_.facets.size(); ++f) {
      const GrowingFacet& edge = hull_.facets[f];
      if (!edge.alive()) continue;
      join(edge, is_at(f));
      segment(edge.vertices[0], edge.vertices[1], Stroke::kSolid, p_.current,
              among(hull_.added, static_cast<Index>(f)) ? 1.8f : 1.0f);
    }
    if (hull_.at == kNoIndex) return;
    // The first two edges lie on one another: the one at hand is drawn over the other.
    const GrowingFacet& at_hand = hull_.facets[hull_.at];
    segment(at_hand.vertices[0], at_hand.vertices[1], Stroke::kSolid, p_.examined, 1.8f);
  }

  void draw_space(const std::vector<std::pair<Index, Index>>& flat) {
    const bool looks = !hull_.seen.empty();
    draw_facets([&](Index f) { return !is_lit(f) && !is_fresh(f); },
                {Stroke::kSolid, p_.current, brush_.stroke(0.7f), p_.fill});
    draw_facets([&](Index f) { return is_fresh(f); }, {Stroke::kSolid, p_.support, brush_.stroke(0.8f), kAddedFill});
    draw_facets([&](Index f) { return is_lit(f); }, {Stroke::kSolid, p_.examined, brush_.stroke(0.9f), kSeenFill});
    for (const auto& [a, b] : flat) {
      segment(a, b, Stroke::kSolid, with_alpha(p_.ground, 0.85f), 1.4f);
      segment(a, b, Stroke::kDotted, p_.optimum, 0.8f);
    }
    if (!looks && hull_.at != kNoIndex) join(hull_.facets[hull_.at], true);
    draw_horizon();
  }

  /// The farthest point's distance, as the perpendicular to its edge's line or its facet's plane.
  void draw_distance() {
    if (hull_.eye == kNoIndex || hull_.at == kNoIndex) return;
    const GrowingFacet& facet = hull_.facets[hull_.at];
    const Point3 eye = place(hull_.eye), foot = foot_of(facet, eye);
    if (facet.vertices.size() == 2) extend_to(facet, foot);
    draw_line(brush_.canvas, eye, foot, {Stroke::kDashed, p_.examined, brush_.stroke(0.9f)});
    const ImVec2 a = brush_.at(eye), b = brush_.at(foot);
    brush_.label({(a.x + b.x) / 2, (a.y + b.y) / 2}, 5, {-(b.y - a.y), b.x - a.x}, lesson::number_text(hull_.distance),
                 p_.examined_text, Face::kSemiBold, 13);
  }

  void fade_dropped() {
    for (const Index i : hull_.dropped)
      disc(brush_.list, brush_.at(place(i)), (brush_.point_radius + 1.5f) * std::sqrt(p_.mark),
           with_alpha(p_.ground, kFaded));
    for (const Index i : hull_.just_dropped)
      cross(brush_.list, brush_.at(place(i)), 5 * p_.mark, p_.wrong, brush_.stroke(0.8f));
  }

 private:
  [[nodiscard]] Point3 place(Index i) const { return brush_.session.stage().subject().at(i); }
  [[nodiscard]] bool is_at(std::size_t f) const { return static_cast<Index>(f) == hull_.at; }
  [[nodiscard]] bool is_lit(Index f) const { return hull_.seen.empty() ? f == hull_.at : among(hull_.seen, f); }
  [[nodiscard]] bool is_fresh(Index f) const { return hull_.rounds > 0 && among(hull_.added, f); }

  void segment(Index a, Index b, Stroke stroke, Color color, float share) {
    draw_line(brush_.canvas, place(a), place(b), {stroke, color, brush_.stroke(share)});
  }

  void fill_polygon() {
    std::vector<ImVec2> corners;
    for (const Index i : hull_.vertices()) corners.push_back(brush_.at(place(i)));
    corners = convex_outline(std::move(corners));
    if (corners.size() > 2)
      brush_.list->AddConvexPolyFilled(corners.data(), static_cast<int>(corners.size()),
                                       with_alpha(p_.current, p_.fill));
  }

  /// Joins the points outside to the edge or facet that they belong to.
  void join(const GrowingFacet& facet, bool at_hand) {
    if (facet.outside.size() > kMostJoined) return;
    for (const Index i : facet.outside) {
      const Point3 to = facet.vertices.size() == 2 ? nearest_on(facet, place(i)) : middle_of_facet(facet);
      draw_line(brush_.canvas, place(i), to,
                {Stroke::kDotted, at_hand ? p_.examined : with_alpha(p_.previous, 0.7f), brush_.stroke(0.6f)});
    }
  }

  [[nodiscard]] Point3 middle_of_facet(const GrowingFacet& facet) const {
    return (place(facet.vertices[0]) + place(facet.vertices[1]) + place(facet.vertices[2])) / 3;
  }
  /// Where a point is along an edge: 0 at its start, 1 at its end.
  [[nodiscard]] double along(const GrowingFacet& edge, const Point3& point) const {
    const Point3 a = place(edge.vertices[0]), way = place(edge.vertices[1]) - a;
    return way.squaredNorm() > 0 ? way.dot(point - a) / way.squaredNorm() : 0;
  }
  [[nodiscard]] Point3 at_share(const GrowingFacet& edge, double share) const {
    const Point3 a = place(edge.vertices[0]);
    return a + (place(edge.vertices[1]) - a) * share;
  }
  [[nodiscard]] Point3 nearest_on(const GrowingFacet& edge, const Point3& point) const {
    return at_share(edge, std::clamp(along(edge, point), 0.0, 1.0));
  }
  [[nodiscard]] Point3 foot_of(const GrowingFacet& facet, const Point3& point) const {
    if (facet.vertices.size() == 2) return at_share(facet, along(facet, point));
    const Point3 a = place(facet.vertices[0]);
    const Point3 normal = (place(facet.vertices[1]) - a).cross(place(facet.vertices[2]) - a).normalized();
    return point - normal * normal.dot(point - a);
  }
  /// Draws the edge's line on to a foot that lies beyond its ends.
  void extend_to(const GrowingFacet& edge, const Point3& foot) {
    draw_line(brush_.canvas, nearest_on(edge, foot), foot, {Stroke::kDotted, p_.examined, brush_.stroke(0.7f)});
  }

  template <class Wanted>
  void draw_facets(Wanted wanted, const VolumeStyle& style) {
    const std::vector<Index> vertices = hull_.vertices();
    Polytope some;
    for (const Index i : vertices) some.corners.push_back(place(i));
    for (std::size_t f = 0; f < hull_.facets.size(); ++f) {
      if (!hull_.facets[f].alive() || !wanted(static_cast<Index>(f))) continue;
      std::vector<int>& face = some.faces.emplace_back();
      for (const Index i : hull_.facets[f].vertices)
        face.push_back(static_cast<int>(std::lower_bound(vertices.begin(), vertices.end(), i) - vertices.begin()));
    }
    draw_volume(brush_.canvas, some, style);
  }

  void draw_horizon() {
    std::vector<ImVec2> ring;
    for (const Index i : hull_.horizon) ring.push_back(brush_.at(place(i)));
    if (ring.empty()) return;
    path(brush_.list, ring, true, Stroke::kSolid, p_.ground, brush_.stroke(3.4f));
    path(brush_.list, ring, true, Stroke::kSolid, p_.examined, brush_.stroke(2.2f));
  }

  Brush& brush_;
  const Palette& p_;
  const GrowingHull& hull_;
};

}  // namespace

void draw_growing_hull(Brush& brush, const CloudShown& shown) {
  if (!shown.growing) return;
  HullPicture picture(brush, *shown.growing);
  picture.fade_dropped();
  if (shown.volume) return;
  if (brush.dim() == 2) picture.draw_plane();
  else picture.draw_space(shown.flat);
  picture.draw_distance();
}

}  // namespace snug::app
