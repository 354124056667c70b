// Draws the lengths of Ritter's formula where a sphere grows: all on the line through its centre and the point.
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

}  // namespace

void draw_growth(Brush& brush, const CloudShown& shown) {
  const fit::Sphere3* now = ball_in(shown.volume);
  if (!shown.grown || now == nullptr) return;
  const Palette& p = brush.p;
  const fit::Sphere3& old = shown.grown->before;
  const Point3 point = brush.session.point(shown.grown->point);
  const double dist = (point - old.center).norm();
  if (!(dist > 0)) return;
  const Point3 back = old.center - (point - old.center) * (old.radius / dist);
  draw_line(brush.canvas, back, point, {Stroke::kSolid, p.muted, brush.stroke(0.6f)});
  plus(brush.list, brush.at(old.center), 5 * p.mark, p.previous, brush.stroke(0.7f));
  const auto number = [](double value) { return lesson::number_text(value); };
  const ImVec2 up = aside_of(brush.at(back), brush.at(point)), down{-up.x, -up.y};
  draw_measure(brush, old.center, point, up, "dist = " + number(dist), p.examined, p.examined_text);
  draw_measure(brush, back, old.center, up, "radius = " + number(old.radius), p.previous, p.previous_text);
  draw_measure(brush, old.center, now->center, down, "k · dist = " + number(now->radius - old.radius), p.support,
               p.support_text);
}

}  // namespace snug::app
