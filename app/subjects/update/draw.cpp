#include "app/subjects/update/draw.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/box_marks.hpp"
#include "app/fitted.hpp"
#include "fit/catalogue.hpp"
#include "lesson/figures.hpp"

namespace snug::app {
namespace {

constexpr double kAxisLength = 0.5;  // of the arrows along the frames' axes, over the body's reach
constexpr double kBoundBeyond = 1.18;
constexpr float kBodyFill = 0.06f, kPlaneFill = 0.05f;

/// Arrows along the axes of a frame.
void draw_frame_axes(Brush& brush, const Pose<double, 3>& frame, double length, const std::string& word, Color color,
                     Color words, float width) {
  const ImVec2 origin = brush.at(frame.translation);
  for (int axis = 0; axis < brush.dim(); ++axis) {
    const ImVec2 tip = brush.at(frame.translation + frame.rotation.col(axis) * length);
    arrow(brush.list, origin, tip, color, brush.stroke(width));
    brush.label(tip, 5, {tip.x - origin.x, tip.y - origin.y}, word + "xyz"[axis], words, Face::kRegular, 13, true);
  }
}

/// The world's axes at its origin, and the body's own at its pivot.
void draw_frames(Brush& brush, const UpdateShown& shown) {
  const Palette& p = brush.p;
  const double length = kAxisLength * shown.body->reach();
  draw_frame_axes(brush, {}, length, "world ", with_alpha(p.ink, 0.75f), p.ink, 0.7f);
  draw_frame_axes(brush, shown.body->pose(), length, "local ", p.muted, p.muted, 1.0f);
}

void draw_knobs_of_body(Brush& brush, const UpdateShown& shown) {
  const lesson::UpdateSubject& body = *shown.body;
  for (Index i = lesson::count_of(body); i < body.size(); ++i)
    if (body.grip(i).kind == lesson::Handle::Kind::kTurn) draw_knob(brush, body.pose().translation, body.at(i), true);
  draw_center(brush, body.pose().translation, brush.p.ink);
}

void draw_body_hull(Brush& brush, const UpdateShown& shown) {
  if (!shown.hull) return;
  const bool climbs = !shown.run->recording().corners.empty();
  draw_volume(brush.canvas, *shown.hull,
              {Stroke::kSolid, climbs ? brush.p.ink : brush.p.muted, brush.stroke(climbs ? 0.7f : 0.5f), kBodyFill});
  if (!climbs) brush.canvas.obstacles.segments.clear();
}

/// The sphere about the pivot that the body never leaves, and the point that it passes through.
void draw_reach(Brush& brush, const UpdateShown& shown) {
  if (!shown.farthest) return;
  const Palette& p = brush.p;
  const Point3 pivot = shown.body->pose().translation, far = shown.run->placed(*shown.farthest);
  draw_volume(brush.canvas, fit::Sphere3{pivot, (far - pivot).norm()},
              {Stroke::kDashed, p.previous, brush.stroke(0.8f)});
  draw_line(brush.canvas, pivot, far, {Stroke::kDashed, p.examined, brush.stroke(0.8f)});
  const ImVec2 a = brush.at(pivot), b = brush.at(far);
  brush.label({(a.x + b.x) / 2, (a.y + b.y) / 2}, 5, {b.y - a.y, a.x - b.x},
              "reach " + lesson::number_text((far - pivot).norm()), p.examined_text, Face::kSemiBold, 13);
}

/// The AABB of the points in the local frame, where it is now.
Obb<double, 3> rotated_local_box(const lesson::UpdateSubject& body) {
  const std::vector<Point3> points = lesson::all_points(*body.points());
  Point3 least = points.front(), greatest = least;
  for (const Point3& point : points) least = least.cwiseMin(point), greatest = greatest.cwiseMax(point);
  const Point3 half = (greatest - least) / 2;
  return {placed(body.pose(), Point3(least + half)), body.pose().rotation, half};
}

/// The rotated local AABB, whose vertices the method sums up, and the projections of those that reach farthest.
void draw_local_box(Brush& brush, const UpdateShown& shown) {
  const Palette& p = brush.p;
  const Obb<double, 3> box = rotated_local_box(*shown.body);
  draw_volume(brush.canvas, fit::Volume3(box), {Stroke::kDashed, p.previous, brush.stroke(0.9f)});
  const ImVec2 top = brush.at(farthest_in(fit::Volume3(box), brush.canvas.camera.up(), brush.dim()));
  brush.label(top, 8, {0.5f, -1}, "local AABB", p.previous_text, Face::kSemiBold, 13);
  for (int bits = 0; bits < (brush.dim() == 2 ? 4 : 8); ++bits)
    disc(brush.list, brush.at(lesson::corner_of(box, bits)), 3 * p.mark, p.previous);
  for (const UpdateShown::Bound& bound : shown.bounds) {
    if (!bound.fresh) continue;
    const Point3 low = farthest_in(fit::Volume3(box), -bound.axis, brush.dim()),
                 high = farthest_in(fit::Volume3(box), bound.axis, brush.dim());
    const Point3& end =
        std::abs(bound.axis.dot(low) - bound.at) < std::abs(bound.axis.dot(high) - bound.at) ? low : high;
    const AxisRuler ruler(brush, shown, bound.axis);
    draw_line(brush.canvas, end, ruler.foot(end), {Stroke::kDotted, p.examined, brush.stroke(0.9f)});
    ring(brush.list, brush.at(end), kRing * p.mark, p.examined, brush.stroke());
    disc(brush.list, brush.at(ruler.foot(end)), 4 * p.mark, p.examined);
  }
}

/// A bound that is known: in the plane a line, in space a plane, of which only the latest is drawn.
void draw_bound(Brush& brush, const UpdateShown& shown, const UpdateShown::Bound& bound) {
  const Palette& p = brush.p;
  const Point3 pivot = shown.body->pose().translation, unit = bound.axis.normalized();
  const Point3 foot = pivot + unit * (bound.at / bound.axis.norm() - unit.dot(pivot));
  const double reach = kBoundBeyond * shown.body->reach();
  if (brush.dim() == 2) {
    const Point3 aside(-unit[1], unit[0], 0);
    draw_line(brush.canvas, foot - aside * reach, foot + aside * reach,
              {Stroke::kLongDashed, p.current, brush.stroke(bound.fresh ? 1.0f : 0.6f)});
    return;
  }
  if (!bound.fresh) return;
  int least = 0;
  unit.cwiseAbs().minCoeff(&least);
  const Point3 u = unit.cross(Point3(Point3::Unit(least))).normalized() * reach, v = unit.cross(u);
  const std::array<ImVec2, 4> outline{brush.at(foot - u - v), brush.at(foot + u - v), brush.at(foot + u + v),
                                      brush.at(foot - u + v)};
  brush.list->AddConvexPolyFilled(outline.data(), 4, with_alpha(p.current, kPlaneFill));
  path(brush.list, outline, true, Stroke::kLongDashed, p.current, brush.stroke(0.7f));
}

}  // namespace

AxisRuler::AxisRuler(const Brush& brush, const UpdateShown& shown, const Point3& along) : axis(along.normalized()) {
  constexpr double kAside = 1.1, kHalf = 1.12;  // over the reach
  const Camera& camera = brush.canvas.camera;
  Point3 down = -camera.up() + axis * axis.dot(camera.up());
  if (down.norm() < 0.5) down = -camera.right() + axis * axis.dot(camera.right());
  origin = shown.body->pose().translation + down.normalized() * (kAside * shown.body->reach());
  half = kHalf * shown.body->reach();
}

void draw_update_of_body(Brush& brush, const UpdateShown& shown) {
  const std::string_view method = shown.run->strategy().name;
  draw_body_hull(brush, shown);
  if (method == "loose") draw_reach(brush, shown);
  if (method == "rotated_box") draw_local_box(brush, shown);
  for (const UpdateShown::Bound& bound : shown.bounds) draw_bound(brush, shown, bound);
  draw_compared(brush, shown);
  draw_fitted(brush, shown);
  draw_climb(brush, shown);
  draw_frames(brush, shown);
  draw_knobs_of_body(brush, shown);
}

}  // namespace snug::app
