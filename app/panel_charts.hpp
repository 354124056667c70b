// Small charts beside the stage: curves over the length of something, and bars that compare a lesson's methods.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/look.hpp"
#include "imgui.h"
#include "lesson/session.hpp"

namespace snug::app {

/// A curve; x goes from 0 to 1 over the chart's width.
struct PanelCurve {
  std::vector<ImVec2> places;
  bool chosen = true;              // solid, in the colour of the current volume; others are dashed
  std::optional<std::size_t> dot;  // the place that is shown now
};

struct PanelBar {
  std::string title;
  std::optional<double> value;  // none while it is still to be predicted
  bool chosen = false, compared = false;
};

/// A figure of each of the lesson's methods at the end of its run.
[[nodiscard]] std::vector<PanelBar> bars_of_methods(const lesson::Session& session, std::string_view key);

/// Charts one below the other, in the current pane.
class PanelCharts {
 public:
  PanelCharts(const Look& look, ImVec2 at, float width);
  [[nodiscard]] float height() const { return y_ - top_; }

  /// most: the upper end of the scale, which begins at 0, and its text; ends: what stands below both ends of the axis.
  void curves(std::string_view title, std::span<const PanelCurve> curves, double most, const std::string& most_text,
              const std::array<std::string, 2>& ends);
  /// Counts, whole numbers.
  void bars(std::string_view title, std::span<const PanelBar> bars);

 private:
  void heading(std::string_view words);
  void curve(const PanelCurve& one, ImVec2 at, ImVec2 size, double most);
  void bar(const PanelBar& one, double most);

  const Look& look_;
  ImDrawList* list_;
  float x_, width_, top_, y_;
};

}  // namespace snug::app
