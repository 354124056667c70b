// The geometry that a step speaks of.
#include <algorithm>
#include <cmath>

#include "app/numbers.hpp"
#include "app/stage_brush.hpp"
#include "lesson/figures.hpp"

namespace snug::app {
namespace {

constexpr ImVec2 kAbove{0.2f, -1}, kRightUp{1, -0.6f};

ImVec2 unit(ImVec2 v) {
  const float length = std::hypot(v.x, v.y);
  return length > 0 ? ImVec2{v.x / length, v.y / length} : ImVec2{1, 0};
}

}  // namespace

void Stage::draw_volumes(Brush& brush) const {
  draw_spread(brush);
  draw_extremes(brush);
  draw_rivals(brush);
  draw_candidate(brush);
  draw_ball(brush);
  draw_axis_ends(brush);
  // The farthest first, so that the nearer ones tint what lies behind them.
  std::sort(brush.canvas.gl.volumes.begin(), brush.canvas.gl.volumes.end(), [&](const GlVolume& a, const GlVolume& b) {
    return (a.center - scene_.eye).squaredNorm() > (b.center - scene_.eye).squaredNorm();
  });
}

/// The current ball with its centre and radius.
void Stage::draw_ball(Brush& brush) const {
  if (!ball_) return;
  const Palette& p = brush.p;
  const Canvas& canvas = brush.canvas;
  draw_volume(canvas, *ball_, {Stroke::kSolid, p.current, brush.stroke(), p.fill});
  const ImVec2 center = brush.at(ball_->center);
  plus(brush.list, center, 5 * p.mark, p.current, brush.stroke(0.7f));
  canvas.obstacles.discs.push_back({center.x, center.y, 7});
  if (ball_->radius <= 0) return;
  // To a point that holds the ball, preferably one on the right, where its label reads as the line's.
  Point3 rim = ball_->center + camera_.right() * ball_->radius;
  double best = -2;
  for (const Index i : shown_.support) {
    const Point3 way = brush.session.point(i) - ball_->center;
    const double right = way.dot(camera_.right()) / ball_->radius;
    if (std::abs(way.norm() - ball_->radius) < 0.02 * ball_->radius && right > best) best = right, rim = brush.session.point(i);
  }
  draw_line(canvas, ball_->center, rim, {Stroke::kSolid, p.current, brush.stroke(0.65f)});
  const ImVec2 end = brush.at(rim);
  const ImVec2 along = unit({end.x - center.x, end.y - center.y});
  const ImVec2 aside = along.x >= 0 ? ImVec2{along.y, -along.x} : ImVec2{-along.y, along.x};  // upwards
  if (std::hypot(end.x - center.x, end.y - center.y) < 36) return;
  brush.label({center.x + (end.x - center.x) * 0.55f, center.y + (end.y - center.y) * 0.55f}, 4, aside,
              "r = " + lesson::number_text(shown_.ball ? shown_.ball->radius : ball_->radius), p.current_text);
}

/// What the ball is compared with: the one before it, the other algorithm's, the smallest.
void Stage::draw_rivals(Brush& brush) const {
  const Palette& p = brush.p;
  const Canvas& canvas = brush.canvas;
  const auto top_of = [&](const fit::Sphere3& ball, double right) {
    return brush.at(ball.center + (camera_.up() * std::sqrt(1 - right * right) + camera_.right() * right) * ball.radius);
  };
  if (shown_.before) draw_volume(canvas, *shown_.before, {Stroke::kDotted, p.previous, brush.stroke(0.85f)});
  if (shown_.rival) {
    draw_volume(canvas, *shown_.rival, {Stroke::kLongDashed, p.previous, brush.stroke(), scene_.three_d ? 0.03f : 0.0f});
    if (shown_.rival->radius > 0) brush.label(top_of(*shown_.rival, -0.5), 6, {-0.6f, -1},
                std::string(brush.session.algorithm(1)->title) + " r = " + lesson::number_text(shown_.rival->radius), p.previous_text);
  }
  if (!shown_.optimum) return;
  const bool same = shown_.ball && std::abs(shown_.ball->radius - shown_.optimum->radius) <= 1e-9 * shown_.optimum->radius;
  draw_volume(canvas, *shown_.optimum, {Stroke::kDashed, p.optimum, brush.stroke(same ? 2.0f : 1.0f)});
  if (same && !shown_.finished) return;
  brush.label(top_of(*shown_.optimum, 0.5), 6, {0.6f, -1},
              same ? "the smallest ball" : "smallest r = " + lesson::number_text(shown_.optimum->radius), p.optimum_text);
}

void Stage::draw_candidate(Brush& brush) const {
  if (!shown_.candidate) return;
  const Palette& p = brush.p;
  draw_volume(brush.canvas, *shown_.candidate, {Stroke::kDotted, shown_.candidate_fails ? p.wrong : p.previous, brush.stroke()});
  const float radius = static_cast<float>(shown_.candidate->radius * camera_.scale_at(shown_.candidate->center));
  if (shown_.candidate_fails && !scene_.three_d) hatching(brush.list, brush.at(shown_.candidate->center), radius, with_alpha(p.wrong, 0.16f));
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
    if (!shown_.ball) brush.label(middle, 8, kRightUp, "midpoint", p.current_text);
  }
  if (!shown_.extremes) return;
  Point3 least = Point3::Zero(), greatest = Point3::Zero();
  for (int axis = 0; axis < camera_.dim(); ++axis) {
    least[axis] = brush.session.point(shown_.extremes->least[static_cast<std::size_t>(axis)])[axis];
    greatest[axis] = brush.session.point(shown_.extremes->greatest[static_cast<std::size_t>(axis)])[axis];
  }
  if (!shown_.box && !shown_.ball) draw_box(canvas, least, greatest, {Stroke::kDotted, p.previous, brush.stroke(0.7f)});
  if (shown_.ball) return;  // the pair was chosen: its points alone matter now
  for (int axis = 0; axis < camera_.dim(); ++axis) {
    for (const Index i : {shown_.extremes->least[static_cast<std::size_t>(axis)], shown_.extremes->greatest[static_cast<std::size_t>(axis)]}) {
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
      draw_volume(canvas, ellipsoid, {deviations == 1.0 ? Stroke::kSolid : Stroke::kDotted, p.current, brush.stroke(0.8f), p.fill * 0.8f});
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
  if (shown_.ball) draw_line(brush.canvas, a, b, {Stroke::kSolid, p.support, brush.stroke(0.8f)});
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
