// The geometry that a step speaks of.
#include <algorithm>
#include <cmath>

#include "app/numbers.hpp"
#include "app/stage_brush.hpp"
#include "lesson/figures.hpp"
#include "lesson/words.hpp"

namespace snug::app {
namespace {

constexpr ImVec2 kAbove{0.2f, -1}, kRightUp{1, -0.6f};

/// "area 2.118", "volume 3.2"
std::string size_text(double size, int dim) { return (dim == 2 ? "area " : "volume ") + lesson::number_text(size); }

ImVec2 unit(ImVec2 v) {
  const float length = std::hypot(v.x, v.y);
  return length > 0 ? ImVec2{v.x / length, v.y / length} : ImVec2{1, 0};
}

}  // namespace

void Stage::draw_volumes(Brush& brush) const {
  draw_hull(brush);
  draw_spread(brush);
  draw_extremes(brush);
  draw_scene(brush);
  draw_rivals(brush);
  draw_candidate(brush);
  draw_current(brush);
  draw_axis_ends(brush);
  draw_boxes(brush);
  // The farthest first, so that the nearer ones tint what lies behind them.
  std::sort(brush.canvas.gl.volumes.begin(), brush.canvas.gl.volumes.end(), [&](const GlVolume& a, const GlVolume& b) {
    return (a.center - scene_.eye).squaredNorm() > (b.center - scene_.eye).squaredNorm();
  });
}

/// The current volume; a ball with its centre and radius.
void Stage::draw_current(Brush& brush) const {
  if (!volume_) return;
  draw_volume(brush.canvas, *volume_, {Stroke::kSolid, brush.p.current, brush.stroke(), brush.p.fill});
  if (const fit::Sphere3* ball = ball_in(volume_)) return draw_radius(brush, *ball);
  const double size = fit::size_of(shown_.volume.value_or(*volume_), camera_.dim());
  brush.label(brush.at(top_of(*volume_, 0)), 6, kAbove, size_text(size, camera_.dim()), brush.p.current_text);
}

void Stage::draw_radius(Brush& brush, const fit::Sphere3& ball) const {
  const Palette& p = brush.p;
  const Canvas& canvas = brush.canvas;
  const ImVec2 center = brush.at(ball.center);
  plus(brush.list, center, 5 * p.mark, p.current, brush.stroke(0.7f));
  canvas.obstacles.discs.push_back({center.x, center.y, 7});
  if (ball.radius <= 0) return;
  // To a point that holds the ball, preferably one on the right, where its label reads as the line's.
  Point3 rim = ball.center + camera_.right() * ball.radius;
  double best = -2;
  for (const Index i : shown_.support) {
    const Point3 way = brush.session.point(i) - ball.center;
    const double right = way.dot(camera_.right()) / ball.radius;
    if (std::abs(way.norm() - ball.radius) < 0.02 * ball.radius && right > best)
      best = right, rim = brush.session.point(i);
  }
  draw_line(canvas, ball.center, rim, {Stroke::kSolid, p.current, brush.stroke(0.65f)});
  const ImVec2 end = brush.at(rim);
  const ImVec2 along = unit({end.x - center.x, end.y - center.y});
  const ImVec2 aside = along.x >= 0 ? ImVec2{along.y, -along.x} : ImVec2{-along.y, along.x};  // upwards
  if (std::hypot(end.x - center.x, end.y - center.y) < 36) return;
  brush.label({center.x + (end.x - center.x) * 0.55f, center.y + (end.y - center.y) * 0.55f}, 4, aside,
              "r = " +
                  lesson::number_text(ball_in(shown_.volume) != nullptr ? ball_in(shown_.volume)->radius : ball.radius),
              p.current_text);
}

/// Where a volume's label stands: at its top, or to one side of it on the screen.
Point3 Stage::top_of(const fit::Volume3& volume, double right) const {
  return farthest_in(volume, camera_.up() * std::sqrt(1 - right * right) + camera_.right() * right, camera_.dim());
}

/// The convex hull of which a box fitter knows the corners: in 2-D its outline, in 3-D a ring around each corner.
void Stage::draw_hull(Brush& brush) const {
  std::vector<ImVec2> corners;
  for (const Index i : shown_.hull) corners.push_back(brush.at(brush.session.point(i)));
  if (camera_.dim() == 2)
    return path(brush.list, convex_outline(std::move(corners)), true, Stroke::kSolid, brush.p.ink, brush.stroke(0.8f));
  for (const ImVec2 at : corners) ring(brush.list, at, 4 * brush.p.mark, brush.p.ink, brush.stroke(0.6f));
}

/// What the volume is compared with: the one before it, the other algorithm's, the smallest.
void Stage::draw_rivals(Brush& brush) const {
  const Palette& p = brush.p;
  const Canvas& canvas = brush.canvas;
  const int dim = camera_.dim();
  const auto size = [&](const fit::Volume3& volume) {
    const double own = fit::size_of(volume, dim);
    return std::holds_alternative<fit::Sphere3>(volume) ? "r = " + lesson::number_text(own) : size_text(own, dim);
  };
  if (shown_.before) draw_volume(canvas, *shown_.before, {Stroke::kDotted, p.previous, brush.stroke(0.85f)});
  if (shown_.rival) {
    draw_volume(canvas, *shown_.rival,
                {Stroke::kLongDashed, p.previous, brush.stroke(), scene_.three_d ? 0.03f : 0.0f});
    if (fit::size_of(*shown_.rival, dim) > 0)
      brush.label(brush.at(top_of(*shown_.rival, -0.5)), 6, {-0.6f, -1},
                  std::string(brush.session.algorithm(1)->title) + ": " + size(*shown_.rival), p.previous_text);
  }
  if (!shown_.optimum) return;
  const double smallest = fit::size_of(*shown_.optimum, dim);
  const bool same = shown_.volume && std::abs(fit::size_of(*shown_.volume, dim) - smallest) <= 1e-9 * smallest;
  draw_volume(canvas, *shown_.optimum, {Stroke::kDashed, p.optimum, brush.stroke(same ? 2.0f : 1.0f)});
  if (same && !shown_.finished) return;
  const std::string word(lesson::volume_word(brush.session.lesson().volume, dim));
  brush.label(brush.at(top_of(*shown_.optimum, 0.5)), 6, {0.6f, -1},
              same ? "the smallest " + word : "smallest " + size(*shown_.optimum), p.optimum_text);
}

void Stage::draw_candidate(Brush& brush) const {
  if (!shown_.candidate) return;
  const Palette& p = brush.p;
  draw_volume(brush.canvas, *shown_.candidate,
              {Stroke::kDotted, shown_.candidate_fails ? p.wrong : p.previous, brush.stroke()});
  const fit::Sphere3* ball = ball_in(shown_.candidate);
  if (ball != nullptr && shown_.candidate_fails && !scene_.three_d) {
    const auto radius = static_cast<float>(ball->radius * camera_.scale_at(ball->center));
    hatching(brush.list, brush.at(ball->center), radius, with_alpha(p.wrong, 0.16f));
  }
  if (shown_.left_outside == kNoIndex) return;
  const ImVec2 at = brush.at(brush.session.point(shown_.left_outside));
  cross(brush.list, at, 8 * p.mark, p.wrong, brush.stroke(1.2f));
  brush.canvas.obstacles.discs.push_back({at.x, at.y, 10});
  brush.label(at, 12, kRightUp, lesson::point_name(shown_.left_outside) + " outside", p.wrong_text);
}

/// The extreme points along each axis, the box that they span, and its midpoint.
void Stage::draw_extremes(Brush& brush) const {
  const Palette& p = brush.p;
  const Canvas& canvas = brush.canvas;
  if (shown_.box) {
    draw_box(canvas, shown_.box->least, shown_.box->greatest, {Stroke::kSolid, p.previous, brush.stroke(0.55f)});
    const ImVec2 middle = brush.at(shown_.box->midpoint);
    plus(brush.list, middle, 6 * p.mark, p.current, brush.stroke(0.8f));
    if (!shown_.volume) brush.label(middle, 8, kRightUp, "midpoint", p.current_text);
  }
  if (!shown_.extremes) return;
  Point3 least = Point3::Zero(), greatest = Point3::Zero();
  for (int axis = 0; axis < camera_.dim(); ++axis) {
    least[axis] = brush.session.point(shown_.extremes->least[axis])[axis];
    greatest[axis] = brush.session.point(shown_.extremes->greatest[axis])[axis];
  }
  if (!shown_.box && !shown_.volume)
    draw_box(canvas, least, greatest, {Stroke::kDotted, p.previous, brush.stroke(0.7f)});
  if (shown_.volume) return;  // the pair was chosen: its points alone matter now
  for (int axis = 0; axis < camera_.dim(); ++axis) {
    for (const Index i : {shown_.extremes->least[axis], shown_.extremes->greatest[axis]}) {
      const Point3 at = brush.session.point(i);
      for (int other = 0; other < camera_.dim(); ++other) {
        if (other == axis) continue;
        Point3 half = Point3::Zero();
        half[other] = 16 / camera_.scale_at(at);
        line(brush.list, brush.at(at - half), brush.at(at + half), Stroke::kSolid, p.support, brush.stroke(0.9f));
      }
    }
  }
}

/// Mean, covariance and axes: how the points are spread.
void Stage::draw_spread(Brush& brush) const {
  if (!shown_.mean) return;
  const Palette& p = brush.p;
  const Canvas& canvas = brush.canvas;
  const ImVec2 mean = brush.at(*shown_.mean);
  if (shown_.spread) {
    for (const double deviations : {2.0, 1.0}) {
      Ellipsoid ellipsoid{*shown_.mean, shown_.spread->axes};
      for (int i = 0; i < 3; ++i) ellipsoid.half_axes.col(i) *= deviations * shown_.spread->sigma[i];
      draw_volume(canvas, ellipsoid,
                  {deviations == 1.0 ? Stroke::kSolid : Stroke::kDotted, p.current, brush.stroke(0.8f), p.fill * 0.8f});
      if (shown_.spread->named) continue;
      const Point3 end = *shown_.mean + ellipsoid.half_axes.col(2);
      brush.label(brush.at(end), 6, kAbove, deviations == 1.0 ? "1 σ" : "2 σ", p.current_text, Face::kSemiBold, 13);
    }
  }
  if (shown_.spread && shown_.spread->named) {
    for (int i = 3 - camera_.dim(); i < 3; ++i) {
      const Point3 end = *shown_.mean + shown_.spread->axes.col(i) * shown_.spread->sigma[i];
      const ImVec2 tip = brush.at(end);
      const bool main = i == 2;
      arrow(brush.list, mean, tip, main ? p.support : p.ink, brush.stroke(main ? 1.2f : 0.8f));
      brush.canvas.obstacles.segments.push_back({mean.x, mean.y, tip.x, tip.y});
      brush.label(tip, 8, {tip.x - mean.x, tip.y - mean.y}, "σ = " + short_figure(shown_.spread->sigma[i]),
                  main ? p.support_text : p.ink);
    }
  }
  disc(brush.list, mean, 8 * p.mark, p.ground);
  plus(brush.list, mean, 7 * p.mark, p.current, brush.stroke(1.1f));
  canvas.obstacles.discs.push_back({mean.x, mean.y, 9});
  brush.label(mean, 10, {-0.8f, 0.8f}, "mean", p.current_text);
}

/// The first diameter; along the main axis with the projections that chose it.
void Stage::draw_axis_ends(Brush& brush) const {
  if (!shown_.pair) return;
  const Palette& p = brush.p;
  const Point3 a = brush.session.point(shown_.pair->a), b = brush.session.point(shown_.pair->b);
  if (shown_.volume) draw_line(brush.canvas, a, b, {Stroke::kSolid, p.support, brush.stroke(0.8f)});
  if (!shown_.spread || !shown_.spread->ends || !shown_.mean) return;
  const Point3 axis = shown_.spread->axes.col(2);
  const auto foot = [&](const Point3& point) { return Point3(*shown_.mean + axis * axis.dot(point - *shown_.mean)); };
  const Point3 from = foot(a), to = foot(b);
  const Point3 beyond = (to - from) * 0.06;
  // On both sides of the eigenvector's arrow.
  const VolumeStyle dashes{Stroke::kDashed, p.muted, brush.stroke(0.7f)};
  draw_line(brush.canvas, from - beyond, *shown_.mean, dashes);
  draw_line(brush.canvas, *shown_.mean + axis * shown_.spread->sigma[2], to + beyond, dashes);
  for (const auto& [point, base] : {std::pair{a, from}, {b, to}}) {
    draw_line(brush.canvas, point, base, {Stroke::kDotted, p.support, brush.stroke(0.8f)});
    cross(brush.list, brush.at(base), 4 * p.mark, p.muted, brush.stroke(0.7f));
  }
}

}  // namespace snug::app
