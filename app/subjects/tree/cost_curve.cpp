// What a split at each border is expected to cost, for both axes.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/marks.hpp"
#include "app/subjects/tree/draw.hpp"
#include "lesson/figures.hpp"

namespace snug::app {
namespace {

constexpr float kCurveHeight = 96, kCurveFoot = 20, kCurveLeft = 34, kCurveWords = 11;

struct CostCurve {
  const Look& look;
  const hierarchy::SplitsPriced& priced;
  ImDrawList* list;
  ImVec2 low, high;  // the plot
  double least = 0, greatest = 0;

  CostCurve(const Look& own, const hierarchy::SplitsPriced& fact, ImVec2 at, float width)
      : look(own), priced(fact),
        list(ImGui::GetWindowDrawList()), low{at.x + own.px(kCurveLeft), at.y + 8}, high{at.x + width - own.px(16),
                                                                                         at.y + own.px(kCurveHeight)} {
    least = greatest = fact.cost_at(fact.axis, fact.border);
    for (const double cost : fact.costs)
      if (std::isfinite(cost)) greatest = std::max(greatest, cost);
    if (!(greatest > least)) greatest = least + 1;
  }

  [[nodiscard]] ImVec2 at(int border, double cost) const {
    const float share = static_cast<float>(border) / static_cast<float>(priced.borders() + 1);
    const auto up = static_cast<float>((cost - least) / (greatest - least));
    return {low.x + share * (high.x - low.x), high.y - up * (high.y - low.y)};
  }

  void axis(int along) const {
    if (!std::isfinite(priced.cost_at(along, 1))) return;
    const bool chosen = along == priced.axis;
    const Color color = chosen ? look->current : look->previous;
    std::vector<ImVec2> points;
    for (int border = 1; border <= priced.borders(); ++border)
      points.push_back(at(border, priced.cost_at(along, border)));
    path(list, points, false, chosen ? Stroke::kSolid : Stroke::kDotted, color, chosen ? 2.0f : 1.5f);
    for (const ImVec2 point : points) disc(list, point, chosen ? 2.6f : 2, color);
  }
  /// The names of both curves at their ends, one above the other where these meet.
  void names() const {
    const float height = look.px(13);
    std::array<float, 2> middles{};
    for (const int along : {0, 1}) middles[along] = at(priced.borders(), priced.cost_at(along, priced.borders())).y;
    const bool both = std::isfinite(middles[0]) && std::isfinite(middles[1]);
    if (const float gap = std::abs(middles[0] - middles[1]); both && gap < height) {
      const int upper = middles[0] < middles[1] || (gap == 0 && priced.axis == 1) ? 0 : 1;
      middles[upper] -= (height - gap) / 2;
      middles[1 - upper] += (height - gap) / 2;
    }
    for (const int along : {0, 1}) {
      if (!std::isfinite(middles[along])) continue;
      text(list, look, Face::kSemiBold, 13, {high.x + 4, middle_of(middles[along], height)},
           along == priced.axis ? look->current_text : look->previous_text, std::string(1, "xy"[along]));
    }
  }

  void frame() const {
    rule(low.x, high.y, high.x);
    text_right(list, look, Face::kMono, kCurveWords, {low.x - 6, middle_of(high.y, look.px(kCurveWords))}, look->muted,
               lesson::number_text(least, 3));
    text_right(list, look, Face::kMono, kCurveWords, {low.x - 6, middle_of(low.y, look.px(kCurveWords))}, look->muted,
               lesson::number_text(greatest, 3));
  }
  void rule(float x, float y, float to) const { list->AddLine({x, y}, {to, y}, look->line, 1); }

  void minimum() const {
    const ImVec2 best = at(priced.border, least);
    diamond(list, best, 6, look->support, look->panel);
    const std::string words = std::string(1, "xy"[priced.axis]) + " = " +
                              lesson::number_text(priced.position(priced.axis, priced.border)) + ": " +
                              lesson::number_text(least);
    const float half = measure(look, Face::kSemiBold, 12, words).x / 2;
    const float x = std::clamp(best.x, low.x + half, std::max(low.x + half, high.x - half));
    text_middle(list, look, Face::kSemiBold, 12, {x, high.y + 6}, look->support_text, words);
  }
};

}  // namespace

float draw_cost_curve(const Look& look, const hierarchy::SplitsPriced& priced, ImVec2 at, float width) {
  const CostCurve curve(look, priced, at, width);
  curve.frame();
  for (const int along : {1 - priced.axis, priced.axis}) curve.axis(along);
  curve.names();
  curve.minimum();
  return look.px(kCurveHeight + kCurveFoot) + 6;
}

}  // namespace snug::app
