// Draws two boxes, and the axis or the vertex that the step is about.
#include "app/subjects/pair/draw.hpp"

#include <algorithm>
#include <cmath>

#include "app/box_marks.hpp"
#include "lesson/figures.hpp"
#include "lesson/subjects/pair/box_tests.hpp"

namespace snug::app {
namespace {

/// Draws what a wrong test examines: the boxes' AABBs, or a vertex.
void draw_wrong_test(Brush& brush, const lesson::BoxPair& pair, const PairShown& shown, const SeenFrom& seen) {
  const Palette& p = brush.p;
  if (brush.session.player().method(0)->name == "extents_only" && brush.session.player().step() > 0)
    for (const Obb<double, 3>& box : lesson::boxes_of(brush.session.stage().subject()).boxes) {
      const Obb<double, 3> around{box.center, Matrix<double, 3>::Identity(), box.axes.cwiseAbs() * box.half_extents};
      const bool apart = shown.outlines && shown.outlines->apart;
      draw_volume(brush.canvas, fit::Volume3(seen.box(around)),
                  {Stroke::kDashed, apart ? p.wrong : p.examined, brush.stroke(0.8f)});
    }
  if (!shown.corner) return;
  const ImVec2 at = brush.at(lesson::corner_of(pair.boxes[shown.corner->box], shown.corner->corner));
  ring(brush.list, at, 12 * p.mark, p.examined, brush.stroke());
  brush.label(at, 16, {0.6f, -1},
              std::string(shown.corner->inside ? "inside " : "outside ") + (shown.corner->box == 0 ? "B" : "A"),
              p.examined_text);
}

/// Draws the axis that a question asks about, through A's centre: only its direction, not the projections.
void draw_asked_axis(Brush& brush, const lesson::BoxPair& pair, const query::AxisTested<double, 3>& axis) {
  if (axis.skipped) return;
  const auto ends = asked_arrow(pair, axis);
  const ImVec2 from = brush.at(ends[0]), to = brush.at(ends[1]);
  arrow(brush.list, from, to, brush.p.examined, brush.stroke(1.1f));
  brush.canvas.obstacles.segments.push_back({from.x, from.y, to.x, to.y});
  brush.label(to, 6, {to.x - from.x, to.y - from.y}, lesson::axis_text(pair.dim, axis.axis), brush.p.examined_text,
              Face::kSemiBold, 15);
}

/// Draws the cross product of two edges from A's centre, as long as it is beside one of length 1: it shrinks as the
/// edges become parallel.
void draw_cross_product(Brush& brush, const lesson::BoxPair& pair, const query::AxisTested<double, 3>& axis) {
  if (axis.axis.kind != query::AxisKind::kEdgeEdge) return;
  const Point3& center = pair.boxes[0].center;
  const double whole = pair.boxes[0].half_extents.maxCoeff();
  const ImVec2 from = brush.at(center), to = brush.at(center + axis.axis.direction * (whole * axis.length)),
               end = brush.at(center + axis.axis.direction * whole);
  line(brush.list, from, end, Stroke::kDotted, brush.p.muted, brush.stroke(0.7f));
  if (std::hypot(to.x - from.x, to.y - from.y) > 4) arrow(brush.list, from, to, brush.p.examined, brush.stroke(1.4f));
  else disc(brush.list, from, 3.5f * brush.p.mark, brush.p.examined);
  brush.label(to, 8, {end.x - from.x, end.y - from.y}, "length " + lesson::number_text(axis.length),
              brush.p.examined_text, Face::kSemiBold, 13);
}

}  // namespace

std::array<Point3, 2> asked_arrow(const lesson::BoxPair& pair, const query::AxisTested<double, 3>& axis) {
  const Point3& center = pair.boxes[0].center;
  const double reach = std::max(axis.radius_a, axis.distance + axis.radius_b);
  return {center - axis.axis.direction * (0.3 * reach), center + axis.axis.direction * (1.1 * reach)};
}

void draw_pair(Brush& brush, PairShown shown, const SeenFrom& seen, bool in_frame) {
  const Palette& p = brush.p;
  const lesson::BoxPair pair = seen.boxes(lesson::boxes_of(brush.session.stage().subject()));
  seen.turn(shown);
  for (int i = 0; i < 2; ++i) {
    const Obb<double, 3>& box = pair.boxes[i];
    draw_volume(brush.canvas, fit::Volume3(box), {Stroke::kSolid, p.current, brush.stroke(), p.fill});
    draw_center(brush, box.center, p.current);
    brush.label(brush.at(box.center), 12, {i == 0 ? -1.0f : 1.0f, -1}, i == 0 ? "A" : "B", p.current_text,
                Face::kSemiBold, 18);
    if (!in_frame || i == 1) draw_knobs(brush, pair, i);
  }
  if (shown.axis_asked) {  // the bars of the axis before it would be taken for its own
    draw_asked_axis(brush, pair, *shown.axis_asked);
  } else if (shown.axis) {
    if (!shown.axis->skipped) draw_projections(brush, pair, *shown.axis);
    draw_cross_product(brush, pair, *shown.axis);
  }
  draw_wrong_test(brush, pair, shown, seen);
}

}  // namespace snug::app
