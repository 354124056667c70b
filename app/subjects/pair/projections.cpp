// Both boxes projected onto an axis that stands beside them.
#include <algorithm>
#include <cmath>

#include "app/subjects/pair/draw.hpp"
#include "lesson/figures.hpp"
#include "lesson/subjects/pair/box_tests.hpp"

namespace snug::app {
namespace {

using Axis = query::AxisTested<double, 3>;
using Box = Obb<double, 3>;

// Pixels from the axis: towards the boxes the two projections, away from them the distance.
constexpr float kLaneA = -6, kLaneB = -14, kLaneDistance = 14, kInner = -20;
constexpr float kToAxis = 46;  // from the boxes to the axis: a row of words stands between

ImVec2 shifted(ImVec2 at, ImVec2 by, float length) { return {at.x + by.x * length, at.y + by.y * length}; }

/// A mask's first corner.
int first_of(int corners) {
  int bits = 0;
  while (bits < 7 && (corners >> bits & 1) == 0) ++bits;
  return bits;
}

/// Where the axis is drawn: beside both boxes, so that its bars and words stand clear of them.
struct Line {
  Point3 base;  // the projected centre of A
  Point3 direction;
  [[nodiscard]] Point3 at(double t) const { return base + direction * t; }
};

Line line_beside(const lesson::BoxPair& pair, const Axis& axis, const Camera& camera, float margin) {
  Point3 away = pair.dim == 2 ? Point3(axis.axis.direction[1], -axis.axis.direction[0], 0) : Point3(-camera.up());
  away -= axis.axis.direction * axis.axis.direction.dot(away);
  if (away.norm() < 1e-3) away = camera.right() - axis.axis.direction * axis.axis.direction.dot(camera.right());
  away.normalize();
  if (away.dot(camera.up()) > 0) away = -away;
  double reach = 0;
  for (const Box& box : pair.boxes)
    for (int bits = 0; bits < 8; ++bits)
      reach = std::max(reach, (lesson::corner_of(box, bits) - pair.boxes[0].center).dot(away));
  return {pair.boxes[0].center + away * (reach + margin / camera.scale_at(pair.boxes[0].center)), axis.axis.direction};
}

/// The axis on the screen, and places beside it.
struct Ruler {
  Brush& brush;
  Line on;
  ImVec2 aside;  // unit, away from the boxes

  Ruler(Brush& b, const lesson::BoxPair& pair, const Axis& axis)
      : brush(b), on(line_beside(pair, axis, b.canvas.camera, kToAxis * b.p.mark)) {
    const ImVec2 from = brush.at(on.at(0)), to = brush.at(on.at(axis.distance + axis.radius_a + axis.radius_b)),
                 center = brush.at(pair.boxes[0].center);
    const float length = std::max(1e-3f, std::hypot(to.x - from.x, to.y - from.y));
    aside = {-(to.y - from.y) / length, (to.x - from.x) / length};
    if (aside.x * (from.x - center.x) + aside.y * (from.y - center.y) < 0) aside = {-aside.x, -aside.y};
  }
  [[nodiscard]] ImVec2 at(double t, float lane) const {
    return shifted(brush.at(on.at(t)), aside, lane * brush.p.mark);
  }
  /// A bar from one place to another, with a stroke across each of its ends.
  void bar(double from, double to, float lane, Color color, float width) const {
    const ImVec2 a = at(from, lane), b = at(to, lane);
    line(brush.list, a, b, Stroke::kSolid, color, brush.stroke(width));
    for (const ImVec2 end : {a, b})
      line(brush.list, shifted(end, aside, -4 * brush.p.mark), shifted(end, aside, 4 * brush.p.mark), Stroke::kSolid,
           color, brush.stroke(0.8f));
    brush.canvas.obstacles.segments.push_back({a.x, a.y, b.x, b.y});
  }
  /// Beside the middle between two places. outer: on the side away from the boxes.
  void label(double from, double to, bool outer, std::string words, Color color) const {
    const float side = outer ? 1.0f : -1.0f;
    brush.label(at((from + to) / 2, outer ? kLaneDistance : kInner), 5, {aside.x * side, aside.y * side},
                std::move(words), color, Face::kSemiBold, 13);
  }
  /// Where a place of the scene is projected to.
  void drop(const Point3& from, double t, float share) const {
    line(brush.list, brush.at(from), at(t, 0), Stroke::kDotted, brush.p.muted, brush.stroke(share));
  }
};

/// Between the ends of the radii: hatched where the boxes are apart, a band where their projections overlap.
void draw_gap(const Ruler& ruler, const Axis& axis) {
  const Brush& brush = ruler.brush;
  const double ends[2] = {axis.radius_a, axis.distance - axis.radius_b};
  const ImVec2 from = ruler.at(ends[0], 0), to = ruler.at(ends[1], 0), from_in = ruler.at(ends[0], kInner),
               to_in = ruler.at(ends[1], kInner);
  const Color color = axis.separates ? brush.p.wrong : brush.p.examined;
  brush.list->AddQuadFilled(from, to, to_in, from_in, with_alpha(color, 0.18f));
  if (!axis.separates) return;
  const float length = std::hypot(to.x - from.x, to.y - from.y);
  const int lines = std::clamp(static_cast<int>(length / 7), 1, 200);
  for (int i = 0; i <= lines; ++i) {
    const double t = ends[0] + (ends[1] - ends[0]) * i / lines;
    line(brush.list, ruler.at(t, 0), ruler.at(t, kInner), Stroke::kSolid, with_alpha(color, 0.7f), 1);
  }
}

}  // namespace

void draw_projections(Brush& brush, const lesson::BoxPair& pair, const Axis& axis) {
  const Palette& p = brush.p;
  const Ruler ruler(brush, pair, axis);
  const double first = std::min(-axis.radius_a, axis.distance - axis.radius_b),
               last = std::max(axis.radius_a, axis.distance + axis.radius_b), beyond = 0.08 * (last - first);
  const ImVec2 tip = ruler.at(last + beyond, 0), tail = ruler.at(first - beyond, 0);
  arrow(brush.list, tail, tip, axis.separates ? p.wrong : p.muted, brush.stroke(0.8f));
  brush.canvas.obstacles.segments.push_back({tail.x, tail.y, tip.x, tip.y});

  const auto project = [&](int i, double middle, double radius, int near, float lane) {
    const Box& box = pair.boxes[i];
    const double inwards = i == 0 ? radius : -radius;
    const int all = pair.dim == 2 ? 3 : 7, bits = first_of(near);
    ruler.drop(lesson::corner_of(box, bits), middle + inwards, 0.6f);
    ruler.drop(lesson::corner_of(box, ~bits & all), middle - inwards, 0.6f);
    ruler.drop(box.center, middle, 0.9f);
    ruler.bar(middle - inwards, middle, lane, with_alpha(p.current, 0.45f), 1.2f);
    ruler.bar(middle, middle + inwards, lane, p.current, 2.4f);
    disc(brush.list, ruler.at(middle, 0), 4 * p.mark, p.current);
    ruler.label(middle, middle + inwards, false,
                std::string(i == 0 ? "r_A = " : "r_B = ") + lesson::number_text(radius), p.current_text);
  };
  draw_gap(ruler, axis);
  project(0, 0, axis.radius_a, axis.near_a, kLaneA);
  project(1, axis.distance, axis.radius_b, axis.near_b, kLaneB);
  const double from = axis.radius_a, to = axis.distance - axis.radius_b;
  ruler.label(from, to, true,  // where no radius is drawn
              (axis.separates ? "separation " : "penetration ") + lesson::number_text(std::abs(axis.axis.gap)),
              axis.separates ? p.wrong_text : p.examined_text);
  ruler.bar(0, axis.distance, kLaneDistance, p.ink, 1.2f);
  ruler.label(0, axis.distance, true, "distance " + lesson::number_text(axis.distance), p.ink);
  const ImVec2 along{tip.x - tail.x, tip.y - tail.y};
  brush.label(tip, 6, along, lesson::axis_text(pair.dim, axis.axis), axis.separates ? p.wrong_text : p.ink);
}

}  // namespace snug::app
