#include "app/box_marks.hpp"

#include <cmath>

namespace snug::app {

void draw_center(Brush& brush, const Point3& at, Color color) {
  const ImVec2 center = brush.at(at);
  plus(brush.list, center, 5 * brush.p.mark, color, brush.stroke(0.8f));
  brush.canvas.obstacles.discs.push_back({center.x, center.y, 8});
}

void draw_knob(Brush& brush, const Point3& foot, const Point3& knob, bool turns) {
  const Palette& p = brush.p;
  const float dimmed = answered_on_stage(brush.session) ? 0.35f : 1;  // what cannot be the answer is dimmed
  const ImVec2 from = brush.at(foot), to = brush.at(knob);
  const Color stalk = with_alpha(p.muted, dimmed);
  line(brush.list, from, to, Stroke::kSolid, stalk, brush.stroke(0.6f));
  disc(brush.list, to, 7 * p.mark, p.ground);
  ring(brush.list, to, 7 * p.mark, with_alpha(p.current, dimmed), brush.stroke(0.9f));
  brush.canvas.obstacles.discs.push_back({to.x, to.y, 13});
  if (!turns) return;
  const float way = std::atan2(to.y - from.y, to.x - from.x);
  brush.list->PathArcTo(to, 12 * p.mark, way - 0.9f, way + 0.9f, 12);
  brush.list->PathStroke(stalk, 0, brush.stroke(0.7f));
}

/// A knob is drawn off its face on a stalk; an arc shows that it rotates the box. A task may forbid it.
void draw_knobs(Brush& brush, const lesson::BoxPair& pair, int i) {
  for (int axis = 0; axis < pair.dim - 1; ++axis) {
    const Index knob = lesson::index_of(pair, {lesson::BoxHandle::Kind::kTurn, i, axis});
    if (!brush.session.stage().may_move(knob)) continue;
    draw_knob(brush, lesson::beyond_face(pair, i, axis, 0), lesson::at_place(pair, knob), true);
  }
}

}  // namespace snug::app
