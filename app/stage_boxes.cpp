// Two boxes and the axis at hand: their projections on it, the radii, the distance and the gap.
#include <algorithm>
#include <cmath>

#include "app/stage_brush.hpp"
#include "lesson/box_tests.hpp"
#include "lesson/figures.hpp"
#include "lesson/frustum_box.hpp"

namespace snug::app {
namespace {

using Axis = query::AxisTested<double, 3>;
using Box = Obb<double, 3>;

constexpr float kLane = 6;  // pixels that each box's bar stands off the axis, to its own side

ImVec2 shifted(ImVec2 at, ImVec2 by, float length) { return {at.x + by.x * length, at.y + by.y * length}; }

/// A mask's first corner.
int first_of(int corners) {
  int bits = 0;
  while (bits < 7 && (corners >> bits & 1) == 0) ++bits;
  return bits;
}

/// Where the axis is drawn: beside both boxes, so that its bars and words stand clear of them.
struct Line {
  Point3 base;  // what the centre of A is cast to
  Point3 direction;
  double distance = 0;
  [[nodiscard]] Point3 at(double t) const { return base + direction * t; }
};

Line line_beside(const lesson::BoxPair& pair, const Axis& axis, const Camera& camera) {
  Point3 away = pair.dim == 2 ? Point3(axis.axis.direction[1], -axis.axis.direction[0], 0) : Point3(-camera.up());
  away -= axis.axis.direction * axis.axis.direction.dot(away);
  if (away.norm() < 1e-3) away = camera.right() - axis.axis.direction * axis.axis.direction.dot(camera.right());
  away.normalize();
  if (away.dot(camera.up()) > 0) away = -away;
  double reach = 0;
  for (const Box& box : pair.boxes)
    for (int bits = 0; bits < 8; ++bits)
      reach = std::max(reach, (lesson::corner_of(box, bits) - pair.boxes[0].center).dot(away));
  const double margin = 26 / camera.scale_at(pair.boxes[0].center);
  return {pair.boxes[0].center + away * (reach + margin), axis.axis.direction, axis.distance};
}

}  // namespace

void Stage::draw_boxes(Brush& brush) const {
  const lesson::BoxPair* pair = brush.session.boxes();
  if (pair == nullptr) return;
  if (lesson::has_frustum(*pair)) return draw_frustum(brush, *pair);
  const Palette& p = brush.p;
  for (int i = 0; i < 2; ++i) {
    const Box& box = pair->boxes[i];
    draw_volume(brush.canvas, fit::Volume3(box), {Stroke::kSolid, p.current, brush.stroke(), p.fill});
    const ImVec2 center = brush.at(box.center);
    plus(brush.list, center, 5 * p.mark, p.current, brush.stroke(0.8f));
    brush.canvas.obstacles.discs.push_back({center.x, center.y, 8});
    brush.label(center, 12, {i == 0 ? -1.0f : 1.0f, -1}, i == 0 ? "A" : "B", p.current_text, Face::kSemiBold, 18);
    draw_knobs(brush, *pair, i);
  }
  if (shown_.axis && !shown_.axis->skipped) draw_projections(brush, *pair);
  draw_wrong_test(brush, *pair);
}

/// What a wrong test looks at: the boxes' upright outlines, or a corner.
void Stage::draw_wrong_test(Brush& brush, const lesson::BoxPair& pair) const {
  const Palette& p = brush.p;
  if (brush.session.algorithm(0)->name == "extents_only" && brush.session.step() > 0)
    for (const Box& box : pair.boxes) {
      const Point3 half = box.axes.cwiseAbs() * box.half_extents;
      const bool apart = shown_.outlines && shown_.outlines->apart;
      draw_box(brush.canvas, box.center - half, box.center + half,
               {Stroke::kDashed, apart ? p.wrong : p.examined, brush.stroke(0.8f)});
    }
  if (!shown_.corner) return;
  const ImVec2 at = brush.at(lesson::corner_of(pair.boxes[shown_.corner->box], shown_.corner->corner));
  ring(brush.list, at, 12 * p.mark, p.examined, brush.stroke());
  brush.label(at, 16, {0.6f, -1}, shown_.corner->inside ? "inside" : "free", p.examined_text);
}

/// A knob stands off its face on a stalk; an arc says that it turns.
void Stage::draw_knobs(Brush& brush, const lesson::BoxPair& pair, int i) const {
  using Kind = lesson::Place::Kind;
  const Palette& p = brush.p;
  for (int axis = 0; axis < pair.dim - 1; ++axis) {
    const Point3 knob = lesson::at_place(pair, lesson::index_of(pair.dim, {Kind::kTurn, i, axis}));
    const ImVec2 from = brush.at(lesson::beyond_face(pair, i, axis, 0)), to = brush.at(knob);
    line(brush.list, from, to, Stroke::kSolid, p.muted, brush.stroke(0.6f));
    disc(brush.list, to, 7 * p.mark, p.ground);
    ring(brush.list, to, 7 * p.mark, p.current, brush.stroke(0.9f));
    const float way = std::atan2(to.y - from.y, to.x - from.x);
    brush.list->PathArcTo(to, 12 * p.mark, way - 0.9f, way + 0.9f, 12);
    brush.list->PathStroke(p.muted, 0, brush.stroke(0.7f));
    brush.canvas.obstacles.discs.push_back({to.x, to.y, 13});
  }
}

void Stage::draw_projections(Brush& brush, const lesson::BoxPair& pair) const {
  const Palette& p = brush.p;
  const Axis& axis = *shown_.axis;
  const Line on = line_beside(pair, axis, camera_);
  const double first = std::min(-axis.radius_a, axis.distance - axis.radius_b),
               last = std::max(axis.radius_a, axis.distance + axis.radius_b);
  const double beyond = 0.08 * (last - first);
  const Color color = axis.separates ? p.wrong : p.muted;
  arrow(brush.list, brush.at(on.at(first - beyond)), brush.at(on.at(last + beyond)), color, brush.stroke(0.8f));

  const ImVec2 a = brush.at(on.at(0)), b = brush.at(on.at(last));
  const float length = std::max(1e-3f, std::hypot(b.x - a.x, b.y - a.y));
  const ImVec2 aside{-(b.y - a.y) / length, (b.x - a.x) / length};
  const auto foot = [&](const Point3& corner) {
    return on.at((corner - pair.boxes[0].center).dot(axis.axis.direction));
  };
  const auto bar = [&](int i, double middle, double radius, int near, float side) {
    const Box& box = pair.boxes[i];
    const int bits = first_of(near);
    for (const int corner : {bits, ~bits & (pair.dim == 2 ? 3 : 7)}) {
      const Point3 at = lesson::corner_of(box, corner);
      line(brush.list, brush.at(at), brush.at(foot(at)), Stroke::kDotted, p.muted, brush.stroke(0.7f));
    }
    const ImVec2 from = shifted(brush.at(on.at(middle - radius)), aside, side * kLane),
                 to = shifted(brush.at(on.at(middle + radius)), aside, side * kLane);
    line(brush.list, from, to, Stroke::kSolid, p.current, brush.stroke(2.4f));
    for (const ImVec2 end : {from, to})
      line(brush.list, shifted(end, aside, -5), shifted(end, aside, 5), Stroke::kSolid, p.current, brush.stroke());
    brush.canvas.obstacles.segments.push_back({from.x, from.y, to.x, to.y});
    const ImVec2 label{(from.x + to.x) / 2, (from.y + to.y) / 2};
    brush.label(label, 8, {aside.x * side, aside.y * side},
                std::string(i == 0 ? "r_A = " : "r_B = ") + lesson::number_text(radius), p.current_text,
                Face::kSemiBold, 13);
  };
  bar(0, 0, axis.radius_a, axis.near_a, -1);
  bar(1, axis.distance, axis.radius_b, axis.near_b, 1);
  draw_gap(brush, brush.at(on.at(axis.radius_a)), brush.at(on.at(axis.distance - axis.radius_b)), aside);
}

/// Between the bars: hatched where the boxes are apart, a band where their projections overlap.
void Stage::draw_gap(Brush& brush, ImVec2 from, ImVec2 to, ImVec2 aside) const {
  const Palette& p = brush.p;
  const Axis& axis = *shown_.axis;
  const float reach = 2 * kLane;
  const Color color = axis.separates ? p.wrong : p.examined;
  const ImVec2 corners[4] = {shifted(from, aside, -reach), shifted(to, aside, -reach), shifted(to, aside, reach),
                             shifted(from, aside, reach)};
  brush.list->AddQuadFilled(corners[0], corners[1], corners[2], corners[3], with_alpha(color, 0.16f));
  if (axis.separates) {
    const float length = std::hypot(to.x - from.x, to.y - from.y);
    const int lines = std::clamp(static_cast<int>(length / 7), 1, 200);
    for (int i = 0; i <= lines; ++i) {
      const float t = static_cast<float>(i) / static_cast<float>(lines);
      const ImVec2 at{from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t};
      line(brush.list, shifted(at, aside, -reach), shifted(at, aside, reach), Stroke::kSolid, with_alpha(color, 0.7f),
           1);
    }
  }
  const ImVec2 middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
  const std::string words = axis.separates ? "gap " + lesson::number_text(axis.axis.gap)
                                           : "overlap " + lesson::number_text(std::max(0.0, -axis.axis.gap));
  brush.label(middle, 2 * reach + 4, aside, words, axis.separates ? p.wrong_text : p.examined_text, Face::kSemiBold,
              14);
}

}  // namespace snug::app
