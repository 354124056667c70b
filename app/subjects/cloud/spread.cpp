// Draws how the points spread: their mean, the ellipsoids and axes, and what is chosen along the main axis.
#include <cmath>

#include "app/subjects/cloud/draw.hpp"
#include "lesson/figures.hpp"

namespace snug::app {

void draw_spread(Brush& brush, const CloudShown& shown) {
  if (!shown.mean) return;
  const Palette& p = brush.p;
  const Canvas& canvas = brush.canvas;
  const ImVec2 mean = brush.at(*shown.mean);
  if (shown.spread) {
    for (const double deviations : {2.0, 1.0}) {
      Ellipsoid ellipsoid{*shown.mean, shown.spread->axes};
      for (int i = 0; i < 3; ++i) ellipsoid.half_axes.col(i) *= deviations * shown.spread->sigma[i];
      draw_volume(canvas, ellipsoid,
                  {deviations == 1.0 ? Stroke::kSolid : Stroke::kDotted, p.current, brush.stroke(0.8f), p.fill * 0.8f});
      if (shown.spread->named) continue;
      const Point3 end = *shown.mean + ellipsoid.half_axes.col(2);
      brush.label(brush.at(end), 6, {0.2f, -1}, deviations == 1.0 ? "1 σ" : "2 σ", p.current_text, Face::kSemiBold, 13);
    }
  }
  if (shown.spread && shown.spread->named) {
    for (int i = 3 - brush.dim(); i < 3; ++i) {
      const Point3 end = *shown.mean + shown.spread->axes.col(i) * shown.spread->sigma[i];
      const ImVec2 tip = brush.at(end);
      const bool main = i == 2;
      arrow(brush.list, mean, tip, main ? p.support : p.ink, brush.stroke(main ? 1.2f : 0.8f));
      brush.canvas.obstacles.segments.push_back({mean.x, mean.y, tip.x, tip.y});
      brush.label(tip, 8, {tip.x - mean.x, tip.y - mean.y}, "σ = " + lesson::number_text(shown.spread->sigma[i]),
                  main ? p.support_text : p.ink);
      brush.labels.back().request.clear_of_points = true;
    }
  }
  disc(brush.list, mean, 8 * p.mark, p.ground);
  plus(brush.list, mean, 7 * p.mark, p.current, brush.stroke(1.1f));
  canvas.obstacles.discs.push_back({mean.x, mean.y, 9});
  brush.label(mean, 10, {-0.8f, 0.8f}, "mean", p.current_text);
}

void draw_axis_ends(Brush& brush, const CloudShown& shown) {
  if (!shown.pair) return;
  const Palette& p = brush.p;
  const Point3 a = brush.session.stage().subject().at(shown.pair->a),
               b = brush.session.stage().subject().at(shown.pair->b);
  if (shown.volume) draw_line(brush.canvas, a, b, {Stroke::kSolid, p.support, brush.stroke(0.8f)});
  if (!shown.spread || !shown.spread->ends || !shown.mean) return;
  const Point3 axis = shown.spread->axes.col(2);
  const auto foot = [&](const Point3& point) { return Point3(*shown.mean + axis * axis.dot(point - *shown.mean)); };
  const Point3 from = foot(a), to = foot(b);
  const Point3 beyond = (to - from) * 0.06;
  // Drawn on both sides of the eigenvector's arrow.
  const VolumeStyle dashes{Stroke::kDashed, p.muted, brush.stroke(0.7f)};
  draw_line(brush.canvas, from - beyond, *shown.mean, dashes);
  draw_line(brush.canvas, *shown.mean + axis * shown.spread->sigma[2], to + beyond, dashes);
  for (const auto& [point, base] : {std::pair{a, from}, {b, to}}) {
    draw_line(brush.canvas, point, base, {Stroke::kDotted, p.support, brush.stroke(0.8f)});
    cross(brush.list, brush.at(base), 4 * p.mark, p.muted, brush.stroke(0.7f));
  }
}

}  // namespace snug::app
