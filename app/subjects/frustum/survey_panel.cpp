#include "app/subjects/frustum/survey_panel.hpp"

#include <string>

#include "app/subjects/frustum/panel_rows.hpp"
#include "lesson/figures.hpp"
#include "lesson/subjects/frustum/frustum.hpp"

namespace snug::app {
namespace {

constexpr double kSurveyBudget = 4e6;  // ns of a frame
constexpr float kSurveyGap = 8;

/// "circles"
std::string bodies_word(const lesson::BoxPair& pair) { return lesson::body_word(pair) + "s"; }

void draw_counts(PanelRows& rows, const query::SurveyCounts& counts, int dim) {
  const Look& look = rows.look;
  rows.row("Called intersecting", lesson::count_text(counts.intersecting), look->ink);
  if (dim == 3) {
    rows.row("Touch nothing, near edges", lesson::count_text(counts.false_at_two), look->wrong_text);
    rows.row("Touch nothing, near vertices", lesson::count_text(counts.false_at_more), look->wrong_text);
  } else {
    rows.row("Touch nothing, near vertices", lesson::count_text(counts.false_positives()), look->wrong_text);
  }
  if (counts.intersecting == 0) return;
  const double share = static_cast<double>(counts.false_positives()) / static_cast<double>(counts.intersecting);
  rows.row("False positives among them", lesson::number_text(100 * share, 3) + " %", look->ink);
}

/// The button, or while the survey is on, how far it is.
float draw_survey_button(const Look& look, lesson::Session& session, ImVec2 at, float width, bool& working) {
  using Subject = lesson::FrustumSubject;
  const auto& subject = *lesson::as<Subject>(session.subject());
  const lesson::FrustumSurvey* survey = subject.survey();
  working = survey != nullptr && !survey->done();
  const float height = look.fingers ? 44.0f : look.px(30);
  const std::string bodies = bodies_word(subject.boxes()), all = lesson::count_text(lesson::kSurveySpheres);
  const std::string words = working ? "Tested: " + lesson::count_text(survey->counts().spheres) + " of " + all
                            : survey == nullptr ? "Test " + all + " random " + bodies
                                                : "Tested: " + all + " random " + bodies;
  if (button(ImGui::GetWindowDrawList(), look,
             {.id = "survey",
              .rect = {at.x, at.y, width, height},
              .words = words,
              .kind = ButtonKind::kOutlined,
              .enabled = survey == nullptr,
              .size = 13})) {
    session.inform<Subject>([](Subject& own) { own.start_survey(); });
    working = true;
  } else if (working) {
    session.inform<Subject>([](Subject& own) { own.work_on_survey(kSurveyBudget); });
  }
  return height;
}

}  // namespace

float draw_survey_panel(const Look& look, lesson::Session& session, ImVec2 at, float width, bool& working) {
  const lesson::BoxPair& pair = lesson::boxes_of(session.subject());
  working = false;
  if (pair.form != lesson::Form::kBall || session.predicting()) return 0;
  ImDrawList* list = ImGui::GetWindowDrawList();
  text(list, look, Face::kSemiBold, kPanelWords, {at.x, at.y + look.px(5)}, look->muted,
       "How rare are false positives?");
  float y = at.y + look.px(26);
  y += draw_survey_button(look, session, {at.x, y}, width, working) + kSurveyGap;
  const lesson::FrustumSurvey* survey = lesson::as<lesson::FrustumSubject>(session.subject())->survey();
  if (survey == nullptr) return y - at.y;
  PanelRows rows{look, list, at.x, y, width};
  draw_counts(rows, survey->counts(), pair.dim);
  y = rows.y + kSurveyGap;
  y += paragraph(list, look, Face::kRegular, 12, 17, {at.x, y}, width, look->muted,
                 "With this radius around this frustum, seed " + std::to_string(survey->seed()) +
                     "; whether they touch is decided by their distance from the frustum.");
  return y - at.y;
}

}  // namespace snug::app
