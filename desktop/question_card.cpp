#include "desktop/question_card.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "app/marks.hpp"
#include "desktop/column.hpp"
#include "desktop/exercise_card.hpp"
#include "desktop/prose.hpp"
#include "lesson/say.hpp"
#include "lesson/situations.hpp"
#include "lesson/subjects.hpp"

namespace snug::desktop {
namespace {

using app::ButtonKind;
using app::Face;
using lesson::Standing;

constexpr Writing kPromptWriting{16, 23};
constexpr float kPad = 20, kBeside = 24, kBelow = 12, kWheel = 48;

struct RowButton {
  const char* id;
  std::string_view words;
  ButtonKind kind = ButtonKind::kOutlined;
  bool enabled = true;
};

/// What a row's text should have beside its buttons, pixels at 100 %: else it stands above them.
constexpr float kLeastText = 150;
constexpr float kAnswerAndSkip = 150;  // both buttons, at least

/// Draws buttons at the right end of a row, after its text. Returns the one that was clicked, or -1.
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
  float x = column.x() + column.width() - all + gap;
  for (std::size_t i = 0; i < buttons.size(); ++i) {
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

/// "Your prediction · 2 of 4", after the mark of its outcome.
void draw_kicker(Column& column, std::string_view words, std::string_view place, Standing standing) {
  const app::Look& look = column.look();
  const bool right = standing == Standing::kRight, wrong = standing == Standing::kWrong;
  const app::Color color = right                            ? look->optimum_text
                           : wrong                          ? look->wrong_text
                           : standing == Standing::kSkipped ? look->muted
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

/// A field for a number, or to name handles without pointing at them: type it and press Enter.
bool draw_answer_field(Shell& shell, Column& column, std::string_view label) {
  const app::Look& look = column.look();
  ImGui::PushFont(look.font(Face::kRegular), app::font_size(look, Face::kRegular, 14));
  ImGui::SetCursorScreenPos({column.x(), column.y()});
  ImGui::SetNextItemWidth(look.px(140));
  const std::string hint(label);
  const bool entered = ImGui::InputTextWithHint("##name", hint.c_str(), shell.typed.data(), shell.typed.size(),
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  app::offer_field(hint);
  column.gap(ImGui::GetFrameHeight() + 10);
  ImGui::PopFont();
  if (!entered) return false;
  if (shell.typed[0] == 0) return shell.app().command("commit_answer");  // one that was tapped
  if (shell.session().pick(std::string_view(shell.typed.data()))) shell.session().commit();
  shell.typed = {};
  return true;
}

/// The choices, with marks at those that are chosen but not committed yet, and at the one that was tried.
struct Choices {
  std::vector<std::string> words;
  int chosen = -1;
};

Choices choices_of(const lesson::Session& session, const lesson::Asked& asked) {
  const lesson::Answer *picked = session.picked(), *tried = session.tried();
  std::vector<std::string> words = asked.choices;
  int chosen = -1;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const int choice = static_cast<int>(i);
    if (!asked.ordered && tried != nullptr && is_picked(asked, *tried, choice)) words[i] = "✕ " + words[i];
    if (asked.ordered) {
      const int place = picked != nullptr ? place_in_order(*picked, choice) : 0;
      words[i] = (place > 0 ? std::to_string(place) : "·") + "  " + words[i];
      continue;
    }
    if (picked == nullptr || !is_picked(asked, *picked, choice)) continue;
    if (asked.many) words[i] = "✓ " + words[i];
    else chosen = choice;
  }
  return {std::move(words), chosen};
}

/// The choices, once the right one was asked for: it has a tick, and the one that was given a cross.
void draw_right_choices(Column& column, const lesson::Session& session, const lesson::Asked& asked,
                        const lesson::Outcome& outcome) {
  const app::Look& look = column.look();
  const std::vector<int> right = session.right_choices();
  const float height = look.px(32), gap = 8;
  float x = 0;
  for (std::size_t i = 0; i < asked.choices.size(); ++i) {
    const int choice = static_cast<int>(i);
    const bool is_right = std::find(right.begin(), right.end(), choice) != right.end();
    const bool wrong = !is_right && is_picked(asked, outcome.given, choice);
    const float inset = is_right || wrong ? look.px(20) : 0;
    const float words =
        std::min(app::measure(look, Face::kSemiBold, 14, asked.choices[i]).x, column.width() - inset - look.px(26));
    const float width = words + inset + look.px(26);
    if (x > 0 && x + width > column.width()) x = 0, column.gap(height + gap);
    const ImVec2 low{column.x() + x, column.y()}, high{low.x + width, low.y + height};
    const ImVec2 mark{low.x + look.px(19), low.y + height / 2};
    const app::Color color = is_right ? look->optimum_text : wrong ? look->wrong_text : look->muted;
    column.list()->AddRect(low, high, is_right || wrong ? color : look->line, 8, 0, is_right ? 2.0f : 1.0f);
    if (is_right) app::tick(column.list(), mark, 5, look->optimum, 2);
    if (wrong) app::cross(column.list(), mark, 4, look->wrong, 2);
    app::text(column.list(), look, is_right ? Face::kSemiBold : Face::kRegular, 14,
              {low.x + look.px(13) + inset, app::middle_of(low.y + height / 2, look.px(14))}, color,
              app::shortened(look, Face::kSemiBold, 14, asked.choices[i], words + 1));
    x += width + gap;
  }
  column.gap(height + gap);
}

void draw_question(Shell& shell, Column& column, const lesson::Asked& asked) {
  lesson::Session& session = shell.session();
  const app::Look& look = column.look();
  lesson::ProseFigures figures(session);
  const lesson::Sitting* const sitting = shell.app().sitting();
  const auto [words, place] = sitting != nullptr ? decision_place(*sitting, session)
                                                 : std::pair(std::string(lesson::kPredictionWord),
                                                             lesson::place_text(asked, session.questions()));
  draw_kicker(column, words, place, Standing::kOpen);
  if (sitting != nullptr) draw_before(column, *sitting, session);
  draw_prompt(column, asked.prompt, figures, kPromptWriting);
  if (sitting != nullptr) draw_hints(column, *sitting, session);
  column.gap(10);
  const bool ready = session.picked() != nullptr && answers(asked, *session.picked());
  const std::string hint = sitting != nullptr ? hint_words(sitting->next_price(session)) : std::string();
  std::vector<RowButton> row;
  // A choice is given by choosing it.
  if (sitting == nullptr || asked.on_stage || asked.many || asked.ordered || asked.number)
    row.push_back({"commit_answer", lesson::kAnswerWord, ButtonKind::kPrimary, ready});
  if (sitting == nullptr) row.push_back({"skip_question", lesson::kSkipWord, ButtonKind::kQuiet});
  if (sitting != nullptr && !session.conduct().told && !session.given().empty())
    row.push_back({"take_back", lesson::kTakeBackWord, ButtonKind::kQuiet});
  if (!hint.empty()) row.push_back({"hint", hint, ButtonKind::kQuiet});
  const Choices choices = choices_of(session, asked);
  const int chosen = column.buttons("choice", choices.words, choices.chosen);
  const float beside = column.row_taken();
  const std::string_view field = lesson::field_word(asked);
  if (!field.empty() && draw_answer_field(shell, column, field)) return;
  std::string says = session.answer_says().empty() ? lesson::how_to_answer(asked) : session.answer_says();
  const bool wrong = session.tried() != nullptr && session.picked() == nullptr;
  if (shell.presenting && session.answer_says().empty()) (says += ' ') += lesson::kSkipHint;  // a clicker has no other
  const app::Color color = session.answer_says().empty() ? look->muted : wrong ? look->wrong_text : look->current_text;
  // What is said of the choices and gives the answer stands after the last of them, where a row has room for it: the
  // figure needs the height.
  const bool flows = beside > 0 && beside + look.px(kLeastText + kAnswerAndSkip) < column.width();
  if (flows) column.gap(-look.px(34) - 8);
  Column last(look, column.x() + (flows ? beside : 0), column.y(), column.width() - (flows ? beside : 0));
  const int clicked = draw_row(last, says, color, row);
  column.gap(last.y() - column.y());
  if (chosen >= 0) shell.app().pick_choice(chosen);
  else if (clicked >= 0) shell.app().command(row[clicked].id);
}

void draw_said(Column& column, const lesson::Session& session, const lesson::Outcome& outcome) {
  if (outcome.skipped) return;
  const std::string_view what = session.conduct().decides ? lesson::kDecisionWord : lesson::kPredictionWord;
  column.words(std::string(what) + ": " + outcome.predicted, Face::kSemiBold, 15);
  column.gap(4);
}

/// The card while the steps up to the outcome are played: it tells nothing yet.
void draw_deciding(Column& column, const lesson::Session& session, const lesson::Outcome& outcome) {
  const lesson::Asked* asked = session.question_of(outcome);
  draw_kicker(column, lesson::kPredictionWord,
              asked != nullptr ? lesson::place_text(*asked, session.questions()) : std::string(), Standing::kOpen);
  lesson::ProseFigures figures(session);
  if (asked != nullptr) draw_prompt(column, asked->prompt, figures, kPromptWriting), column.gap(6);
  draw_said(column, session, outcome);
  column.words(lesson::kWatching, Face::kRegular, 13, column.look()->muted);
}

/// The card with the outcome, until it is dismissed.
void draw_outcome(Shell& shell, Column& column, const lesson::Outcome& outcome) {
  const lesson::Session& session = shell.session();
  const app::Look& look = column.look();
  const lesson::Asked* asked = session.question_of(outcome);
  draw_kicker(column, lesson::verdict_text(outcome),
              asked != nullptr ? lesson::place_text(*asked, session.questions()) : std::string(),
              lesson::standing_of(&outcome));
  lesson::ProseFigures figures(session);
  if (asked != nullptr)
    draw_prompt(column, asked->prompt, figures, {14, 21, Face::kRegular, look->muted}), column.gap(6);
  draw_said(column, session, outcome);
  if (session.answer_shown() && asked != nullptr && !asked->choices.empty() && !asked->ordered) {
    draw_right_choices(column, session, *asked, outcome);
  } else if (session.answer_shown()) {
    app::tick(column.list(), {column.x() + 6, column.y() + look.px(11)}, 6, look->optimum, 2.25f);
    Column beside(look, column.x() + 22, column.y(), column.width() - 22);
    beside.words(outcome.happened, Face::kSemiBold, 15, look->optimum_text);
    column.gap(beside.y() - column.y() + 4);
  }
  column.words(outcome.says);
  if (!outcome.because.empty()) column.gap(4), draw_prompt(column, outcome.because, figures, {15, 22});
  if (const lesson::Sitting* const sitting = shell.app().sitting()) draw_rule(column, *sitting, session);
  column.gap(12);
  std::vector<RowButton> row;
  std::vector<std::string_view> commands;
  const auto offer = [&](const RowButton& one, std::string_view command) {
    row.push_back(one), commands.push_back(command);
  };
  if (session.can_show_answer() && !session.answer_shown()) offer({"show", lesson::kShowMeWord}, "show_answer");
  if (session.can_watch_outcome()) offer({"watch", lesson::kWatchWord}, "watch_outcome");
  offer({"continue", lesson::kContinueWord, ButtonKind::kPrimary}, "continue");
  if (const int clicked = draw_row(column, {}, 0, row); clicked >= 0) shell.app().command(commands[clicked]);
}

/// Questions of the lesson that are still open: under what title, and the command that leads to them.
struct Waiting {
  std::string title, command;
};

std::vector<Waiting> waiting_in(const lesson::Session& session) {
  std::vector<Waiting> all;
  for (const lesson::Method* method : session.waiting())
    all.push_back({lesson::title_in(session.lesson(), *method), "ask:" + lesson::name_in(session.lesson(), *method)});
  for (const std::string& name : session.situations_waiting())
    all.push_back({lesson::situation_title(session.lesson(), name), "situation:" + name});
  return all;
}

/// Each question in a line that leads back to its reason. Returns the command of the line that was clicked.
std::string draw_lines(Shell& shell, Column& column, const std::vector<lesson::Marked>& marked) {
  const lesson::Session& session = shell.session();
  const app::Look& look = column.look();
  std::string command;
  int number = 0;
  lesson::ProseFigures figures(session);
  for (const lesson::Asked& asked : session.questions()) {
    const std::string prompt = plain_now(asked.prompt, figures);
    const lesson::Outcome* outcome = session.outcome_of(asked);
    const float height = look.px(32), middle = column.y() + height / 2;
    const std::string id = "line " + std::to_string(number++);
    app::rule(column.list(), column.x(), column.y(), column.width(), look->line);
    const app::Touch touch = app::touch_area(id.c_str(), {column.x(), column.y(), column.width(), height}, prompt);
    if (touch.hovered)
      column.list()->AddRectFilled({column.x() - 6, column.y() + 1},
                                   {column.x() + column.width() + 6, column.y() + height - 1}, look->raised, 6);
    if (touch.clicked) command = "review:" + asked.question->id;
    const Standing standing = lesson::standing_of(outcome);
    const bool right = standing == Standing::kRight, wrong = standing == Standing::kWrong;
    const ImVec2 mark{column.x() + 6, middle};
    if (right) app::tick(column.list(), mark, 5, look->optimum, 2);
    else if (wrong) app::cross(column.list(), mark, 4, look->wrong, 2);
    else column.list()->AddLine({mark.x - 4, mark.y}, {mark.x + 4, mark.y}, look->muted, 2);
    const std::string line =
        (marked.empty() ? std::string() : std::to_string(number) + ". ") + std::string(lesson::short_prompt(prompt));
    const std::string stands =
        marked.empty() ? std::string(lesson::standing_text(outcome)) : mark_words(marked[number - 1]);
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

/// The card at an exercise's end.
std::string draw_mark(Shell& shell, Column& column, const lesson::Sitting& sitting) {
  const lesson::Session& session = shell.session();
  draw_kicker(column, lesson::kYourMarkWord, {}, Standing::kOpen);
  column.words(lesson::plain_number(sitting.mark(session)) + " of " + std::to_string(sitting.of()), Face::kSemiBold,
               24);
  if (const std::string best = shell.best_says(); !best.empty())
    column.words(best, Face::kRegular, 13, column.look()->muted);
  for (const std::string& says : sitting.rules_followed(session)) column.gap(4), column.words(says, Face::kRegular, 14);
  column.gap(8);
  std::string command = draw_lines(shell, column, sitting.marked(session));
  const std::array row{RowButton{"hand_in", lesson::kHandInWord}, RowButton{"to_lesson", lesson::kToLessonWord},
                       RowButton{"another", lesson::kAnotherInstanceWord, ButtonKind::kPrimary}};
  const int clicked = draw_row(column, {}, 0, row);
  return clicked < 0 ? command : row[clicked].id;
}

/// The card at the lesson's end: each prediction leads back to its reason. The caller does what was clicked, after
/// drawing the card.
std::string draw_summary(Shell& shell, Column& column) {
  const lesson::Session& session = shell.session();
  const app::Look& look = column.look();
  draw_kicker(column, lesson::kSummaryWord, {}, Standing::kOpen);
  column.words(session.score(), Face::kRegular, 16);
  column.gap(8);
  std::string command = draw_lines(shell, column, {});
  // While questions wait, the main button leads to them, and not to the next lesson.
  const std::vector<Waiting> waiting = waiting_in(session);
  if (waiting.size() > 1) {
    column.words(lesson::kWaitingWord, Face::kRegular, 14);
    column.gap(6);
    std::vector<std::string> titles;
    for (std::size_t i = 1; i < waiting.size(); ++i) titles.push_back(waiting[i].title);
    if (const auto clicked = static_cast<std::size_t>(column.buttons("waiting", titles)); clicked < titles.size())
      command = waiting[clicked + 1].command;
    column.gap(10);
  }
  const auto grade = session.grade();
  const std::string task =
      session.tasks_done() ? "✓ " + std::string(lesson::kTaskWord) : std::string(lesson::kToTaskWord);
  std::vector<RowButton> row{{"close_summary", lesson::kCloseWord, ButtonKind::kQuiet},
                             {"predict_again", lesson::kPredictAgainWord, ButtonKind::kQuiet}};
  if (session.can_practise()) row.push_back({"practise", lesson::kPractiseWord, ButtonKind::kQuiet});
  const std::size_t back = row.size();
  if (grade) row.push_back({"task", task});
  const auto next = waiting.empty() ? ButtonKind::kPrimary : ButtonKind::kOutlined;
  if (shell.beside(1)) row.push_back({"next", lesson::kNextLessonWord, next});
  const std::string go_on = waiting.empty() ? "" : std::string(lesson::kGoOnWord) + ' ' + waiting.front().title;
  if (!waiting.empty()) row.push_back({waiting.front().command.c_str(), go_on, ButtonKind::kPrimary});
  // What leads on stands apart where a row has no room for all of them.
  const std::span<const RowButton> all = row;
  const std::size_t apart = column.width() < look.px(420) || !waiting.empty() ? back : 0;
  if (apart > 0) {
    if (const int clicked = draw_row(column, {}, 0, all.first(apart)); clicked >= 0) command = all[clicked].id;
    column.gap(8);
  }
  const int clicked = draw_row(column, {}, 0, all.subspan(apart));
  return clicked < 0 ? command : all[apart + clicked].id;
}

/// Does what the summary offers beyond the app's commands.
void lead_on(Shell& shell, const std::string& command) {
  constexpr std::string_view kAsk = "ask:", kSituation = "situation:";
  if (command.starts_with(kAsk))
    shell.tell(shell.session().choose(0, command.substr(kAsk.size()))), shell.app().command("first");
  else if (command.starts_with(kSituation))
    shell.tell(shell.session().show_situation(command.substr(kSituation.size())));
  else if (command == "hand_in") shell.hand_in();
  else if (command == "another") shell.open_exercise(shell.app().sitting()->exercise().id, std::nullopt);
  else if (command == "to_lesson") shell.open_at_place(std::string(shell.app().sitting()->exercise().lesson));
  else if (command == "next") shell.open_at_place(*shell.beside(1));
  else if (command == "task") shell.tab = Shell::Tab::kLesson, shell.text_shown = shell.task_wanted = true;
  else if (!command.empty()) shell.app().command(command);
}

}  // namespace

void draw_question_card(Shell& shell, const app::Rect& stage) {
  const lesson::Session& session = shell.session();
  const lesson::Asked* asked = session.asked();
  const lesson::Outcome *deciding = session.deciding(), *outcome = session.outcome();
  const float before = shell.foot;
  shell.foot = 0;
  const lesson::Sitting* const sitting = shell.app().sitting();
  const bool over = sitting != nullptr ? sitting->finished(session) : session.at_summary();
  if (asked == nullptr && deciding == nullptr && outcome == nullptr && !over) {
    shell.measured_anew = shell.measured_anew || before != 0;
    return;
  }
  const app::Look& look = shell.app().look();
  const float width = std::floor(std::min(stage.width - 2 * kBeside, look.px(608)));
  const float height = std::clamp(before - kBelow, 1.0f, stage.height * 0.66f);
  const app::Rect card{std::floor(stage.x + (stage.width - width) / 2), stage.y + stage.height - height - kBelow, width,
                       height};
  std::string command;
  {
    const app::Pane pane("##question", card, app::Pane::Kind::kOver);
    pane.list()->AddRectFilled({card.x, card.y}, {card.x + width, card.y + height}, look->panel, 8);
    pane.list()->AddRect({card.x, card.y}, {card.x + width, card.y + height}, look->line, 8, 0, 1);
    // On a low window the card is not as high as what it says: then it scrolls, by the wheel and with the focus.
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) && io.MouseWheel != 0)
      ImGui::SetScrollY(std::clamp(ImGui::GetScrollY() - kWheel * io.MouseWheel, 0.0f, ImGui::GetScrollMaxY()));
    const float top = card.y + 16 - ImGui::GetScrollY();
    Column column(look, card.x + kPad, top, width - 2 * kPad);
    if (asked != nullptr) draw_question(shell, column, *asked);
    else if (deciding != nullptr) draw_deciding(column, session, *deciding);
    else if (outcome != nullptr) draw_outcome(shell, column, *outcome);
    else command = sitting != nullptr ? draw_mark(shell, column, *sitting) : draw_summary(shell, column);
    shell.foot = std::ceil(column.y() - top + 32) + kBelow;
    if (shell.foot != before) ImGui::SetScrollY(0);  // it says something else
    ImGui::SetCursorScreenPos({column.x(), column.y() + 15});
    ImGui::Dummy({1, 1});
    app::fade_foot(pane.list(), {card.x + 1, card.y, width - 2, height - 1}, look->panel);
  }
  shell.measured_anew = shell.measured_anew || shell.foot != before;
  lead_on(shell, command);
}

}  // namespace snug::desktop
