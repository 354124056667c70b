#include "app/subjects/scene/update_costs.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "app/panel_charts.hpp"
#include "lesson/prose_figures.hpp"
#include "lesson/subjects/scene/scene.hpp"
#include "lesson/subjects/scene/scene_figures.hpp"

namespace snug::app {
namespace {

constexpr double kLeastLooseness = 1;  // %, the smallest end of the scale: less is mostly rounding

/// A figure of a slot after a step. 0 where there is none.
double figure_after(const lesson::Session& session, int slot, int step, std::string_view key) {
  const auto& fact = lesson::scene_run(session.player().run(slot)).entry(step - 1).step.fact;
  const double value = lesson::figure_of(*std::get_if<lesson::FrameTaken>(&fact), key);
  return std::isfinite(value) ? value : 0;
}

/// A figure of each frame so far, over the whole run.
PanelCurve curve_of(const lesson::Session& session, int slot, std::string_view key) {
  PanelCurve curve{.places = {}, .chosen = slot == 0, .dot = {}};
  const auto steps = static_cast<float>(session.player().run(slot).steps());
  for (int step = 1; step <= session.player().step_of(slot); ++step)
    curve.places.emplace_back(static_cast<float>(step) / steps,
                              static_cast<float>(figure_after(session, slot, step, key)));
  if (slot == 0 && !curve.places.empty()) curve.dot = curve.places.size() - 1;
  return curve;
}

/// Nothing while the figure is still to be predicted.
void frame_by_frame(PanelCharts& charts, const lesson::Session& session, const std::string& title, std::string_view key,
                    double least) {
  if (session.telling().is_hidden(key)) return;
  std::vector<PanelCurve> curves;
  for (const int slot : {1, 0})
    if (session.player().method(slot) != nullptr) curves.push_back(curve_of(session, slot, key));
  double most = least;
  for (const PanelCurve& curve : curves)
    for (const ImVec2 place : curve.places) most = std::max(most, static_cast<double>(place.y));
  charts.curves(title + ", frame by frame", curves, most, lesson::scene_figure_text(key, most),
                {"frame 1", std::to_string(session.player().steps())});
}

}  // namespace

float draw_update_costs(const Look& look, const lesson::Session& session, ImVec2 at, float width) {
  PanelCharts charts(look, at, width);
  frame_by_frame(charts, session, "Looseness", "slack", kLeastLooseness);
  frame_by_frame(charts, session, "Points examined", "cost", 1);
  if (const auto bars = bars_of_methods(session, "cost"); bars.size() > 1)
    charts.bars("Points examined in frame " + std::to_string(session.player().steps()), bars);
  return charts.height();
}

}  // namespace snug::app
