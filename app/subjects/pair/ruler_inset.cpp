// The projections onto an axis in space at reading size: on the stage the axis may point at the eye.
#include <algorithm>
#include <array>

#include "app/subjects/pair/draw.hpp"
#include "app/widgets.hpp"
#include "lesson/figures.hpp"
#include "lesson/subjects/pair/box_tests.hpp"

namespace snug::app {
namespace {

using Axis = query::AxisTested<double, 3>;

// Pixels at 100 %. Of the axis, from the panel's top; of bars and words, from the axis.
constexpr float kRulerWidth = 272, kRulerHeight = 96, kRulerRim = 12, kRulerLine = 50;
constexpr float kBarA = 10, kBarB = 22, kBarDistance = 9, kRulerWords = 18;

/// The axis, drawn from the left to the right of the panel.
struct FlatRuler {
  Brush& brush;
  Rect panel;
  std::array<double, 2> ends;

  [[nodiscard]] float px(float pixels) const { return brush.look.px(pixels); }
  [[nodiscard]] ImVec2 at(double t, float below) const {
    const double share = (t - ends[0]) / (ends[1] - ends[0]), width = panel.width - 2 * px(kRulerRim);
    return {panel.x + px(kRulerRim) + static_cast<float>(share * width), panel.y + px(kRulerLine + below)};
  }
  void bar(double from, double to, float below, Color color, float width) const {
    draw_bar(brush, at(from, below), at(to, below), {0, 1}, color, width);
  }
  /// A box's interval: the half towards the other box is solid.
  void interval(std::string_view name, double middle, double inwards, float lane) const {
    const Palette& p = brush.p;
    bar(middle - inwards, middle, -lane, with_alpha(p.current, 0.45f), 1.2f);
    bar(middle, middle + inwards, -lane, p.current, 2.4f);
    disc(brush.list, at(middle, 0), 3.5f * p.mark, p.current);
    // The name stands beyond the half that is away from the other box.
    const ImVec2 size = measure(brush.look, Face::kSemiBold, 12, name), end = at(middle - inwards, -lane);
    const float x = inwards > 0 ? std::max(panel.x + 3, end.x - size.x - 5)
                                : std::min(panel.x + panel.width - size.x - 3, end.x + 5);
    text(brush.list, brush.look, Face::kSemiBold, 12, {x, end.y - size.y / 2}, p.current_text, name);
  }
  /// Words below the axis, within the panel.
  void say(double middle, float below, std::string_view words, Color color) const {
    const float width = measure(brush.look, Face::kSemiBold, 12, words).x, rim = px(kRulerRim) / 2;
    const float x = std::clamp(at(middle, 0).x - width / 2, panel.x + rim,
                               std::max(panel.x + rim, panel.x + panel.width - rim - width));
    text(brush.list, brush.look, Face::kSemiBold, 12, {x, panel.y + px(kRulerLine + below)}, color, words);
  }
};

}  // namespace

float ruler_height(const Look& look) { return look.px(kRulerHeight); }

Rect draw_ruler(Brush& brush, const Axis& axis, ImVec2 at) {
  const Palette& p = brush.p;
  const FlatRuler ruler{brush, {at.x, at.y, brush.look.px(kRulerWidth), ruler_height(brush.look)}, ends_of(axis)};
  brush.panel(ruler.panel);
  text(brush.list, brush.look, Face::kSemiBold, 12, {at.x + kRulerRim / 2, at.y + 4}, p.muted,
       lesson::axis_text(brush.dim(), axis.axis));
  const double from = axis.radius_a, to = axis.distance - axis.radius_b;
  brush.list->AddRectFilled(ruler.at(std::min(from, to), -kBarB), ruler.at(std::max(from, to), 0),
                            with_alpha(axis.separates ? p.wrong : p.examined, 0.18f));
  line(brush.list, ruler.at(ruler.ends[0], 0), ruler.at(ruler.ends[1], 0), Stroke::kSolid,
       axis.separates ? p.wrong : p.muted, brush.stroke(0.8f));
  ruler.interval("A", 0, axis.radius_a, kBarA);
  ruler.interval("B", axis.distance, -axis.radius_b, kBarB);
  ruler.bar(0, axis.distance, kBarDistance, p.ink, 1.2f);
  // A test with a tolerance may find no gap although the distance is the greater.
  const double sum = axis.radius_a + axis.radius_b;
  ruler.say(axis.distance / 2, kRulerWords,
            "distance " + lesson::length_along(axis, axis.distance) + (axis.distance > sum ? " > " : " ≤ ") +
                "r_A + r_B " + lesson::length_along(axis, sum),
            axis.separates ? p.wrong_text : p.ink);
  return ruler.panel;
}

}  // namespace snug::app
