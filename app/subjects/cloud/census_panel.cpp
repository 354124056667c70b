#include "app/subjects/cloud/census_panel.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "app/marks.hpp"
#include "app/widgets.hpp"
#include "lesson/figures.hpp"
#include "lesson/subjects.hpp"
#include "measure/trials.hpp"

namespace snug::app {
namespace {

constexpr float kCensusName = 62, kCensusCount = 66, kCensusRow = 20, kCensusWords = 12;

/// Places along the chart: the logarithm of a ratio.
struct RatioAxis {
  float x, width;
  double least, greatest;
  [[nodiscard]] float at(double ratio) const {
    const double share = (std::log(ratio) - std::log(least)) / (std::log(greatest) - std::log(least));
    return x + width * static_cast<float>(share);
  }
};

RatioAxis axis_over(const std::vector<cost::CensusRow>& rows, float x, float width) {
  RatioAxis axis{x, width, 0.9, 1.1};
  for (const cost::CensusRow& row : rows)
    for (const double ratio : row.ratios)
      axis.least = std::min(axis.least, ratio), axis.greatest = std::max(axis.greatest, ratio);
  return axis;
}

bool compares_both(const lesson::Session& session) {
  const auto has = [&](std::string_view volume, std::string_view name) {
    const auto& names = session.lesson().algorithms;
    return std::any_of(names.begin(), names.end(), [&](const std::string& own) {
      const lesson::Method* method = lesson::find_method(session.lesson(), own);
      return method->volume == volume && method->name == name;
    });
  };
  return session.stage().subject().dim() == 3 && session.player().method(0)->volume == "kdop" && has("kdop", "k14") &&
         has("obb", "exact");
}

}  // namespace

float draw_census_panel(const Look& look, const lesson::Session& session, ImVec2 at, float width) {
  if (!compares_both(session)) return 0;
  const std::vector<cost::CensusRow>& rows = cost::census();
  ImDrawList* list = ImGui::GetWindowDrawList();
  const auto clouds = static_cast<std::int64_t>(rows.size()) * cost::kTrialSeeds;
  text(list, look, Face::kSemiBold, 13, {at.x, at.y + look.px(5)}, look->muted,
       lesson::count_text(clouds) + " clouds: 14-DOP / smallest OBB");
  float y = at.y + look.px(28);
  const RatioAxis axis =
      axis_over(rows, at.x + look.px(kCensusName), width - look.px(kCensusName) - look.px(kCensusCount));
  const float top = y;
  for (const cost::CensusRow& row : rows) {
    const float middle = y + look.px(kCensusRow) / 2;
    text(list, look, Face::kRegular, kCensusWords, {at.x, middle_of(middle, look.px(kCensusWords))}, look->ink,
         row.kind);
    for (const double ratio : row.ratios) {
      const float x = axis.at(ratio);
      list->AddLine({x, middle - look.px(5)}, {x, middle + look.px(5)},
                    with_alpha(ratio < 1 ? look->current : look->support, 0.7f), 1.5f);
    }
    text_right(list, look, Face::kMono, kCensusWords, {at.x + width, middle_of(middle, look.px(kCensusWords))},
               look->ink, std::to_string(row.tighter()) + " of " + std::to_string(row.ratios.size()));
    y += look.px(kCensusRow);
  }
  line(list, {axis.at(1), top}, {axis.at(1), y + 4}, Stroke::kSolid, look->ink, 1);
  y += look.px(6);
  text(list, look, Face::kMono, 11, {axis.x, y}, look->muted, "× " + lesson::number_text(axis.least, 2));
  text_right(list, look, Face::kMono, 11, {axis.x + axis.width, y}, look->muted,
             "× " + lesson::number_text(axis.greatest, 2));
  y += look.px(18);
  return y - at.y +
         paragraph(list, look, Face::kRegular, kCensusWords, 16, {at.x, y}, width, look->muted,
                   "One stroke for each cloud of 30 points. Left of the line the 14-DOP is tighter; the number of such "
                   "clouds is on the right.") +
         look.px(12);
}

}  // namespace snug::app
