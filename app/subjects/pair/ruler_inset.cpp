// The projections onto an axis in space at reading size: on the stage the axis may point at the eye.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/subjects/pair/draw.hpp"
#include "app/widgets.hpp"
#include "lesson/figures.hpp"
#include "lesson/subjects/pair/box_tests.hpp"

namespace snug::app {
namespace {

using Axis = query::AxisTested<double, 3>;

constexpr float kRulerWidth = 272, kRulerHeight = 96, kRulerRim = 12;  // pixels at 100 %
constexpr float kRulerLine = 50, kBarA = 10, kBarB = 22;  // the axis below the panel's top, the bars above the axis
constexpr float kBarDistance = 9, kRulerWords = 18,
                kHalfEnd = 4;  // below the axis; half of the stroke across a bar's end

/// The axis, drawn from the left to the right of the panel.
struct FlatRuler {
  Brush& brush;
  Rect panel;
  double first, scale;

  FlatRuler(Brush& b, const Axis& axis, const Rect& rect) : brush(b), panel(rect), first(ends_of(axis)[0]) {
    scale = static_cast<double>(panel.width - 2 * px(kRulerRim)) / (ends_of(axis)[1] - first);
  }
  [[nodiscard]] float px(float pixels) const { return brush.look.px(pixels); }
  [[nodiscard]] ImVec2 at(double t, float below) const {
    return {panel.x + px(kRulerRim) + static_cast<float>((t - first) * scale), panel.y + px(kRulerLine + below)};
  }
  void bar(double from, double to, float below, Color color, float width) const {
    const ImVec2 a = at(from, below), b = at(to, below);
    line(brush.list, a, b, Stroke::kSolid, color, brush.stroke(width));
    for (const ImVec2 end : {a, b})
      line(brush.list, {end.x, end.y - kHalfEnd}, {end.x, end.y + kHalfEnd}, Stroke::kSolid, color, brush.stroke(0.8f));
  }
  /// A box's interval: the half towards the other box is solid.
  void interval(std::string_view name, double middle, double inwards, float lane) const {
    const Palette& p = brush.p;
    bar(middle - inwards, middle, -lane, with_alpha(p.current, 0.45f), 1.2f);
    bar(middle, middle + inwards, -lane, p.current, 2.4f);
    disc(brush.list, at(middle, 0), 3.5f * p.mark, p.current);
    // The name of A at the left of its bar, that of B at the right.
    const ImVec2 size = measure(brush.look, Face::kSemiBold, 12, name);
    const double half = std::abs(inwards);
    const ImVec2 end = at(inwards > 0 ? middle - half : middle + half, -lane);
    text(brush.list, brush.look, Face::kSemiBold, 12,
         {inwards > 0 ? std::max(panel.x + 3, end.x - size.x - 5)
                      : std::min(panel.x + panel.width - size.x - 3, end.x + 5),
          end.y - size.y / 2},
         p.current_text, name);
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

Rect draw_ruler(Brush& brush, int dim, const Axis& axis, ImVec2 at) {
  const Palette& p = brush.p;
  const Rect panel{at.x, at.y, brush.look.px(kRulerWidth), ruler_height(brush.look)};
  const ImVec2 low{panel.x, panel.y}, high{panel.x + panel.width, panel.y + panel.height};
  brush.list->AddRectFilled(low, high, p.panel, 8);
  brush.list->AddRect(low, high, p.line, 8, 0, 1);
  text(brush.list, brush.look, Face::kSemiBold, 12, {low.x + kRulerRim / 2, low.y + 4}, p.muted,
       lesson::axis_text(dim, axis.axis));
  const FlatRuler ruler(brush, axis, panel);
  const auto [first, last] = ends_of(axis);
  const double from = axis.radius_a, to = axis.distance - axis.radius_b;
  brush.list->AddRectFilled(ruler.at(std::min(from, to), -kBarB), ruler.at(std::max(from, to), 0),
                            with_alpha(axis.separates ? p.wrong : p.examined, 0.18f));
  line(brush.list, ruler.at(first, 0), ruler.at(last, 0), Stroke::kSolid, axis.separates ? p.wrong : p.muted,
       brush.stroke(0.8f));
  ruler.interval("A", 0, axis.radius_a, kBarA);
  ruler.interval("B", axis.distance, -axis.radius_b, kBarB);
  ruler.bar(0, axis.distance, kBarDistance, p.ink, 1.2f);
  const std::string sum = "r_A + r_B " + lesson::length_along(axis, axis.radius_a + axis.radius_b);
  ruler.say(axis.distance / 2, kRulerWords,
            "distance " + lesson::length_along(axis, axis.distance) + (axis.separates ? " > " : " ≤ ") + sum,
            axis.separates ? p.wrong_text : p.ink);
  return panel;
}

}  // namespace snug::app
