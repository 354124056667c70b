// Draws the walk from vertex to neighbour: what was compared is projected onto a ruler along the axis.
#include "app/subjects/update/draw.hpp"

namespace snug::app {
namespace {

constexpr float kFootRadius = 4;

void draw_climb_projection(Brush& brush, const AxisRuler& ruler, const Point3& place, Color color, float width) {
  const Point3 foot = ruler.foot(place);
  draw_line(brush.canvas, place, foot, {Stroke::kDotted, color, brush.stroke(width)});
  disc(brush.list, brush.at(foot), kFootRadius * brush.p.mark, color);
}

/// The ruler with its arrow, and which way is farther.
void draw_climb_ruler(Brush& brush, const AxisRuler& ruler, const std::string& side, bool greatest) {
  const Palette& p = brush.p;
  const double way = greatest ? ruler.half : -ruler.half;
  const ImVec2 tail = brush.at(ruler.at(-way)), tip = brush.at(ruler.at(way));
  arrow(brush.list, tail, tip, p.examined, brush.stroke(1.1f));
  brush.canvas.obstacles.segments.push_back({tail.x, tail.y, tip.x, tip.y});
  brush.label(tip, 7, {tip.x - tail.x, tip.y - tail.y}, "farther towards " + side, p.examined_text, Face::kSemiBold,
              13);
}

}  // namespace

void draw_climb(Brush& brush, const UpdateShown& shown) {
  if (!shown.climb) return;
  const Palette& p = brush.p;
  const UpdateShown::Climb& climb = *shown.climb;
  const lesson::UpdateRun& run = *shown.run;
  const AxisRuler ruler(brush, shown, run.axis(climb.axis));
  draw_climb_ruler(brush, ruler, lesson::UpdateRun::Where{run, 0, nullptr}.side(climb.axis, climb.greatest),
                   climb.greatest);
  for (const Index i : climb.neighbors)
    if (i != climb.best) draw_climb_projection(brush, ruler, run.placed(i), p.muted, 0.8f);
  draw_climb_projection(brush, ruler, run.placed(climb.vertex), p.examined, 1);
  if (climb.best != climb.vertex || climb.over)
    draw_climb_projection(brush, ruler, run.placed(climb.best), p.support, 1);
  for (const auto& [from, to] : climb.edges)
    arrow(brush.list, brush.at(run.placed(from)), brush.at(run.placed(to)), p.support, brush.stroke(1.4f));
}

void mark_climb(Brush& brush, const UpdateShown& shown) {
  if (!shown.climb) return;
  const Palette& p = brush.p;
  const UpdateShown::Climb& climb = *shown.climb;
  for (const Index i : climb.neighbors)
    ring(brush.list, brush.at(brush.point(i)), kRing * p.mark, p.examined, brush.stroke(0.8f));
  if (climb.best != climb.vertex || climb.over) mark_point(brush, climb.best);
  if (climb.over) return;
  const ImVec2 at = brush.at(brush.point(climb.vertex));
  disc(brush.list, at, (brush.point_radius + 1) * p.mark, p.examined);
  ring(brush.list, at, (kRing + 4) * p.mark, p.examined, brush.stroke());
  brush.canvas.obstacles.discs.push_back({at.x, at.y, kRing + 6});
}

void name_climb(PointNames& names, const UpdateShown& shown) {
  if (!shown.climb) return;
  const Palette& p = names.brush.p;
  const UpdateShown::Climb& climb = *shown.climb;
  const auto name = [&](Index i, Color color) {
    names.name(i, names.brush.session.stage().subject().name_of(i), color, Face::kSemiBold, (kRing + 5) * p.mark);
  };
  if (climb.best != climb.vertex || climb.over) name(climb.best, p.support_text);
  name(climb.vertex, p.examined_text);
  for (const Index i : climb.neighbors) name(i, p.examined_text);
}

}  // namespace snug::app
