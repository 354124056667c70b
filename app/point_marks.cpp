#include "app/point_marks.hpp"

#include <algorithm>
#include <utility>

namespace snug::app {

bool among(const std::vector<Index>& points, Index i) {
  return std::find(points.begin(), points.end(), i) != points.end();
}

void mark_point(Brush& brush, Index i) {
  const Palette& p = brush.p;
  const ImVec2 place = brush.at(brush.point(i));
  diamond(brush.list, place, kDiamond * p.mark, p.support, p.ground);
  brush.canvas.obstacles.discs.push_back({place.x, place.y, kDiamond * p.mark});
}

void draw_support(Brush& brush, const Shown& shown) {
  for (const Index i : shown.support) mark_point(brush, i);
}

void draw_spoken_of(Brush& brush, const Shown& shown) {
  const Palette& p = brush.p;
  for (const Index i : shown.spoken_of)
    diamond(brush.list, brush.at(brush.point(i)), kDiamond * p.mark, p.support, p.ground);
}

void draw_examined(Brush& brush, const Shown& shown, bool marked) {
  if (shown.examined == kNoIndex) return;
  const Palette& p = brush.p;
  const ImVec2 point = brush.at(brush.point(shown.examined));
  if (!marked) disc(brush.list, point, (brush.point_radius + 1) * p.mark, p.examined);
  ring(brush.list, point, (kRing + 4) * p.mark, p.examined, brush.stroke());
  brush.canvas.obstacles.discs.push_back({point.x, point.y, kRing + 6});
}

PointNames::PointNames(Brush& on, const Point3& middle)
    : brush(on), named_(on.session.stage().subject().size(), false), middle_(on.at(middle)) {}

void PointNames::name(Index i, std::string words, Color color, Face face, float gap, float size, bool optional) {
  if (i == kNoIndex || named_[i]) return;
  named_[i] = true;
  const ImVec2 at = brush.at(brush.point(i));
  brush.label(at, std::max(gap, brush.view.reach_of(brush, i)), {at.x - middle_.x, at.y - middle_.y}, std::move(words),
              color, face, size, optional);
  if (brush.view.names_over_bodies(brush.session)) brush.labels.back().plate = true;
}

void PointNames::plain(Index i) {
  if (i == kNoIndex) return;
  name(i, brush.session.stage().subject().name_of(i), brush.p.support_text, Face::kSemiBold, 11 * brush.p.mark);
}

void PointNames::plain(const std::vector<Index>& all) {
  constexpr std::size_t kMost = 30;
  if (all.size() > kMost) return;
  for (const Index i : all) plain(i);
}

void PointNames::on_plate(Index i) {
  if (i == kNoIndex || named_[i]) return;
  name(i, brush.session.stage().subject().name_of(i), brush.p.ink, Face::kSemiBold, 11 * brush.p.mark, 13);
  brush.labels.back().plate = true;
}

}  // namespace snug::app
