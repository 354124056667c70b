// Draws what is tested against a frustum. For a ball also the frustum with its planes moved out by the radius, or
// wrongly in, and in 2-D where the centre of a ball that touches the frustum really is: the two differ at the vertices,
// and there the test errs.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/box_marks.hpp"
#include "app/subjects/frustum/draw.hpp"
#include "geometry/frustum_corners.hpp"
#include "lesson/figures.hpp"

namespace snug::app {
namespace {

using lesson::BoxPair;

/// The frustum with its planes moved out, in the order of a box's vertices; empty if that has no vertices.
template <int Dim>
Polytope grown(const BoxPair& pair, double by) {
  const auto frustum = lesson::frustum_of<Dim>(pair);
  if (!frustum) return {};
  auto planes = frustum->planes();
  for (Plane<double, Dim>& plane : planes) plane.d -= by * plane.normal.norm();
  const auto moved = Frustum<double, Dim>::make(planes);
  if (!moved) return {};
  const auto corners = corners_of(*moved);
  if (!corners) return {};
  Polytope solid = solid_of(pair);
  for (std::size_t c = 0; c < corners->size(); ++c) {
    std::size_t bits = 0;
    for (int side = 0; side < Dim; ++side) {
      const auto [axis, positive] = lesson::face_on_plane(Dim, 2 * side + static_cast<int>(c >> side & 1));
      if (positive) bits |= std::size_t{1} << axis;
    }
    solid.corners[bits].head<Dim>() = (*corners)[c];
  }
  return solid;
}

/// In 2-D, the places of the centre where a ball touches the frustum from outside: its outline, rounded at the
/// vertices.
std::vector<Point3> rounded_outline(const BoxPair& pair, double radius) {
  constexpr int kArc = 10;
  const Polytope solid = solid_of(pair);
  std::vector<Point3> around;
  for (const int corner : solid.faces.front()) around.push_back(solid.corners[corner]);
  double area = 0;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const Point3 &a = around[i], &b = around[(i + 1) % around.size()];
    area += a[0] * b[1] - a[1] * b[0];
  }
  if (area < 0) std::reverse(around.begin(), around.end());
  std::vector<Point3> outline;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const Point3& at = around[i];
    const Point3 before = at - around[(i + around.size() - 1) % around.size()],
                 after = around[(i + 1) % around.size()] - at;
    const double from = std::atan2(-before[0], before[1]);
    double to = std::atan2(-after[0], after[1]);
    if (to < from) to += 2 * std::numbers::pi;
    for (int k = 0; k <= kArc; ++k) {
      const double angle = from + (to - from) * k / kArc;
      outline.push_back(at + Point3(std::cos(angle), std::sin(angle), 0) * radius);
    }
  }
  return outline;
}

/// Draws the moved planes; those that the method does not test are thin.
void draw_moved(Brush& brush, const BoxPair& pair, const MovedPlanes& moved) {
  const Palette& p = brush.p;
  const Polytope solid = pair.dim == 2 ? grown<2>(pair, moved.by) : grown<3>(pair, moved.by);
  if (solid.corners.empty()) return;
  const bool out = moved.by >= 0;
  draw_volume(brush.canvas, solid,
              {Stroke::kDashed, out ? p.previous : p.wrong, brush.stroke(moved.tested ? (out ? 0.7f : 1.1f) : 0.4f)});
  const std::size_t label_at = pair.dim == 2 ? 1 : 5;
  const ImVec2 end = brush.at(solid.corners[label_at]), middle = brush.at(pair.boxes[1].center);
  const ImVec2 away{end.x - middle.x, end.y - middle.y};
  brush.label(end, 8, out ? away : ImVec2{-away.x, -away.y}, out ? "planes moved out by r" : "moved in by r: wrong",
              out ? p.previous_text : p.wrong_text, Face::kRegular, 13, out);
}

/// In 2-D, draws where the centre of a ball is that just touches the frustum.
void draw_rounded(Brush& brush, const BoxPair& pair, double radius) {
  if (pair.dim == 3) return;
  std::vector<ImVec2> outline;
  for (const Point3& at : rounded_outline(pair, radius)) outline.push_back(brush.at(at));
  path(brush.list, outline, true, Stroke::kDotted, brush.p.optimum, brush.stroke(0.8f));
}

void draw_ball(Brush& brush, const BoxPair& pair, Color color) {
  const Obb<double, 3>& box = pair.boxes[0];
  for (const MovedPlanes& moved : moved_planes(brush.session)) draw_moved(brush, pair, moved);
  draw_rounded(brush, pair, box.half_extents[0]);
  draw_volume(brush.canvas, fit::Sphere3{box.center, box.half_extents[0]},
              {Stroke::kSolid, color, brush.stroke(), brush.p.fill});
  draw_center(brush, box.center, color);
  if (brush.session.stage().may_move(1)) draw_knob(brush, box.center, lesson::at_place(pair, 1), false);
}

}  // namespace

void draw_body(Brush& brush, const BoxPair& pair, Color color) {
  const Obb<double, 3>& box = pair.boxes[0];
  switch (pair.form) {
    case lesson::Form::kBall: return draw_ball(brush, pair, color);
    case lesson::Form::kPoint: {
      const ImVec2 at = brush.at(box.center);
      disc(brush.list, at, 7 * brush.p.mark, color);
      brush.canvas.obstacles.discs.push_back({at.x, at.y, 9});
      return;
    }
    case lesson::Form::kBox: break;
  }
  draw_volume(brush.canvas, fit::Volume3(box), {Stroke::kSolid, color, brush.stroke(), brush.p.fill});
  draw_center(brush, box.center, color);
  draw_knobs(brush, pair, 0);
}

void draw_center_distance(Brush& brush, const query::PlaneTested<double, 3>& plane, const Point3& normal,
                          const BoxPair& pair) {
  const Palette& p = brush.p;
  const Point3 center = pair.boxes[0].center;
  const double distance = lesson::center_distance(plane), radius = pair.boxes[0].half_extents[0];
  const ImVec2 from = brush.at(center), foot = brush.at(center - normal * distance);
  const Color color = distance > 0 ? p.examined : p.current;
  line(brush.list, from, foot, Stroke::kDashed, color, brush.stroke(0.9f));
  brush.canvas.obstacles.segments.push_back({from.x, from.y, foot.x, foot.y});
  const ImVec2 aside =
      foot.y - from.y >= 0 ? ImVec2{foot.y - from.y, from.x - foot.x} : ImVec2{from.y - foot.y, foot.x - from.x};
  brush.label({(from.x + foot.x) / 2, (from.y + foot.y) / 2}, 5, aside,
              (distance > 0 ? "+" : "") + lesson::number_text(distance),
              distance > 0 ? p.examined_text : p.current_text, Face::kMonoBold, 12);
  if (!(radius > 0)) return;
  for (const double way : {1.0, -1.0}) {
    const ImVec2 end = brush.at(center + normal * (way * radius));
    line(brush.list, from, end, Stroke::kSolid, p.support, brush.stroke(way > 0 ? 1.2f : 0.6f));
    disc(brush.list, end, 3 * p.mark, p.support);
    if (way > 0)
      brush.label(end, 5, {end.x - from.x, end.y - from.y}, "r = " + lesson::number_text(radius), p.support_text,
                  Face::kSemiBold, 12);
  }
}

}  // namespace snug::app
