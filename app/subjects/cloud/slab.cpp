// Draws the slab of a k-DOP that a step has found: its two planes (in 2-D lines), its direction, the points on it.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/subjects/cloud/draw.hpp"
#include "lesson/point_subject.hpp"

namespace snug::app {
namespace {

using Slab = CloudShown::Slab;

constexpr float kSlabAside = 22;   // from the points to the arrow, pixels
constexpr float kSlabBeyond = 18;  // how far the arrow and the lines of the plane go on, pixels
constexpr float kSlabFill = 0.07f;

/// How far the points reach across a slab's direction.
struct Across {
  Point3 axis;  // unit
  double least = 0, greatest = 0;

  Across(const Brush& brush, const Point3& along) : axis(along) {
    for (Index i = 0; i < lesson::count_of(brush.session.stage().subject()); ++i) {
      const double at = axis.dot(brush.session.stage().subject().at(i));
      least = i == 0 ? at : std::min(least, at), greatest = i == 0 ? at : std::max(greatest, at);
    }
  }
  void widen(double by) { least -= by, greatest += by; }
};

/// Whether words of that size have room on the stage beyond the tip of an arrow.
bool fits_beyond(const Brush& brush, ImVec2 tip, ImVec2 way, ImVec2 size) {
  constexpr float kGap = 6, kMargin = 4;
  const float length = std::max(std::hypot(way.x, way.y), 1e-3f);
  const float x = tip.x + way.x / length * (kGap + size.x / 2), y = tip.y + way.y / length * (kGap + size.y / 2);
  const Rect& stage = brush.rect;
  return std::abs(x - stage.x - stage.width / 2) + size.x / 2 + kMargin < stage.width / 2 &&
         std::abs(y - stage.y - stage.height / 2) + size.y / 2 + kMargin < stage.height / 2;
}

/// The arrow from one plane to the other, and its name: beyond the tip, or where the stage ends there beside the arrow.
/// inside: where the points are, on the arrow's other side.
void draw_direction(Brush& brush, const Slab& slab, const Point3& from, const Point3& to, const Point3& inside) {
  const Palette& p = brush.p;
  const double beyond = kSlabBeyond / brush.canvas.camera.scale_at(to);
  const ImVec2 tail = brush.at(from), tip = brush.at(to + slab.direction * beyond);
  arrow(brush.list, tail, tip, p.examined, brush.stroke(1.1f));
  brush.canvas.obstacles.segments.push_back({tail.x, tail.y, tip.x, tip.y});
  const std::string words = "slab " + std::to_string(slab.number) + ": " + slab.axis;
  const ImVec2 way{tip.x - tail.x, tip.y - tail.y}, within = brush.at(inside);
  const bool beyond_tip = fits_beyond(brush, tip, way, measure(brush.look, Face::kSemiBold, 13, words));
  const ImVec2 at = beyond_tip ? tip : ImVec2{(tail.x + tip.x) / 2, (tail.y + tip.y) / 2};
  brush.label(at, 6, beyond_tip ? way : ImVec2{at.x - within.x, at.y - within.y}, words, p.examined_text,
              Face::kSemiBold, 13);
}

void draw_plane_lines(Brush& brush, const Slab& slab) {
  const Palette& p = brush.p;
  Across across(brush, Point3(slab.direction[1], -slab.direction[0], 0));
  if (across.axis[1] > 0) across = Across(brush, -across.axis);  // the arrow is below the points
  const double pixel = 1 / brush.canvas.camera.scale_at(Point3::Zero());
  across.widen(kSlabAside * pixel);
  const auto at = [&](double along, double aside) { return Point3(slab.direction * along + across.axis * aside); };
  const double end = across.greatest + (kSlabBeyond - kSlabAside) * pixel, begin = across.least;
  const std::array<ImVec2, 4> band{brush.at(at(slab.least, begin)), brush.at(at(slab.greatest, begin)),
                                   brush.at(at(slab.greatest, end)), brush.at(at(slab.least, end))};
  brush.list->AddConvexPolyFilled(band.data(), 4, with_alpha(p.examined, kSlabFill));
  for (const double along : {slab.least, slab.greatest})
    draw_line(brush.canvas, at(along, begin), at(along, across.greatest + kSlabBeyond * pixel),
              {Stroke::kSolid, p.examined, brush.stroke(0.9f)});
  draw_direction(brush, slab, at(slab.least, across.greatest), at(slab.greatest, across.greatest),
                 at((slab.least + slab.greatest) / 2, (across.least + across.greatest) / 2));
}

/// From a vertex of one plane's outline to that of the other.
struct SlabEdge {
  Point3 from, to;
};

/// The lowest edge between the two outlines, if one lies within the free room of the stage the lowest of those.
const SlabEdge& edge_for_arrow(const Brush& brush, const std::array<SlabEdge, 4>& edges) {
  const auto lower_end = [&](const SlabEdge& edge) { return std::max(brush.at(edge.from).y, brush.at(edge.to).y); };
  const auto rank = [&](const SlabEdge& edge) {
    const Rect& stage = brush.rect;
    const auto free = [&](ImVec2 at) {
      return at.x > stage.x && at.x < stage.x + stage.width && at.y > stage.y &&
             at.y < brush.canvas.camera.free_bottom();
    };
    return std::pair(free(brush.at(edge.from)) && free(brush.at(edge.to)), lower_end(edge));
  };
  return *std::max_element(edges.begin(), edges.end(),
                           [&](const SlabEdge& a, const SlabEdge& b) { return rank(a) < rank(b); });
}

void draw_planes(Brush& brush, const Slab& slab) {
  const Palette& p = brush.p;
  const Camera& camera = brush.canvas.camera;
  // Two directions in the planes, one of them as level as can be.
  Point3 level = slab.direction.cross(Point3(Point3::UnitY()));
  if (level.norm() < 1e-6) level = Point3::UnitX();
  level.normalize();
  Across u(brush, level), v(brush, Point3(slab.direction.cross(level).normalized()));
  const double margin = 0.08 * std::max(u.greatest - u.least, v.greatest - v.least);
  u.widen(margin), v.widen(margin);
  const auto corner = [&](double along, int i) {
    return Point3(slab.direction * along + u.axis * (i == 0 || i == 3 ? u.least : u.greatest) +
                  v.axis * (i < 2 ? v.least : v.greatest));
  };
  const Point3 middle = corner(slab.least, 0) + (corner(slab.least, 2) - corner(slab.least, 0)) / 2;
  const bool low_first = slab.direction.dot(camera.eye() - middle) > 0;  // the farther plane is drawn first
  for (const bool low : {low_first, !low_first}) {
    const double along = low ? slab.least : slab.greatest;
    std::array<ImVec2, 4> outline;
    for (int i = 0; i < 4; ++i) outline[i] = brush.at(corner(along, i));
    const bool near = low != low_first;
    brush.list->AddConvexPolyFilled(outline.data(), 4, with_alpha(p.examined, kSlabFill));
    path(brush.list, outline, true, Stroke::kSolid, with_alpha(p.examined, near ? 1.0f : 0.6f),
         brush.stroke(near ? 0.9f : 0.6f));
  }
  std::array<SlabEdge, 4> edges;
  for (int i = 0; i < 4; ++i) edges[i] = {corner(slab.least, i), corner(slab.greatest, i)};
  const SlabEdge& edge = edge_for_arrow(brush, edges);
  draw_direction(brush, slab, edge.from, edge.to, (corner(slab.least, 0) + corner(slab.greatest, 2)) / 2);
}

}  // namespace

void draw_slab(Brush& brush, const CloudShown& shown) {
  if (!shown.slab) return;
  if (brush.dim() == 2) draw_plane_lines(brush, *shown.slab);
  else draw_planes(brush, *shown.slab);
}

void mark_slab(Brush& brush, const CloudShown& shown) {
  if (!shown.slab) return;
  for (const Index i : {shown.slab->low, shown.slab->high}) {
    mark_point(brush, i);
    ring(brush.list, brush.at(brush.point(i)), (kRing + 2) * brush.p.mark, brush.p.examined, brush.stroke());
  }
}

void name_slab(PointNames& names, const CloudShown& shown) {
  if (!shown.slab) return;
  const auto name = [&](Index i, const char* word) {
    names.name(i, names.brush.session.stage().subject().name_of(i) + word, names.brush.p.examined_text, Face::kSemiBold,
               17 * names.brush.p.mark);
  };
  const bool one = shown.slab->low == shown.slab->high;
  name(shown.slab->low, one ? " least and greatest" : " least");
  if (!one) name(shown.slab->high, " greatest");
}

}  // namespace snug::app
