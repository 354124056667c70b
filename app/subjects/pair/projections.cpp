// Draws both boxes' projections onto an axis beside them.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "app/subjects/pair/draw.hpp"
#include "lesson/figures.hpp"
#include "lesson/subjects/pair/box_tests.hpp"

namespace snug::app {
namespace {

using Axis = query::AxisTested<double, 3>;
using Box = Obb<double, 3>;

// Pixels from the axis: the projections are on the side of the boxes, the distance on the other side.
constexpr float kLaneA = -6, kLaneB = -14, kLaneDistance = 14, kInner = -20;
constexpr float kToAxis = 46;  // from the boxes to the axis, with room for a row of words
// Around the boxes for names and knobs, and beyond them for an axis with its words.
constexpr float kOverBoxes = 24, kKnobs = 40, kAxisRoom = 60;

ImVec2 shifted(ImVec2 at, ImVec2 by, float length) { return {at.x + by.x * length, at.y + by.y * length}; }

/// The first vertex of a mask.
int first_of(int corners) {
  int bits = 0;
  while (bits < 7 && (corners >> bits & 1) == 0) ++bits;
  return bits;
}

/// Where the axis is drawn: beside both boxes, so that its bars and words are clear of them.
struct Line {
  Point3 base;  // the projected centre of A
  Point3 direction;
  [[nodiscard]] Point3 at(double t) const { return base + direction * t; }
};

/// base: a point of A, which projects to 0 on the axis. points: what the axis is drawn clear of.
Line line_beside(const Point3& base, const Point3& direction, int dim, std::span<const Point3> points,
                 const Camera& camera, float margin) {
  Point3 away = dim == 2 ? Point3(direction[1], -direction[0], 0) : Point3(-camera.up());
  away -= direction * direction.dot(away);
  if (away.norm() < 1e-3) away = camera.right() - direction * direction.dot(camera.right());
  away.normalize();
  if (away.dot(camera.up()) > 0) away = -away;
  double reach = 0;
  for (const Point3& point : points) reach = std::max(reach, (point - base).dot(away));
  return {base + away * (reach + margin / camera.scale_at(base)), direction};
}

std::vector<Point3> corners_of(const lesson::BoxPair& pair) {
  std::vector<Point3> corners;
  for (const Box& box : pair.boxes)
    for (int bits = 0; bits < 8; ++bits) corners.push_back(lesson::corner_of(box, bits));
  return corners;
}

/// The axis on the screen, and what is drawn along it.
struct Ruler {
  Brush& brush;
  Line on;
  ImVec2 aside;  // unit, away from the boxes

  /// last: the greatest coordinate that is drawn.
  Ruler(Brush& b, const Line& line, const Point3& base, double last) : brush(b), on(line) {
    const ImVec2 from = brush.at(on.at(0)), to = brush.at(on.at(last)), center = brush.at(base);
    const float length = std::max(1e-3f, std::hypot(to.x - from.x, to.y - from.y));
    aside = {-(to.y - from.y) / length, (to.x - from.x) / length};
    if (aside.x * (from.x - center.x) + aside.y * (from.y - center.y) < 0) aside = {-aside.x, -aside.y};
  }
  [[nodiscard]] ImVec2 at(double t, float lane) const {
    return shifted(brush.at(on.at(t)), aside, lane * brush.p.mark);
  }
  void bar(double from, double to, float lane, Color color, float width) const {
    const ImVec2 a = at(from, lane), b = at(to, lane);
    draw_bar(brush, a, b, aside, color, width);
    brush.canvas.obstacles.segments.push_back({a.x, a.y, b.x, b.y});
  }
  /// Labels the middle between two coordinates. outer: on the side away from the boxes.
  void label(double from, double to, bool outer, std::string words, Color color) const {
    const float side = outer ? 1.0f : -1.0f;
    brush.label(at((from + to) / 2, outer ? kLaneDistance : kInner), 5, {aside.x * side, aside.y * side},
                std::move(words), color, Face::kSemiBold, 13);
  }
  /// Draws the projection of a point of the scene.
  void drop(const Point3& from, double t, float share) const {
    const ImVec2 place = brush.at(from), foot = at(t, 0);
    line(brush.list, place, foot, Stroke::kDotted, brush.p.muted, brush.stroke(share));
    brush.canvas.obstacles.segments.push_back({place.x, place.y, foot.x, foot.y});
  }
};

/// Draws what is between the ends of two projections: hatching if they are apart, a band if they overlap.
void draw_gap(const Ruler& ruler, const std::array<double, 2>& ends, bool separates) {
  const Brush& brush = ruler.brush;
  const ImVec2 from = ruler.at(ends[0], 0), to = ruler.at(ends[1], 0), from_in = ruler.at(ends[0], kInner),
               to_in = ruler.at(ends[1], kInner);
  const Color color = separates ? brush.p.wrong : brush.p.examined;
  brush.list->AddQuadFilled(from, to, to_in, from_in, with_alpha(color, 0.18f));
  if (!separates) return;
  const float length = std::hypot(to.x - from.x, to.y - from.y);
  const int lines = std::clamp(static_cast<int>(length / 7), 1, 200);
  for (int i = 0; i <= lines; ++i) {
    const double t = ends[0] + (ends[1] - ends[0]) * i / lines;
    line(brush.list, ruler.at(t, 0), ruler.at(t, kInner), Stroke::kSolid, with_alpha(color, 0.7f), 1);
  }
}

}  // namespace

void draw_bar(const Brush& brush, ImVec2 from, ImVec2 to, ImVec2 aside, Color color, float width) {
  line(brush.list, from, to, Stroke::kSolid, color, brush.stroke(width));
  for (const ImVec2 end : {from, to})
    line(brush.list, shifted(end, aside, -4 * brush.p.mark), shifted(end, aside, 4 * brush.p.mark), Stroke::kSolid,
         color, brush.stroke(0.8f));
}

std::array<double, 2> ends_of(const Axis& axis) {
  const double first = std::min(-axis.radius_a, axis.distance - axis.radius_b),
               last = std::max(axis.radius_a, axis.distance + axis.radius_b), beyond = 0.08 * (last - first);
  return {first - beyond, last + beyond};
}

Outline outline_of(const lesson::BoxPair& pair, const PairShown& shown, const Camera& camera) {
  const std::vector<Point3> corners = corners_of(pair);
  std::vector<Point3> places = corners;
  Point3 away = Point3::Zero();  // where the axis lies
  if (shown.axis_asked) {
    for (const Point3& end : asked_arrow(pair, *shown.axis_asked)) places.push_back(end);
  } else if (shown.axis && !shown.axis->skipped) {
    const Point3& base = pair.boxes[0].center;
    const Line line = line_beside(base, shown.axis->axis.direction, pair.dim, corners, camera, 0);
    for (const double end : ends_of(*shown.axis)) places.push_back(line.at(end));
    if (line.base != base) away = (line.base - base).normalized();
  }
  Outline seen = outline_within(camera, [&](const Point3& way) {
    const auto by = [&](const Point3& a, const Point3& b) { return a.dot(way) < b.dot(way); };
    const auto [low, high] = std::minmax_element(places.begin(), places.end(), by);
    return std::array{low->dot(way), high->dot(way)};
  });
  const auto room = [&](const Point3& way) {
    return kKnobs + kAxisRoom * static_cast<float>(std::max(0.0, away.dot(way)));
  };
  seen.left = room(-camera.right()), seen.right = room(camera.right()), seen.below = room(-camera.up());
  seen.above = kOverBoxes;
  return seen;
}

void draw_projections(Brush& brush, const lesson::BoxPair& pair, const Axis& axis) {
  const Palette& p = brush.p;
  const std::vector<Point3> corners = corners_of(pair);
  const Point3& base = pair.boxes[0].center;
  const Ruler ruler(brush,
                    line_beside(base, axis.axis.direction, pair.dim, corners, brush.canvas.camera, kToAxis * p.mark),
                    base, axis.distance + axis.radius_a + axis.radius_b);
  const auto [first, last] = ends_of(axis);
  const ImVec2 tip = ruler.at(last, 0), tail = ruler.at(first, 0);
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
                std::string(i == 0 ? "r_A = " : "r_B = ") + lesson::length_along(axis, radius), p.current_text);
  };
  draw_gap(ruler, {axis.radius_a, axis.distance - axis.radius_b}, axis.separates);
  project(0, 0, axis.radius_a, axis.near_a, kLaneA);
  project(1, axis.distance, axis.radius_b, axis.near_b, kLaneB);
  const double from = axis.radius_a, to = axis.distance - axis.radius_b;
  ruler.label(from, to, true,  // on the side without radii
              (axis.separates ? "separation " : "penetration ") + lesson::gap_text(std::abs(axis.axis.gap)),
              axis.separates ? p.wrong_text : p.examined_text);
  ruler.bar(0, axis.distance, kLaneDistance, p.ink, 1.2f);
  ruler.label(0, axis.distance, true, "distance " + lesson::length_along(axis, axis.distance), p.ink);
  const ImVec2 along{tip.x - tail.x, tip.y - tail.y};
  brush.label(tip, 6, along, lesson::axis_text(pair.dim, axis.axis), axis.separates ? p.wrong_text : p.ink);
}

void draw_intervals(Brush& brush, const Intervals& both) {
  const Palette& p = brush.p;
  const Point3& base = both.reach.front();
  const double zero = both.direction.dot(base);
  const auto place = [&](int side, int end) { return both.ends[side][end] - zero; };
  const double first = std::min(place(0, 0), place(1, 0)), last = std::max(place(0, 1), place(1, 1)),
               beyond = 0.08 * (last - first);
  const Line line = line_beside(base, both.direction, brush.dim(), both.reach, brush.canvas.camera, kToAxis * p.mark);
  const Ruler ruler(brush, line, base, last);
  const ImVec2 tip = ruler.at(last + beyond, 0), tail = ruler.at(first - beyond, 0);
  arrow(brush.list, tail, tip, both.separates ? p.wrong : p.muted, brush.stroke(0.8f));
  brush.canvas.obstacles.segments.push_back({tail.x, tail.y, tip.x, tip.y});
  if (!both.tested) {
    for (const int side : {0, 1})
      ruler.bar(place(side, 0), place(side, 1), side == 0 ? kLaneA : kLaneB, with_alpha(p.muted, 0.6f), 1.2f);
    return brush.label(tip, 6, {tip.x - tail.x, tip.y - tail.y}, both.name, p.muted);
  }
  const int low = place(0, 0) <= place(1, 0) ? 0 : 1;  // the one whose interval begins first
  const std::array<double, 2> gap{place(low, 1), place(1 - low, 0)};
  draw_gap(ruler, gap, both.separates);
  for (const int side : {0, 1}) {
    for (const int end : {0, 1}) ruler.drop(both.farthest[side][end], place(side, end), 0.7f);
    ruler.bar(place(side, 0), place(side, 1), side == 0 ? kLaneA : kLaneB, p.current, 2.4f);
    ruler.label(place(side, 0), place(side, 1), true, side == 0 ? "A" : "B", p.current_text);
  }
  ruler.label(gap[0], gap[1], false,
              (both.separates ? "separation " : "overlap ") + lesson::gap_text(std::abs(gap[1] - gap[0])),
              both.separates ? p.wrong_text : p.examined_text);
  brush.label(tip, 6, {tip.x - tail.x, tip.y - tail.y}, both.name, both.separates ? p.wrong_text : p.ink);
}

}  // namespace snug::app
