#include "app/subjects/pair/random_panel.hpp"

#include <algorithm>
#include <string>

#include "app/widgets.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects/pair/pair.hpp"

namespace snug::app {
namespace {

constexpr float kRandomHeading = 24, kRandomRow = 17, kRandomName = 78, kRandomCount = 68, kRandomWords = 11,
                kRandomLeading = 17;

/// Whether a question about these counts is open: then they are hidden.
bool counts_hidden(const lesson::Session& session) {
  for (const lesson::Figure& figure : session.telling().figures())
    if (figure.key.starts_with(lesson::kRandomFigure) && session.telling().is_hidden(figure.key)) return true;
  return false;
}

/// "1,000 random pairs, seed 1"
std::string random_title(const lesson::Session& session, const cost::AxisCounts& counts) {
  return lesson::count_text(counts.pairs) + " random pairs, seed " +
         std::to_string(session.stage().subject().origin().seed);
}

constexpr std::string_view kCountsHidden = "Shown once the question about them is answered.";

}  // namespace

std::optional<PanelWords> random_in_words(const lesson::Session& session) {
  const cost::AxisCounts* counts = lesson::as<lesson::PairSubject>(session.stage().subject())->random_counts();
  if (counts == nullptr) return std::nullopt;
  PanelWords words{{.head = {"Axis", "The test ends there", "It separates"}, .title = random_title(session, *counts)}};
  if (counts_hidden(session)) return words.says = kCountsHidden, words;
  const auto names = lesson::axis_names(session.stage().subject().dim());
  for (std::size_t row = 0; row < names.size(); ++row)
    words.table.rows.push_back(
        {std::string(names[row].text), std::to_string(counts->first[row]), std::to_string(counts->separates[row])});
  words.says = lesson::count_text(counts->overlap) + " pairs overlap.";
  return words;
}

float draw_random_panel(const Look& look, const lesson::Session& session, ImVec2 at, float width) {
  const auto& subject = *lesson::as<lesson::PairSubject>(session.stage().subject());
  const cost::AxisCounts* counts = subject.random_counts();
  if (counts == nullptr) return 0;
  ImDrawList* list = ImGui::GetWindowDrawList();
  text(list, look, Face::kSemiBold, 13, {at.x, at.y + look.px(5)}, look->muted, random_title(session, *counts));
  float y = at.y + look.px(kRandomHeading);
  if (counts_hidden(session)) {
    y += paragraph(list, look, Face::kRegular, kRandomWords, kRandomLeading, {at.x, y}, width, look->muted,
                   kCountsHidden);
    return y - at.y;
  }
  const auto names = lesson::axis_names(subject.dim());
  const int most = std::max(1, *std::max_element(counts->separates.begin(), counts->separates.end()));
  const float room = width - look.px(kRandomName + kRandomCount), left = at.x + look.px(kRandomName);
  for (std::size_t row = 0; row < names.size(); ++row, y += look.px(kRandomRow)) {
    const float middle = middle_of(y + look.px(kRandomRow) / 2, look.px(kRandomWords));
    const auto bar = [&](int count, float top, float bottom, Color color) {
      const float length = room * static_cast<float>(count) / static_cast<float>(most);
      list->AddRectFilled({left, y + look.px(top)}, {left + length, y + look.px(bottom)}, color);
    };
    text(list, look, Face::kMono, kRandomWords, {at.x, middle}, look->ink, names[row].text);
    bar(counts->separates[row], 3, kRandomRow - 3, look->track);
    bar(counts->first[row], 5, kRandomRow - 5, look->wrong);
    text_right(list, look, Face::kMono, kRandomWords, {at.x + width, middle}, look->ink,
               std::to_string(counts->first[row]) + " of " + std::to_string(counts->separates[row]));
  }
  y += look.px(4);
  y += paragraph(list, look, Face::kRegular, kRandomWords, kRandomLeading, {at.x, y}, width, look->muted,
                 "Dark: the test ends there. Pale: the axis separates the pair. " +
                     lesson::count_text(counts->overlap) + " pairs overlap.");
  return y - at.y;
}

}  // namespace snug::app
