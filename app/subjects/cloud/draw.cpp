// Draws the geometry that a fitter's step is about, and its marks on the points.
#include "app/subjects/cloud/draw.hpp"

#include <cmath>

#include "app/fitted.hpp"
#include "app/point_marks.hpp"
#include "app/subjects/cloud/ulp_inset.hpp"
#include "lesson/figures.hpp"

namespace snug::app {
namespace {

constexpr ImVec2 kRightUp{1, -0.6f};

/// Draws a volume that was tried but not kept.
void draw_candidate(Brush& brush, const CloudShown& shown) {
  if (!shown.candidate) return;
  const Palette& p = brush.p;
  draw_volume(brush.canvas, *shown.candidate,
              {Stroke::kDotted, shown.candidate_fails ? p.wrong : p.previous, brush.stroke()});
  const fit::Sphere3* ball = ball_in(shown.candidate);
  if (ball != nullptr && shown.candidate_fails && !brush.canvas.gl.three_d) {
    const auto radius = static_cast<float>(ball->radius * brush.canvas.camera.scale_at(ball->center));
    hatching(brush.list, brush.at(ball->center), radius, with_alpha(p.wrong, 0.16f));
  }
  if (shown.left_outside == kNoIndex) return;
  const ImVec2 at = brush.at(brush.session.stage().subject().at(shown.left_outside));
  cross(brush.list, at, 8 * p.mark, p.wrong, brush.stroke(1.2f));
  brush.canvas.obstacles.discs.push_back({at.x, at.y, 10});
  brush.label(at, 12, kRightUp, brush.session.stage().subject().name_of(shown.left_outside) + " outside", p.wrong_text);
}

/// The extreme points, axis by axis, until there is a volume; from then on only its support set matters.
std::vector<Index> extremes_alone(const Brush& brush, const CloudShown& shown) {
  std::vector<Index> points;
  if (!shown.extremes || shown.volume) return points;
  for (int axis = 0; axis < brush.dim(); ++axis)
    for (const Index i : {shown.extremes->least[axis], shown.extremes->greatest[axis]}) points.push_back(i);
  return points;
}

/// Draws short strokes perpendicular to an axis, at a point that is extreme along it.
void draw_strokes_across(Brush& brush, const Point3& at, int axis) {
  for (int other = 0; other < brush.dim(); ++other) {
    if (other == axis) continue;
    Point3 half = Point3::Zero();
    half[other] = 16 / brush.canvas.camera.scale_at(at);
    line(brush.list, brush.at(at - half), brush.at(at + half), Stroke::kSolid, brush.p.support, brush.stroke(0.9f));
  }
}

/// Draws the AABB of the extreme points with its centre; and these points, until there is a volume.
void draw_extremes(Brush& brush, const CloudShown& shown) {
  const Palette& p = brush.p;
  if (shown.box) {
    draw_box(brush.canvas, shown.box->least, shown.box->greatest, {Stroke::kSolid, p.previous, brush.stroke(0.55f)});
    const ImVec2 middle = brush.at(shown.box->midpoint);
    plus(brush.list, middle, 6 * p.mark, p.current, brush.stroke(0.8f));
    if (!shown.volume) brush.label(middle, 8, kRightUp, "AABB centre", p.current_text);
  }
  const std::vector<Index> extremes = extremes_alone(brush, shown);
  if (extremes.empty()) return;
  Point3 least = Point3::Zero(), greatest = Point3::Zero();
  for (int axis = 0; axis < brush.dim(); ++axis) {
    least[axis] = brush.session.stage().subject().at(extremes[2 * axis])[axis];
    greatest[axis] = brush.session.stage().subject().at(extremes[2 * axis + 1])[axis];
  }
  if (!shown.box) draw_box(brush.canvas, least, greatest, {Stroke::kDotted, p.previous, brush.stroke(0.7f)});
  for (int k = 0; k < 2 * brush.dim(); ++k)
    draw_strokes_across(brush, brush.session.stage().subject().at(extremes[k]), k / 2);
}

}  // namespace

void draw_cloud(Brush& brush, const CloudShown& shown) {
  draw_box_fit(brush, shown);
  draw_growing_hull(brush, shown);
  draw_products(brush, shown);
  draw_spread(brush, shown);
  draw_extremes(brush, shown);
  if (shown.before) draw_volume(brush.canvas, *shown.before, {Stroke::kDotted, brush.p.previous, brush.stroke(0.85f)});
  draw_compared(brush, shown);
  draw_candidate(brush, shown);
  draw_fitted(brush, shown);
  draw_growth(brush, shown);
  draw_slab(brush, shown);
  draw_axis_ends(brush, shown);
}

void mark_cloud(Brush& brush, const CloudShown& shown) {
  const std::vector<Index> extremes = extremes_alone(brush, shown);
  if (extremes.empty()) draw_support(brush, shown);
  for (const Index i : shown.forced)
    ring(brush.list, brush.at(brush.point(i)), kRing * brush.p.mark, brush.p.support, brush.stroke(0.7f));
  for (const Index i : extremes) mark_point(brush, i);
  if (shown.pair && !shown.volume)
    for (const Index i : {shown.pair->a, shown.pair->b}) mark_point(brush, i);
  draw_spoken_of(brush, shown);
  mark_slab(brush, shown);
  mark_left_outside(brush, shown);
  for (const Index i : shown.wrong) cross(brush.list, brush.at(brush.point(i)), 9 * brush.p.mark, brush.p.wrong, 2);
  draw_examined(brush, shown, extremes.empty() && among(shown.support, shown.examined));
}

void name_cloud(PointNames& names, const CloudShown& shown) {
  const Palette& p = names.brush.p;
  if (shown.left_outside != kNoIndex) names.skip(shown.left_outside);
  if (shown.examined != kNoIndex) {
    std::string words = names.brush.session.stage().subject().name_of(shown.examined);
    if (shown.examined_outside && shown.outside_by > 0) words += " outside by " + lesson::number_text(shown.outside_by);
    else if (shown.outside_by < 0) words += " inside";
    const bool wrong = std::find(shown.wrong.begin(), shown.wrong.end(), shown.examined) != shown.wrong.end();
    names.name(shown.examined, words + (wrong ? ": wrong" : ""), wrong ? p.wrong_text : p.examined_text,
               Face::kSemiBold, 19 * p.mark, 15);
  }
  name_left_outside(names, shown);
  name_slab(names, shown);
  const std::vector<Index> extremes = extremes_alone(names.brush, shown);
  names.plain(extremes.empty() ? shown.support : extremes);
  if (shown.pair)
    for (const Index i : {shown.pair->a, shown.pair->b}) names.plain(i);
}

}  // namespace snug::app
