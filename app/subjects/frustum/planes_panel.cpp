#include "app/subjects/frustum/planes_panel.hpp"

#include <string>
#include <utility>

#include "app/subjects/frustum/panel_rows.hpp"
#include "lesson/figures.hpp"

namespace snug::app {
namespace {

constexpr float kPlanesTitle = 26, kPlanesGap = 12;

/// "+0.42", "−0.17"
std::string with_sign(double number) { return (number > 0 ? "+" : "") + lesson::number_text(number); }

/// Whether the step, or one before it, tested the plane.
bool tested_by(const lesson::Session& session, int plane) {
  const auto steps = lesson::frustum_run(session.run(0)).trace();
  for (int i = 0; i < session.step(); ++i) {
    const auto* tested = std::get_if<query::PlaneTested<double, 3>>(&steps[i].step.fact);
    if (tested != nullptr && tested->plane == plane) return true;
  }
  return false;
}

}  // namespace

float draw_planes_panel(const Look& look, const lesson::Session& session, const FrustumShown& shown, ImVec2 at,
                        float width) {
  const lesson::BoxPair& pair = lesson::boxes_of(session.subject());
  if (pair.form == lesson::Form::kBox || session.predicting()) return 0;
  const std::vector<double> distances = lesson::center_distances(pair);
  if (distances.empty()) return 0;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const bool point = pair.form == lesson::Form::kPoint;
  text(list, look, Face::kSemiBold, kPanelWords, {at.x, at.y + look.px(5)}, look->muted,
       point ? "n · p + d, for every plane" : "n · c + d, for every plane");
  const bool hidden = session.is_hidden("distance");  // a later step is asked for its own
  PanelRows rows{look, list, at.x, at.y + look.px(kPlanesTitle), width};
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const int plane = static_cast<int>(i);
    std::string name = lesson::plane_name(pair.dim, plane);
    name.front() = static_cast<char>(name.front() - 'a' + 'A');
    const bool told = !hidden || tested_by(session, plane);
    rows.row(name, told ? with_sign(distances[i]) : "—",
             !told              ? look->muted
             : distances[i] > 0 ? look->examined_text
                                : look->current_text,
             plane == shown.plane_at);
  }
  return rows.y + kPlanesGap - at.y;
}

std::optional<PanelWords> planes_in_words(const lesson::Session& session) {
  const lesson::BoxPair& pair = lesson::boxes_of(session.subject());
  if (pair.form == lesson::Form::kBox || session.predicting()) return std::nullopt;
  const bool point = pair.form == lesson::Form::kPoint;
  PanelWords words{
      {.head = {"", "Number"}, .title = point ? "n · p + d, for every plane" : "n · c + d, for every plane"}};
  for (const double distance : lesson::center_distances(pair)) {
    const int plane = static_cast<int>(words.table.rows.size());
    std::string name = lesson::plane_name(pair.dim, plane);
    name.front() = static_cast<char>(name.front() - 'a' + 'A');
    words.table.rows.push_back({std::move(name), with_sign(distance)});
  }
  return words;
}

}  // namespace snug::app
