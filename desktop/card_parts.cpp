#include "desktop/card_parts.hpp"

#include <algorithm>

#include "app/marks.hpp"
#include "desktop/exercise_card.hpp"
#include "desktop/shell.hpp"
#include "lesson/prose_figures.hpp"
#include "lesson/say.hpp"

namespace snug::desktop {

using app::ButtonKind;
using app::Face;
using lesson::AnswerState;

namespace {

/// What a row's text should have beside its buttons, pixels at 100 %: else it stands above them.
constexpr float kLeastText = 150;

}  // namespace

int draw_row(Column& column, std::string_view says, app::Color color, std::span<const RowButton> buttons) {
  const app::Look& look = column.look();
  const float height = look.px(34), gap = 8;
  std::vector<float> widths;
  float all = 0;
  for (const RowButton& one : buttons) {
    widths.push_back(std::max(app::measure(look, Face::kSemiBold, 14, one.words).x + look.px(26), look.px(56)));
    all += widths.back() + gap;
  }
  const float room = column.width() - all - 8;
  Column words(look, column.x(), column.y(), room < look.px(kLeastText) ? column.width() : room);
  if (!says.empty()) {
    const auto lines = app::lines_of(look, Face::kRegular, 13, says, words.width()).size();
    words.gap(std::max(0.0f, (height - look.px(20) * static_cast<float>(lines)) / 2));
    words.words(says, Face::kRegular, 13, color);
  }
  if (room < look.px(kLeastText) && !says.empty()) column.gap(words.y() - column.y() + 8);
  int clicked = -1;
  const float right = column.x() + column.width();
  float x = std::max(column.x(), right - all + gap);
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    if (x > column.x() && x + widths[i] > right + 1) column.gap(height + gap), x = column.x();  // in rows
    if (app::button(column.list(), look,
                    {.id = buttons[i].id,
                     .rect = {x, column.y(), widths[i], height},
                     .words = buttons[i].words,
                     .kind = buttons[i].kind,
                     .enabled = buttons[i].enabled,
                     .size = 14}))
      clicked = static_cast<int>(i);
    x += widths[i] + gap;
  }
  column.gap(std::max(height, room < look.px(kLeastText) ? 0.0f : words.y() - column.y()));
  return clicked;
}

void draw_kicker(Column& column, std::string_view words, std::string_view place, AnswerState standing) {
  const app::Look& look = column.look();
  const bool right = standing == AnswerState::kRight, wrong = standing == AnswerState::kWrong;
  const app::Color color = right                               ? look->optimum_text
                           : wrong                             ? look->wrong_text
                           : standing == AnswerState::kSkipped ? look->muted
                                                               : look->current_text;
  const float middle = column.y() + look.px(10), inset = right || wrong ? 22 : 0;
  if (right) app::tick(column.list(), {column.x() + 6, middle}, 6, look->optimum, 2.25f);
  if (wrong) app::cross(column.list(), {column.x() + 6, middle}, 5, look->wrong, 2.25f);
  const float y = column.y() + look.px(3);
  app::text(column.list(), look, Face::kSemiBold, 13, {column.x() + inset, y}, color, words);
  const float said = app::measure(look, Face::kSemiBold, 13, words).x;
  if (!place.empty())
    app::text(column.list(), look, Face::kRegular, 13, {column.x() + inset + said, y}, look->muted,
              " · " + std::string(place));
  column.gap(look.px(26));
}

std::string draw_lines(Shell& shell, Column& column, const std::vector<lesson::Marked>& marked) {
  const lesson::Session& session = shell.session();
  const app::Look& look = column.look();
  std::string command;
  int number = 0;
  lesson::ProseFigures figures(session.conversation());
  for (const lesson::Asked& asked : session.conversation().questions()) {
    const std::string prompt = plain_now(asked.prompt, figures);
    const lesson::Outcome* outcome = session.conversation().outcome_of(asked);
    const float height = look.px(32), middle = column.y() + height / 2;
    const std::string id = "line " + std::to_string(number++);
    app::rule(column.list(), column.x(), column.y(), column.width(), look->line);
    const app::Touch touch = app::touch_area(id.c_str(), {column.x(), column.y(), column.width(), height}, prompt);
    if (touch.hovered)
      column.list()->AddRectFilled({column.x() - 6, column.y() + 1},
                                   {column.x() + column.width() + 6, column.y() + height - 1}, look->raised, 6);
    if (touch.clicked) command = "review:" + asked.question->id;
    const AnswerState standing = lesson::answer_state_of(outcome);
    const bool right = standing == AnswerState::kRight, wrong = standing == AnswerState::kWrong;
    const ImVec2 mark{column.x() + 6, middle};
    if (right) app::tick(column.list(), mark, 5, look->optimum, 2);
    else if (wrong) app::cross(column.list(), mark, 4, look->wrong, 2);
    else column.list()->AddLine({mark.x - 4, mark.y}, {mark.x + 4, mark.y}, look->muted, 2);
    const std::string line =
        (marked.empty() ? std::string() : std::to_string(number) + ". ") + std::string(lesson::short_prompt(prompt));
    const std::string stands = marked.empty() ? std::string(lesson::answer_state_text(outcome))
                                              : mark_words(marked[number - 1], shell.app().sitting()->practises());
    const float width = app::measure(look, Face::kSemiBold, 13, stands).x;
    app::text_right(column.list(), look, Face::kSemiBold, 13,
                    {column.x() + column.width(), app::middle_of(middle, look.px(13))},
                    right   ? look->optimum_text
                    : wrong ? look->wrong_text
                            : look->muted,
                    stands);
    app::text(column.list(), look, Face::kRegular, 14, {column.x() + 22, app::middle_of(middle, look.px(14))},
              look->ink, app::shortened(look, Face::kRegular, 14, line, column.width() - width - 40));
    column.gap(height);
  }
  app::rule(column.list(), column.x(), column.y(), column.width(), look->line);
  column.gap(12);
  return command;
}

}  // namespace snug::desktop
