#include "app/fitted.hpp"

#include <cmath>

#include "fit/catalogue.hpp"
#include "lesson/figures.hpp"
#include "lesson/say.hpp"
#include "lesson/words.hpp"

namespace snug::app {
namespace {

/// "area 2.118", "volume 3.2"
std::string size_text(double size, int dim) { return (dim == 2 ? "area " : "volume ") + lesson::number_text(size); }

/// The place of a volume's label: at its top, or on one side of it on the screen.
Point3 top_of(const Camera& camera, const fit::Volume3& volume, double right) {
  return farthest_in(volume, camera.up() * std::sqrt(1 - right * right) + camera.right() * right, camera.dim());
}

void draw_radius(Brush& brush, const Shown& shown, const fit::Sphere3& ball) {
  const Palette& p = brush.p;
  const Canvas& canvas = brush.canvas;
  const ImVec2 center = brush.at(ball.center);
  plus(brush.list, center, 5 * p.mark, p.current, brush.stroke(0.7f));
  canvas.obstacles.discs.push_back({center.x, center.y, 7});
  if (ball.radius <= 0) return;
  // The radius is drawn to a support point, preferably one on the right, where its label is next to the line.
  Point3 rim = ball.center + canvas.camera.right() * ball.radius;
  double best = -2;
  for (const Index i : shown.support) {
    const Point3 way = brush.session.stage().subject().at(i) - ball.center;
    const double right = way.dot(canvas.camera.right()) / ball.radius;
    if (std::abs(way.norm() - ball.radius) < 0.02 * ball.radius && right > best)
      best = right, rim = brush.session.stage().subject().at(i);
  }
  draw_line(canvas, ball.center, rim, {Stroke::kSolid, p.current, brush.stroke(0.65f)});
  const ImVec2 end = brush.at(rim);
  const float length = std::hypot(end.x - center.x, end.y - center.y);
  if (length < 36) return;
  const ImVec2 along{(end.x - center.x) / length, (end.y - center.y) / length};
  const ImVec2 aside = along.x >= 0 ? ImVec2{along.y, -along.x} : ImVec2{-along.y, along.x};  // upwards
  const fit::Sphere3* goal = ball_in(shown.volume);  // the ball that the motion ends at
  brush.label({center.x + (end.x - center.x) * 0.55f, center.y + (end.y - center.y) * 0.55f}, 4, aside,
              "r = " + lesson::number_text(goal != nullptr ? goal->radius : ball.radius), p.current_text);
}

}  // namespace

void draw_fitted(Brush& brush, const Shown& shown) {
  if (!brush.volume) return;
  draw_volume(brush.canvas, *brush.volume, {Stroke::kSolid, brush.p.current, brush.stroke(), brush.p.fill});
  if (const fit::Sphere3* ball = ball_in(brush.volume)) return draw_radius(brush, shown, *ball);
  const double size = fit::size_of(shown.volume.value_or(*brush.volume), brush.dim());
  brush.label(brush.at(top_of(brush.canvas.camera, *brush.volume, 0)), 6, {0.2f, -1}, size_text(size, brush.dim()),
              brush.p.current_text);
}

void draw_compared(Brush& brush, const Shown& shown) {
  const Palette& p = brush.p;
  const Canvas& canvas = brush.canvas;
  const int dim = brush.dim();
  const auto size = [&](const fit::Volume3& volume) {
    const double own = fit::size_of(volume, dim);
    return std::holds_alternative<fit::Sphere3>(volume) ? "r = " + lesson::number_text(own) : size_text(own, dim);
  };
  // Where it is the smallest as well, that is drawn and named.
  const auto is_optimum = [&](const fit::Volume3& volume) {
    const double smallest = shown.optimum ? fit::size_of(*shown.optimum, dim) : 0;
    return shown.optimum && volume.index() == shown.optimum->index() &&
           std::abs(fit::size_of(volume, dim) - smallest) <= 1e-9 * smallest;
  };
  if (shown.rival && !is_optimum(*shown.rival)) {
    draw_volume(canvas, *shown.rival, {Stroke::kLongDashed, p.previous, brush.stroke(), dim == 3 ? 0.03f : 0.0f});
    if (fit::size_of(*shown.rival, dim) > 0)
      brush.label(brush.at(top_of(canvas.camera, *shown.rival, -0.5)), 6, {-0.6f, -1},
                  lesson::title_in(brush.session.lesson(), *brush.session.player().method(1)) + ": " +
                      size(*shown.rival),
                  p.previous_text);
  }
  if (!shown.optimum) return;
  const bool same = shown.volume && is_optimum(*shown.volume);
  draw_volume(canvas, *shown.optimum, {Stroke::kDashed, p.optimum, brush.stroke(same ? 2.0f : 1.0f)});
  if (same && !shown.finished) return;
  const bool title = shown.optimum_word.front() < 'a';  // of an algorithm: it takes no article
  brush.label(brush.at(top_of(canvas.camera, *shown.optimum, 0.5)), 6, {0.6f, -1},
              same ? (title ? "" : "the ") + shown.optimum_word : shown.optimum_word + ": " + size(*shown.optimum),
              p.optimum_text);
}

}  // namespace snug::app
