// Draws the lengths of Ritter's formula where a sphere grows: all on the line through its centre and the point.
#include "app/subjects/cloud/growth.hpp"

#include <array>
#include <cmath>

#include "app/subjects/cloud/draw.hpp"
#include "lesson/figures.hpp"

namespace snug::app {
namespace {

constexpr float kAside = 26, kEnd = 5;  // from the line to a measure, and half of the stroke at its ends, pixels
constexpr float kShortest = 6;          // of a measure that is drawn, pixels

ImVec2 aside_of(ImVec2 from, ImVec2 to) {
  const float length = std::hypot(to.x - from.x, to.y - from.y);
  if (length == 0) return {0, -1};
  return {(to.y - from.y) / length, -(to.x - from.x) / length};
}

/// A length beside the line, between two strokes, with its name and its number.
void draw_measure(Brush& brush, const Point3& from, const Point3& to, ImVec2 aside, std::string words, Color color,
                  Color text) {
  const auto shifted = [&](const Point3& point, float by) {
    const ImVec2 at = brush.at(point);
    return ImVec2{at.x + aside.x * by, at.y + aside.y * by};
  };
  const ImVec2 a = shifted(from, kAside), b = shifted(to, kAside);
  if (std::hypot(b.x - a.x, b.y - a.y) < kShortest) return;
  const float width = brush.stroke(0.8f);
  line(brush.list, a, b, Stroke::kSolid, color, width);
  for (const Point3& end : {from, to})
    line(brush.list, shifted(end, kAside - kEnd), shifted(end, kAside + kEnd), Stroke::kSolid, color, width);
  brush.canvas.obstacles.segments.push_back({a.x, a.y, b.x, b.y});
  brush.label({(a.x + b.x) / 2, (a.y + b.y) / 2}, 4, aside, std::move(words), text, Face::kSemiBold, 13);
}

std::pair<Color, Color> colors_of(GrowthLength::Of of, const Palette& p) {
  switch (of) {
    case GrowthLength::Of::kPoint: return {p.examined, p.examined_text};
    case GrowthLength::Of::kBefore: return {p.previous, p.previous_text};
    case GrowthLength::Of::kMove: break;
  }
  return {p.support, p.support_text};
}

/// The end of the old sphere that is farthest from the point.
Point3 back_of(const fit::Sphere3& ball, const Point3& point) {
  const Point3 away = ball.center - point;
  return ball.center + away * (ball.radius / away.norm());
}

}  // namespace

std::vector<GrowthLength> growth_lengths(const fit::Sphere3& before, const fit::Sphere3& now, const Point3& point) {
  const auto number = [](double value) { return lesson::number_text(value); };
  const double dist = (point - before.center).norm(), grown = now.radius - before.radius;
  if (!(dist > 0)) return {};
  using Of = GrowthLength::Of;
  return {
      {Of::kPoint, before.center, point, true, "dist = " + number(dist)},
      {Of::kBefore, back_of(before, point), before.center, true, "radius = " + number(before.radius)},
      {Of::kMove, before.center, now.center, false, "k · dist = " + number(grown) + ", k = " + number(grown / dist)}};
}

void draw_growth(Brush& brush, const CloudShown& shown) {
  const fit::Sphere3* now = ball_in(shown.volume);
  if (!shown.grown || now == nullptr) return;
  const Palette& p = brush.p;
  const fit::Sphere3& old = shown.grown->before;
  const Point3 point = brush.session.stage().subject().at(shown.grown->point);
  const std::vector<GrowthLength> lengths = growth_lengths(old, *now, point);
  if (lengths.empty()) return;
  const Point3 back = back_of(old, point);
  draw_line(brush.canvas, back, point, {Stroke::kSolid, p.muted, brush.stroke(0.6f)});
  plus(brush.list, brush.at(old.center), 5 * p.mark, p.previous, brush.stroke(0.7f));
  const ImVec2 up = aside_of(brush.at(back), brush.at(point)), down{-up.x, -up.y};
  for (const GrowthLength& one : lengths) {
    const auto [color, text] = colors_of(one.of, p);
    draw_measure(brush, one.from, one.to, one.above ? up : down, one.words, color, text);
  }
}

}  // namespace snug::app
