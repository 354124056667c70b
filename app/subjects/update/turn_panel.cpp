#include "app/subjects/update/turn_panel.hpp"

#include <algorithm>
#include <cmath>

#include "app/panel_charts.hpp"
#include "lesson/prose_figures.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects/update/update.hpp"
#include "lesson/subjects/update/update_figures.hpp"

namespace snug::app {
namespace {

constexpr int kPosesOfTurn = 72;       // 5 degrees from one to the next
constexpr double kLeastOfScale = 10;   // %, the smallest end of the scale
constexpr double kMostOfScale = 1000;  // %, for a body whose tightest volume is nearly flat

/// The step of the turn at which the body stands: in space the curve begins where it is.
std::size_t step_now(const lesson::UpdateSubject& body) {
  const double degrees = body.dim() == 2 ? body.degrees() : 0;
  return std::lround((degrees + 180) / 360 * kPosesOfTurn);
}

PanelCurve curve_over_turn(const lesson::UpdateSubject& body, const lesson::Method& method, bool chosen) {
  PanelCurve curve{.places = {}, .chosen = chosen, .dot = {}};
  const std::vector<double> slack = body.slack_over_turn(method, kPosesOfTurn);
  for (std::size_t i = 0; i < slack.size(); ++i)
    curve.places.emplace_back(static_cast<float>(i) / kPosesOfTurn,
                              static_cast<float>(std::min(kMostOfScale, 100 * slack[i])));
  if (chosen) curve.dot = step_now(body);
  return curve;
}

void draw_looseness(PanelCharts& charts, const lesson::Session& session) {
  const lesson::UpdateSubject& body = lesson::body_of(session.stage().subject());
  std::vector<PanelCurve> curves;
  for (const int slot : {1, 0})
    if (session.player().method(slot) != nullptr &&
        lesson::may_tell_result(session.conversation(), *session.player().method(slot), lesson::kUpdateSlack))
      curves.push_back(curve_over_turn(body, *session.player().method(slot), slot == 0));
  if (curves.empty()) return;
  double most = kLeastOfScale;
  for (const PanelCurve& curve : curves)
    for (const ImVec2 place : curve.places) most = std::max(most, static_cast<double>(place.y));
  charts.curves(body.dim() == 2 ? "Looseness over a whole turn" : "Looseness over a whole turn about z", curves, most,
                lesson::without_plus(lesson::percent_text(most / 100)), {"−180°", "180°"});
}

}  // namespace

float draw_turn_panel(const Look& look, const lesson::Session& session, ImVec2 at, float width) {
  PanelCharts charts(look, at, width);
  draw_looseness(charts, session);
  if (const auto bars = bars_of_methods(session, "cost"); bars.size() > 1)
    charts.bars("Points examined in this update", bars);
  return charts.height();
}

}  // namespace snug::app
