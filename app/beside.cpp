#include "app/beside.hpp"

#include <cmath>

#include "app/polytope.hpp"
#include "lesson/beside.hpp"

namespace snug::app {
namespace {

using lesson::Beside;

struct Style {
  Stroke stroke;
  Color color, text;
};
Style style_of(const Palette& p, Beside::Is is) {
  if (is == Beside::Is::kRight) return {Stroke::kDashed, p.optimum, p.optimum_text};
  if (is == Beside::Is::kYours) return {Stroke::kDotted, p.wrong, p.wrong_text};
  return {Stroke::kSolid, p.support, p.support_text};
}

void mark_point(Brush& brush, ImVec2 at, Beside::Is is, Color color) {
  const float size = 9 * brush.p.mark;
  if (is == Beside::Is::kRight) return ring(brush.list, at, size, color, brush.stroke());
  if (is == Beside::Is::kYours) return cross(brush.list, at, size, color, brush.stroke());
  diamond(brush.list, at, size, color, brush.p.ground);
}

/// Where its name stands, seen from it: away from what is nearest of another kind, which may lie within a pixel of it.
ImVec2 side_of(const Brush& brush, const std::vector<Beside>& all, const Beside& one) {
  const ImVec2 own = brush.at(lesson::at_handle(one.volume, {}));
  ImVec2 away = one.is == Beside::Is::kYours ? ImVec2{-1, 1} : ImVec2{1, -1};
  float least = 1e9f;
  for (const Beside& other : all) {
    const ImVec2 from = brush.at(lesson::at_handle(other.volume, {}));
    const float dx = own.x - from.x, dy = own.y - from.y, apart = std::hypot(dx, dy);
    if (other.is == one.is || apart >= least) continue;
    least = apart;
    if (apart > 2) away = {dx / apart, dy / apart};
  }
  return away;
}

}  // namespace

bool has_beside(const lesson::Session& session) {
  return session.lesson().beside != nullptr && session.stage().is_own();
}

fit::Sphere3 ball_with_beside(const lesson::Session& session, const fit::Sphere3& shown) {
  constexpr double kMost = 3;  // what is farther off would leave the rest too small to see
  constexpr double kPoint = 1e-6;
  const bool is_point = shown.radius <= kPoint * (1 + shown.center.norm());
  fit::Sphere3 all = shown;
  if (!has_beside(session)) return all;
  for (const auto& [is, name, held] : *session.lesson().beside) {
    const fit::Sphere3 both = ball_around(all, ball_around(held.volume, held.dim));
    if (is_point || both.radius <= kMost * shown.radius) all = both;
  }
  return all;
}

void draw_beside(Brush& brush) {
  if (!has_beside(brush.session)) return;
  const Camera& camera = brush.canvas.camera;
  const std::vector<Beside>& all = *brush.session.lesson().beside;
  for (const Beside& one : all) {
    const auto [stroke, color, text] = style_of(brush.p, one.is);
    const ImVec2 toward = side_of(brush, all, one);
    const Point3 way = (camera.right() * toward.x - camera.up() * toward.y).normalized();
    const ImVec2 at = brush.at(farthest_in(one.volume.volume, way, one.volume.dim));
    const auto* ball = std::get_if<fit::Sphere3>(&one.volume.volume);
    const auto* capsule = std::get_if<Capsule<double, 3>>(&one.volume.volume);
    const auto draw = [&](const VolumeStyle& style) {
      if (capsule != nullptr && capsule->radius == 0) draw_line(brush.canvas, capsule->a, capsule->b, style);
      else draw_volume(brush.canvas, one.volume.volume, style);
    };
    if (ball != nullptr && ball->radius == 0) {
      mark_point(brush, at, one.is, color);
    } else {
      // The stage may draw a line of its own at the same place, which would fill the gaps between the dashes.
      if (one.is == Beside::Is::kRight) draw({Stroke::kSolid, brush.p.ground, brush.stroke(1.5f)});
      draw({stroke, color, brush.stroke()});
    }
    if (!one.name.empty()) brush.label(at, 18, toward, one.name, text);
  }
}

}  // namespace snug::app
