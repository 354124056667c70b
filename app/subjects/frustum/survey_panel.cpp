#include "app/subjects/frustum/survey_panel.hpp"

#include <string>
#include <string_view>
#include <vector>

#include "app/subjects/frustum/panel_rows.hpp"
#include "lesson/figures.hpp"
#include "lesson/subjects/frustum/frustum.hpp"

namespace snug::app {
namespace {

constexpr double kSurveyBudget = 4e6;  // ns of a frame
constexpr float kSurveyGap = 8;
constexpr std::string_view kSurveyTitle = "How rare are false positives?";

/// "circles"
std::string bodies_word(const lesson::BoxPair& pair) { return lesson::body_word(pair) + "s"; }

struct CountRow {
  std::string name, value;
  bool wrong = false;
};

std::vector<CountRow> count_rows(const cost::SurveyCounts& counts, int dim) {
  std::vector<CountRow> rows{{"Called intersecting", lesson::count_text(counts.intersecting)}};
  if (dim == 3) {
    rows.push_back({"Touch nothing, near edges", lesson::count_text(counts.false_at_two), true});
    rows.push_back({"Touch nothing, near vertices", lesson::count_text(counts.false_at_more), true});
  } else {
    rows.push_back({"Touch nothing, near vertices", lesson::count_text(counts.false_positives()), true});
  }
  if (counts.intersecting == 0) return rows;
  const double share = static_cast<double>(counts.false_positives()) / static_cast<double>(counts.intersecting);
  rows.push_back({"False positives among them", lesson::number_text(100 * share, 3) + " %"});
  return rows;
}

std::string survey_note(const lesson::FrustumSurvey& survey) {
  return "With this radius around this frustum, seed " + std::to_string(survey.seed()) +
         "; whether they touch is decided by their distance from the frustum.";
}

const lesson::FrustumSubject& surveyed(const lesson::Session& session) {
  return *lesson::as<lesson::FrustumSubject>(session.stage().subject());
}

bool can_survey(const lesson::Session& session) {
  return surveyed(session).boxes().form == lesson::Form::kBall && !session.telling().predicting();
}

/// The button, or while the survey is on, how far it is.
CoverButton survey_button(const lesson::FrustumSubject& subject) {
  const lesson::FrustumSurvey* survey = subject.survey();
  const std::string bodies = bodies_word(subject.boxes()), all = lesson::count_text(lesson::kSurveySpheres);
  const bool working = survey != nullptr && !survey->done();
  return {.command = std::string(kSurveyCommand),
          .words = working             ? "Tested: " + lesson::count_text(survey->counts().spheres) + " of " + all
                   : survey == nullptr ? "Test " + all + " random " + bodies
                                       : "Tested: " + all + " random " + bodies,
          .enabled = survey == nullptr};
}

}  // namespace

bool start_survey(lesson::Session& session) {
  if (!can_survey(session) || surveyed(session).survey() != nullptr) return false;
  session.inform<lesson::FrustumSubject>([](lesson::FrustumSubject& own) { own.start_survey(); });
  return true;
}

bool work_on_survey(lesson::Session& session) {
  const lesson::FrustumSurvey* survey = surveyed(session).survey();
  if (!can_survey(session) || survey == nullptr || survey->done()) return false;
  session.inform<lesson::FrustumSubject>([](lesson::FrustumSubject& own) { own.work_on_survey(kSurveyBudget); });
  return true;
}

std::optional<PanelWords> survey_in_words(const lesson::Session& session) {
  if (!can_survey(session)) return std::nullopt;
  PanelWords words{{.head = {"", "Count"}, .title = std::string(kSurveyTitle)}, "", survey_button(surveyed(session))};
  const lesson::FrustumSurvey* survey = surveyed(session).survey();
  if (survey == nullptr) return words;
  for (const CountRow& row : count_rows(survey->counts(), session.stage().subject().dim()))
    words.table.rows.push_back({row.name, row.value});
  words.says = survey_note(*survey);
  return words;
}

float draw_survey_panel(const Look& look, lesson::Session& session, ImVec2 at, float width) {
  if (!can_survey(session)) return 0;
  ImDrawList* list = ImGui::GetWindowDrawList();
  text(list, look, Face::kSemiBold, kPanelWords, {at.x, at.y + look.px(5)}, look->muted, kSurveyTitle);
  float y = at.y + look.px(26);
  const CoverButton words = survey_button(surveyed(session));
  const float height = look.fingers ? 44.0f : look.px(30);
  if (button(list, look,
             {.id = "survey",
              .rect = {at.x, y, width, height},
              .words = words.words,
              .kind = ButtonKind::kOutlined,
              .enabled = words.enabled,
              .size = 13}))
    start_survey(session);
  y += height + kSurveyGap;
  const lesson::FrustumSurvey* survey = surveyed(session).survey();
  if (survey == nullptr) return y - at.y;
  PanelRows rows{look, list, at.x, y, width};
  for (const CountRow& row : count_rows(survey->counts(), session.stage().subject().dim()))
    rows.row(row.name, row.value, row.wrong ? look->wrong_text : look->ink);
  y = rows.y + kSurveyGap;
  y += paragraph(list, look, Face::kRegular, 12, 17, {at.x, y}, width, look->muted, survey_note(*survey));
  return y - at.y;
}

}  // namespace snug::app
