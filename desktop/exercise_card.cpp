#include "desktop/exercise_card.hpp"

#include "app/marks.hpp"
#include "app/timeline_map.hpp"
#include "desktop/prose.hpp"
#include "desktop/shell.hpp"
#include "lesson/exercise/build.hpp"
#include "lesson/figures.hpp"
#include "lesson/say.hpp"

namespace snug::desktop {

using app::ButtonKind;
using app::Face;
using lesson::AnswerState;

namespace {

constexpr Writing kPromptWriting{16, 23}, kClaimWriting{15, 22};

/// Each level that is asked for, with a tick where the stage reaches it, and a ring where it was reached before. When
/// it is over what was reached has the ticks, whatever stands there: a solution may reach more.
void draw_levels(Column& column, const lesson::Sitting& sitting, const lesson::Session& session) {
  const std::vector<std::string> words = level_texts(sitting.exercise(), session);
  if (words.size() < 2) return;
  const app::Look& look = column.look();
  const int best = sitting.best() ? sitting.best()->level : 0;
  const int now = sitting.finished(session) ? best : level_of(sitting.exercise(), session);
  column.gap(6);
  float x = 0;
  for (int level = 1; const std::string& text : words) {
    const bool is_now = level <= now, was = level++ <= best;
    const Face face = is_now ? Face::kSemiBold : Face::kRegular;
    const float width = app::measure(look, face, 14, text).x + look.px(36);
    if (x > 0 && x + width > column.width()) x = 0, column.gap(look.px(24));
    const ImVec2 mark{column.x() + x + look.px(6), column.y() + look.px(10)};
    if (is_now) app::tick(column.list(), mark, 5, look->optimum, 2);
    else if (was) app::ring(column.list(), mark, 5, look->ink, 1.5f);
    else column.list()->AddCircleFilled(mark, 2, look->muted);
    app::text(column.list(), look, face, 14, {column.x() + x + look.px(18), column.y() + look.px(3)},
              is_now ? look->optimum_text
              : was  ? look->ink
                     : look->muted,
              text);
    x += width;
  }
  column.gap(look.px(28));
}

/// Whether all levels are reached on the stage, and were not before it was over.
bool is_solved_beyond(const lesson::Sitting& sitting, const lesson::Session& session) {
  return sitting.exercise().build && level_of(sitting.exercise(), session) == sitting.of() && sitting.best() &&
         sitting.best()->level < sitting.of();
}

}  // namespace

std::pair<std::string, std::string> decision_place(const lesson::Sitting& sitting, const lesson::Session& session) {
  const bool tells = sitting.tells_at_once() || sitting.finished(session);
  const bool counted = app::count_known(sitting.exercise());
  return {"Decision " + std::to_string(sitting.at(session) + 1) +
              (counted ? " of " + std::to_string(sitting.of()) : ""),
          sitting.practises() ? std::string(lesson::kPracticeSays)
          : tells             ? "mark " + lesson::plain_number(sitting.mark(session))
                              : "told at the end"};
}

void draw_before(Column& column, const lesson::Sitting& sitting, const lesson::Session& session) {
  if (!sitting.tells_at_once() || session.log().outcomes().empty() || session.conversation().tried() != nullptr) return;
  const lesson::Outcome& last = session.log().outcomes().back();
  if (!last.right) return;
  const app::Look& look = column.look();
  app::tick(column.list(), {column.x() + 6, column.y() + look.px(10)}, 5, look->optimum, 2);
  Column beside(look, column.x() + 20, column.y(), column.width() - 20);
  beside.words(last.says, Face::kRegular, 14, look->muted);
  column.gap(beside.y() - column.y() + 6);
}

void draw_rule(Column& column, const lesson::Sitting& sitting, const lesson::Session& session) {
  const std::string says = sitting.rule_says(session);
  if (says.empty()) return;
  const app::Look& look = column.look();
  column.gap(6);
  Column beside(look, column.x() + 12, column.y(), column.width() - 12);
  beside.words(says, Face::kRegular, 14, look->ink);
  column.list()->AddRectFilled({column.x(), column.y()}, {column.x() + 3, beside.y()}, look->wrong);
  column.gap(beside.y() - column.y());
}

void draw_hints(Column& column, const lesson::Sitting& sitting, const lesson::Session& session) {
  draw_rule(column, sitting, session);
  for (const std::string& hint : sitting.hints(session)) {
    column.gap(6);
    column.words("Hint: " + hint, Face::kRegular, 14);
  }
}

std::string mark_words(const lesson::Marked& marked, bool practises) {
  const std::string mark = practises ? std::string() : lesson::plain_number(marked.mark);
  if (marked.hints == 0) return mark;
  const std::string hints = marked.hints == 1 ? "1 hint" : std::to_string(marked.hints) + " hints";
  return mark.empty() ? hints : mark + ", " + hints;
}

std::string draw_mark(Shell& shell, Column& column, const lesson::Sitting& sitting) {
  const lesson::Session& session = shell.session();
  const bool practises = sitting.practises();
  draw_kicker(column, practises ? lesson::kPracticeWord : lesson::kYourMarkWord, {}, AnswerState::kOpen);
  if (!practises)
    column.words(lesson::plain_number(sitting.mark(session)) + " of " + std::to_string(sitting.of()), Face::kSemiBold,
                 24);
  if (const std::string best = practises ? std::string() : shell.best_says(); !best.empty())
    column.words(best, Face::kRegular, 13, column.look()->muted);
  for (const std::string& says : sitting.rules_followed(session)) column.gap(4), column.words(says, Face::kRegular, 14);
  const RowButton runs{"other_run", lesson::kBothRunsWord, ButtonKind::kQuiet};
  column.gap(4);
  const bool goes = !sitting.exercise().build &&
                    draw_row(column, sitting.first_difference(session), column.look()->ink, {&runs, 1}) == 0;
  column.gap(8);
  if (sitting.exercise().build) draw_levels(column, sitting, session);
  if (is_solved_beyond(sitting, session))
    column.words(lesson::kModelStandsSays, Face::kRegular, 13, column.look()->muted);
  std::string command = draw_lines(shell, column, sitting.marked(session));
  std::vector<RowButton> row;
  if (sitting.exercise().build) row.push_back({"show_model", lesson::kShowModelWord, ButtonKind::kQuiet});
  row.push_back({"other_terms", practises ? lesson::kForMarkWord : lesson::kWithoutMarkWord, ButtonKind::kQuiet});
  if (!practises) row.push_back({"hand_in", lesson::kHandInWord});
  row.push_back({"to_lesson", lesson::kToLessonWord});
  if (sitting.leads_on(session)) row.push_back({"harder", lesson::kHarderWord, ButtonKind::kPrimary});
  else row.push_back({"another", lesson::kAnotherInstanceWord, ButtonKind::kPrimary});
  const int clicked = draw_row(column, {}, 0, row);
  return goes ? runs.id : clicked < 0 ? command : row[clicked].id;
}

std::string draw_right_run(Column& column, const lesson::Sitting& sitting, const lesson::Session& session) {
  draw_kicker(column, lesson::kRightRunWord, {}, AnswerState::kOpen);
  column.words(sitting.compared(session));
  column.gap(8);
  const std::array<RowButton, 2> row{
      {{"last", lesson::kYourMarkWord, ButtonKind::kQuiet}, {"other_run", lesson::kYourRunWord}}};
  const int clicked = draw_row(column, {}, 0, row);
  return clicked < 0 ? std::string() : row[clicked].id;
}

std::string draw_build(Shell& shell, Column& column, const lesson::Sitting& sitting) {
  const lesson::Session& session = shell.session();
  const lesson::Exercise& exercise = sitting.exercise();
  const std::string mark =
      "mark " + lesson::plain_number(sitting.mark(session)) + " of " + std::to_string(sitting.of());
  const bool breaks = !exercise.build->claim.empty();
  draw_kicker(column, breaks ? lesson::kBreakWord : lesson::kBuildWord,
              sitting.practises() ? std::string(lesson::kPracticeSays) : mark, AnswerState::kOpen);
  lesson::ProseFigures figures(session.conversation());
  if (breaks) draw_prompt(column, "“" + exercise.build->claim + "”", figures, kClaimWriting), column.gap(6);
  draw_prompt(column, exercise.stage.tasks.front().prompt, figures, kPromptWriting);
  draw_levels(column, sitting, session);
  draw_hints(column, sitting, session);
  column.gap(8);
  const int now = level_of(exercise, session), best = sitting.best() ? sitting.best()->level : 0;
  const std::string hint = sitting.hint_words(session);
  std::vector<RowButton> row;
  if (!hint.empty()) row.push_back({"hint", hint, ButtonKind::kQuiet});
  row.push_back({"reset_points", lesson::kStartAgainWord, ButtonKind::kQuiet});
  if (best > now) row.push_back({"back_to_best", lesson::kBackToBestWord});
  row.push_back({"finish", lesson::kFinishWord, ButtonKind::kPrimary, best > 0});
  column.words(lesson::now_says(session), Face::kRegular, 13, column.look()->muted);
  column.gap(8);
  const int clicked = draw_row(column, {}, 0, row);
  return clicked < 0 ? std::string() : row[clicked].id;
}

}  // namespace snug::desktop
