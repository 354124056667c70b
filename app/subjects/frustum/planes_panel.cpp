#include "app/subjects/frustum/planes_panel.hpp"

#include <string>
#include <utility>
#include <vector>

#include "app/subjects/frustum/panel_rows.hpp"
#include "lesson/figures.hpp"

namespace snug::app {
namespace {

constexpr float kPlanesTitle = 26, kPlanesGap = 12;

/// "+0.42", "−0.17"
std::string with_sign(double number) { return (number > 0 ? "+" : "") + lesson::number_text(number); }

/// Whether the step, or one before it, tested the plane.
bool tested_by(const lesson::Session& session, int plane) {
  const auto steps = lesson::frustum_run(session.player().run(0)).trace();
  for (int i = 0; i < session.player().step(); ++i) {
    const auto* tested = std::get_if<query::PlaneTested<double, 3>>(&steps[i].step.fact);
    if (tested != nullptr && tested->plane == plane) return true;
  }
  return false;
}

/// A plane's row, on the canvas and in HTML.
struct PlaneRow {
  std::string name, number;  // "Left"; "+0.42", "—" while a later step is asked for it
  bool told, positive;
};

/// Empty for a box, and while a prediction is open.
std::vector<PlaneRow> plane_rows(const lesson::Session& session) {
  const lesson::BoxPair& pair = lesson::boxes_of(session.stage().subject());
  if (pair.form == lesson::Form::kBox || session.telling().predicting()) return {};
  const bool hidden = session.telling().is_hidden("distance");
  std::vector<PlaneRow> rows;
  for (const double distance : lesson::center_distances(pair)) {
    const int plane = static_cast<int>(rows.size());
    std::string name = lesson::plane_name(pair.dim, plane);
    name.front() = static_cast<char>(name.front() - 'a' + 'A');
    const bool told = !hidden || tested_by(session, plane);
    rows.push_back({std::move(name), told ? with_sign(distance) : "—", told, distance > 0});
  }
  return rows;
}

const char* planes_title(const lesson::Session& session) {
  const bool point = lesson::boxes_of(session.stage().subject()).form == lesson::Form::kPoint;
  return point ? "n · p + d, for every plane" : "n · c + d, for every plane";
}

}  // namespace

float draw_planes_panel(const Look& look, const lesson::Session& session, const FrustumShown& shown, ImVec2 at,
                        float width) {
  const std::vector<PlaneRow> planes = plane_rows(session);
  if (planes.empty()) return 0;
  ImDrawList* list = ImGui::GetWindowDrawList();
  text(list, look, Face::kSemiBold, kPanelWords, {at.x, at.y + look.px(5)}, look->muted, planes_title(session));
  PanelRows rows{look, list, at.x, at.y + look.px(kPlanesTitle), width};
  int plane = 0;
  for (const PlaneRow& one : planes) {
    const Color color = !one.told ? look->muted : one.positive ? look->examined_text : look->current_text;
    rows.row(one.name, one.number, color, plane++ == shown.plane_at);
  }
  return rows.y + kPlanesGap - at.y;
}

std::optional<PanelWords> planes_in_words(const lesson::Session& session) {
  std::vector<PlaneRow> planes = plane_rows(session);
  if (planes.empty()) return std::nullopt;
  PanelWords words{{.head = {"", "Number"}, .title = planes_title(session)}};
  for (PlaneRow& one : planes) words.table.rows.push_back({std::move(one.name), std::move(one.number)});
  return words;
}

}  // namespace snug::app
