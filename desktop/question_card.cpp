#include "desktop/question_card.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "app/marks.hpp"
#include "desktop/card_parts.hpp"
#include "desktop/exercise_card.hpp"
#include "desktop/prose.hpp"
#include "lesson/order_told.hpp"
#include "lesson/say.hpp"
#include "lesson/situations.hpp"
#include "lesson/subjects.hpp"

namespace snug::desktop {
namespace {

using app::ButtonKind;
using app::Face;
using lesson::AnswerState;

constexpr Writing kPromptWriting{16, 23};
constexpr float kPad = 20, kBeside = 24, kBelow = 12, kWheel = 48;
constexpr float kLow = 640;  // of a stage: what is lower leaves a card no line for its heading
constexpr float kLeastText = 150, kAnswerAndSkip = 150;  // what a row's text, and both buttons, should have at least

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
  ImGui::SetKeyboardFocusHere(-1);  // what is typed next is an answer as well: another try, or the next decision's
  if (shell.typed[0] == 0) return shell.app().command("commit_answer");  // one that was tapped
  if (shell.session().conversation().pick(std::string_view(shell.typed.data())))
    shell.session().conversation().commit();
  shell.typed = {};
  return true;
}

/// The choices, with marks at those that are chosen but not committed yet, and at the one that was tried.
struct Choices {
  std::vector<std::string> words;
  int chosen = -1;
  std::vector<std::string> room = {};  // the words with the widest of the marks, so that none moves when one is chosen
};

Choices choices_of(const lesson::Session& session, const lesson::Asked& asked) {
  const lesson::Answer *picked = session.conversation().picked(), *tried = session.conversation().tried();
  std::vector<std::string> words = asked.choices, room;
  int chosen = -1;
  if (asked.many || asked.ordered)
    for (const std::string& choice : words) room.push_back((asked.ordered ? "8  " : "✕ ") + choice);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const int choice = static_cast<int>(i);
    const bool is_chosen = picked != nullptr && is_picked(asked, *picked, choice);
    const bool was_tried = !asked.ordered && tried != nullptr && is_picked(asked, *tried, choice);
    if (was_tried && !(asked.many && is_chosen)) words[i] = "✕ " + words[i];
    if (asked.ordered) {
      const int place = picked != nullptr ? place_in_order(*picked, choice) : 0;
      words[i] = (place > 0 ? std::to_string(place) : "·") + "  " + words[i];
      continue;
    }
    if (!is_chosen) continue;
    if (asked.many) words[i] = "✓ " + words[i];
    else chosen = choice;
  }
  return {std::move(words), chosen, std::move(room)};
}

/// The choices, once the right one was asked for: it has a tick, and the one that was given a cross.
void draw_right_choices(Column& column, const lesson::Session& session, const lesson::Asked& asked,
                        const lesson::Outcome& outcome) {
  const app::Look& look = column.look();
  const std::vector<int> right = session.conversation().right_choices();
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

/// The right order, line by line, each with the place that it had in the answer.
void draw_order(Column& column, const lesson::Session& session, const lesson::Asked& asked,
                const lesson::Outcome& outcome) {
  const app::Look& look = column.look();
  const std::string_view what = session.stage().conduct().decides ? lesson::kDecisionWord : lesson::kPredictionWord;
  const bool answered = std::holds_alternative<lesson::ChoicesInOrder>(outcome.given);
  const float own = answered ? app::measure(look, Face::kSemiBold, 13, what).x + 8 : 0;
  if (answered)
    app::text(column.list(), look, Face::kSemiBold, 13,
              {column.x() + column.width() - own + 8, column.y() + look.px(3)}, look->muted, what);
  Column heading(look, column.x(), column.y(), column.width() - own);
  heading.words(outcome.says.substr(0, outcome.says.find(':') + 1), Face::kRegular, 15);
  column.gap(heading.y() - column.y() + 2);
  const float number = look.px(24), mark = look.px(18);
  for (int line = 1;
       const auto& [words, place, right] : order_told(asked, outcome, session.conversation().right_choices())) {
    const float top = column.y();
    column.list()->AddLine({column.x(), top}, {column.x() + column.width(), top}, look->line);
    const float middle = top + look.px(15);
    app::text(column.list(), look, Face::kSemiBold, 14, {column.x(), app::middle_of(middle, look.px(14))}, look->muted,
              std::to_string(line++));
    Column text(look, column.x() + number, top + look.px(3), column.width() - number - own - 12);
    text.words(words, Face::kRegular, 14);
    if (place > 0) {
      const float x = column.x() + column.width() - own + 8;
      if (right) app::tick(column.list(), {x + 6, middle}, 5, look->optimum, 2);
      else app::cross(column.list(), {x + 6, middle}, 4, look->wrong, 2);
      app::text(column.list(), look, Face::kSemiBold, 14, {x + mark, app::middle_of(middle, look.px(14))},
                right ? look->optimum_text : look->wrong_text, std::to_string(place));
    }
    column.gap(std::max(text.y() - top, look.px(30)));
  }
  column.list()->AddLine({column.x(), column.y()}, {column.x() + column.width(), column.y()}, look->line);
  column.gap(8);
}

/// low: whether which question it is stands before how it is answered, and not in a line above.
void draw_question(Shell& shell, Column& column, const lesson::Asked& asked, bool low) {
  lesson::Session& session = shell.session();
  const app::Look& look = column.look();
  lesson::ProseFigures figures(session.conversation());
  const lesson::Sitting* const sitting = shell.app().sitting();
  const auto [words, place] = sitting != nullptr
                                  ? decision_place(*sitting, session)
                                  : std::pair(std::string(lesson::kPredictionWord),
                                              lesson::place_text(asked, session.conversation().questions()));
  low = low && sitting == nullptr;
  if (!shell.demo && !low) draw_kicker(column, words, place, AnswerState::kOpen);
  if (sitting != nullptr) draw_before(column, *sitting, session);
  draw_prompt(column, asked.prompt, figures, kPromptWriting);
  if (sitting != nullptr) draw_hints(column, *sitting, session);
  column.gap(10);
  const bool ready = session.conversation().picked() != nullptr && answers(asked, *session.conversation().picked());
  const std::string hint = sitting != nullptr ? sitting->hint_words(session) : std::string();
  std::vector<RowButton> row;
  // A choice is given by choosing it.
  if (sitting == nullptr || asked.on_stage || asked.many || asked.ordered || asked.number)
    row.push_back({"commit_answer", lesson::kAnswerWord, ButtonKind::kPrimary, ready});
  if (sitting == nullptr) row.push_back({"skip_question", lesson::kSkipWord, ButtonKind::kQuiet});
  if (sitting != nullptr && !session.stage().conduct().told && !session.log().given().empty())
    row.push_back({"take_back", lesson::kTakeBackWord, ButtonKind::kQuiet});
  if (!hint.empty()) row.push_back({"hint", hint, ButtonKind::kQuiet});
  Choices choices = choices_of(session, asked);
  if (shell.demo)  // called as its vote calls them
    for (std::size_t i = 0; i < choices.words.size(); ++i)
      for (auto* words : {&choices.words, &choices.room})
        if (i < words->size()) (*words)[i].insert(0, {static_cast<char>('A' + i % 26), ' ', ' '});
  const int chosen = column.buttons("choice", choices.words, choices.chosen, {}, choices.room);
  if (shell.demo) {  // the class answers by its hands, and a press reveals
    if (chosen >= 0) shell.app().pick_choice(chosen);
    return;
  }
  const float beside = column.row_taken();
  const std::string_view field = lesson::field_word(asked);
  if (!field.empty() && draw_answer_field(shell, column, field)) return;
  std::string says = session.conversation().answer_says().empty() ? lesson::how_to_answer(asked)
                                                                  : session.conversation().answer_says();
  if (low && !place.empty() && session.conversation().answer_says().empty()) says = place + " · " + says;
  const bool wrong = session.conversation().tried() != nullptr && session.conversation().picked() == nullptr;
  if (shell.presenting && session.conversation().answer_says().empty())
    (says += ' ') += lesson::kSkipHint;  // a clicker has no other
  const app::Color color = session.conversation().answer_says().empty() ? look->muted
                           : wrong                                      ? look->wrong_text
                                                                        : look->current_text;
  // What is said of the choices and gives the answer stands after the last of them, where a row has room for it: the
  // figure needs the height.
  const bool flows = beside > 0 && beside + look.px(kLeastText + kAnswerAndSkip) < column.width();
  if (flows) column.gap(-look.px(34) - 8);
  Column last(look, column.x() + (flows ? beside : 0), column.y(), column.width() - (flows ? beside : 0));
  const int clicked = draw_row(last, says, color, row);
  column.gap(last.y() - column.y());
  // In an exercise the second click of a double one would decide what is asked next.
  const bool double_click =
      ImGui::IsMouseReleased(ImGuiMouseButton_Left) && ImGui::GetIO().MouseClickedLastCount[0] > 1;
  if (chosen >= 0 && sitting != nullptr && !asked.many && !asked.ordered && double_click) return;
  if (chosen >= 0) shell.app().pick_choice(chosen);
  else if (clicked >= 0) shell.app().command(row[clicked].id);
}

void draw_said(Column& column, const lesson::Session& session, const lesson::Outcome& outcome) {
  if (outcome.skipped) return;
  const std::string_view what = session.stage().conduct().decides ? lesson::kDecisionWord : lesson::kPredictionWord;
  column.words(std::string(what) + ": " + outcome.predicted, Face::kSemiBold, 15);
  column.gap(4);
}

/// Where it stands among the questions, or the decisions.
std::string place_of(Shell& shell, const lesson::Asked* asked) {
  const lesson::Sitting* const sitting = shell.app().sitting();
  if (sitting != nullptr) return decision_place(*sitting, shell.session()).first;
  return asked != nullptr ? lesson::place_text(*asked, shell.session().conversation().questions()) : std::string();
}

/// The card while the steps up to the outcome are played: it tells nothing yet.
void draw_deciding(Shell& shell, Column& column, const lesson::Outcome& outcome) {
  const lesson::Session& session = shell.session();
  const lesson::Asked* asked = session.conversation().question_of(outcome);
  if (!shell.demo) draw_kicker(column, lesson::kPredictionWord, place_of(shell, asked), AnswerState::kOpen);
  lesson::ProseFigures figures(session.conversation());
  if (asked != nullptr) draw_prompt(column, asked->prompt, figures, kPromptWriting), column.gap(6);
  draw_said(column, session, outcome);
  column.words(lesson::kWatching, Face::kRegular, 13, column.look()->muted);
}

/// The card with the outcome, until it is dismissed.
void draw_outcome(Shell& shell, Column& column, const lesson::Outcome& outcome) {
  const lesson::Session& session = shell.session();
  const app::Look& look = column.look();
  const lesson::Asked* asked = session.conversation().question_of(outcome);
  const lesson::Sitting* const sitting = shell.app().sitting();
  if (!shell.demo)
    draw_kicker(column, lesson::verdict_text(outcome), place_of(shell, asked), lesson::answer_state_of(&outcome));
  lesson::ProseFigures figures(session.conversation());
  if (asked != nullptr)
    draw_prompt(column, asked->prompt, figures, {14, 21, Face::kRegular, look->muted}), column.gap(6);
  const bool as_list = asked != nullptr && asked->ordered && !session.conversation().right_choices().empty();
  if (as_list) draw_order(column, session, *asked, outcome);
  else draw_said(column, session, outcome);
  if (session.conversation().answer_shown() && asked != nullptr && !asked->choices.empty() && !asked->ordered) {
    draw_right_choices(column, session, *asked, outcome);
  } else if (session.conversation().answer_shown() && !as_list) {
    app::tick(column.list(), {column.x() + 6, column.y() + look.px(11)}, 6, look->optimum, 2.25f);
    Column beside(look, column.x() + 22, column.y(), column.width() - 22);
    beside.words(outcome.happened, Face::kSemiBold, 15, look->optimum_text);
    column.gap(beside.y() - column.y() + 4);
  }
  if (!as_list) column.words(outcome.says);
  if (!outcome.because.empty()) column.gap(4), draw_prompt(column, outcome.because, figures, {15, 22});
  if (sitting != nullptr) draw_rule(column, *sitting, session);
  if (shell.demo) return;  // the next press goes on
  column.gap(12);
  std::vector<RowButton> row;
  std::vector<std::string_view> commands;
  const auto offer = [&](const RowButton& one, std::string_view command) {
    row.push_back(one), commands.push_back(command);
  };
  if (sitting != nullptr && sitting->looks_at(session) == lesson::Sitting::Looked::kOwn) {
    const bool last = sitting->at(session) + 1 == session.conversation().questions().size();
    offer({"mark", lesson::kYourMarkWord, last ? ButtonKind::kPrimary : ButtonKind::kQuiet}, "continue");
    offer({"other_run", lesson::kRightRunWord}, "other_run");
    if (!last) offer({"next", lesson::kNextDecisionWord, ButtonKind::kPrimary}, "step");
  } else {
    if (session.conversation().can_show_answer() && !session.conversation().answer_shown() && !as_list)
      offer({"show", lesson::kShowMeWord}, "show_answer");
    if (session.conversation().can_watch_outcome()) offer({"watch", lesson::kWatchWord}, "watch_outcome");
    offer({"continue", lesson::kContinueWord, ButtonKind::kPrimary}, "continue");
  }
  if (const int clicked = draw_row(column, {}, 0, row); clicked >= 0) shell.app().command(commands[clicked]);
}

/// Questions of the lesson that are still open: under what title, and the command that leads to them.
struct Waiting {
  std::string title, command;
};

std::vector<Waiting> waiting_in(const lesson::Session& session) {
  std::vector<Waiting> all;
  for (const lesson::Method* method : session.conversation().waiting())
    all.push_back({lesson::title_in(session.lesson(), *method), "ask:" + lesson::name_in(session.lesson(), *method)});
  for (const std::string& name : session.log().situations_waiting(session.stage().situation()))
    all.push_back({lesson::situation_title(session.lesson(), name), "situation:" + name});
  return all;
}

/// The card at the lesson's end: each prediction leads back to its reason. The caller does what was clicked, after
/// drawing the card.
std::string draw_summary(Shell& shell, Column& column) {
  const lesson::Session& session = shell.session();
  const app::Look& look = column.look();
  draw_kicker(column, lesson::kSummaryWord, {}, AnswerState::kOpen);
  column.words(session.conversation().score(), Face::kRegular, 16);
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
  if (session.conversation().can_practise()) row.push_back({"practise", lesson::kPractiseWord, ButtonKind::kQuiet});
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
    shell.tell(shell.session().player().choose(0, command.substr(kAsk.size()))), shell.app().command("first");
  else if (command.starts_with(kSituation))
    shell.tell(shell.session().stage().show_situation(command.substr(kSituation.size())));
  else if (command == "hand_in") shell.hand_in();
  else if (command == "another" || command == "harder" || command == "other_terms") shell.next_instance(command);
  else if (command == "to_lesson") shell.open_at_place(std::string(shell.app().sitting()->exercise().lesson));
  else if (command == "next") shell.open_at_place(*shell.beside(1));
  else if (command == "task") shell.tab = Shell::Tab::kLesson, shell.text_shown = shell.task_wanted = true;
  else if (!command.empty()) shell.app().command(command);
}

/// Whether the card stands beside the stage, of which there is too little to cover any.
bool stands_beside(const Shell& shell) { return shell.presenting || shell.asks_beside; }

/// Where the card stands that was so high in the last frame. most: the share of the stage that it covers at most.
app::Rect card_in(const Shell& shell, const app::Rect& place, float measured, float most) {
  if (stands_beside(shell)) return place;
  const float width = std::floor(std::min(place.width - 2 * kBeside, shell.app().look().px(608)));
  const float height = std::clamp(measured, 1.0f, place.height * most);
  return {std::floor(place.x + (place.width - width) / 2), place.y + place.height - height - kBelow, width, height};
}

}  // namespace

float covered_by_question(const Shell& shell) {
  return stands_beside(shell) || shell.question_height == 0 ? 0 : shell.question_height + kBelow;
}

void draw_question_card(Shell& shell, const app::Rect& place) {
  const lesson::Session& session = shell.session();
  const lesson::Asked* asked = session.conversation().asked();
  const lesson::Outcome *deciding = session.conversation().deciding(), *outcome = session.conversation().outcome();
  const float before = std::exchange(shell.question_height, 0);
  const lesson::Sitting* const sitting = shell.app().sitting();
  const bool over =
      sitting != nullptr ? sitting->finished(session) : session.conversation().at_summary() && !shell.demo;
  const bool builds = sitting != nullptr && sitting->exercise().build.has_value();
  if (asked == nullptr && deciding == nullptr && outcome == nullptr && !over && !builds) {
    shell.measured_anew = shell.measured_anew || before != 0;
    return;
  }
  const app::Look& look = shell.app().look();
  // An order of lines, with its hints, needs the room more than the stage does.
  const lesson::Asked* const about = asked != nullptr     ? asked
                                     : outcome != nullptr ? session.conversation().question_of(*outcome)
                                                          : nullptr;
  const app::Rect card = card_in(shell, place, before, about != nullptr && about->ordered ? 0.9f : 0.66f);
  std::string command;
  {
    const app::Pane pane("##question", card, app::Pane::Kind::kOver);
    const float round = stands_beside(shell) ? 0.0f : 8.0f;
    pane.list()->AddRectFilled({card.x, card.y}, {card.x + card.width, card.y + card.height}, look->panel, round);
    pane.list()->AddRect({card.x, card.y}, {card.x + card.width, card.y + card.height}, look->line, round, 0, 1);
    // On a low window the card is not as high as what it says: then it scrolls, by the wheel and with the focus.
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) && io.MouseWheel != 0)
      ImGui::SetScrollY(std::clamp(ImGui::GetScrollY() - kWheel * io.MouseWheel, 0.0f, ImGui::GetScrollMaxY()));
    const bool low = !stands_beside(shell) && place.height < look.px(kLow);
    const float pad = low ? 12 : 16, top = card.y + pad - ImGui::GetScrollY();
    Column column(look, card.x + kPad, top, card.width - 2 * kPad);
    if (asked != nullptr) draw_question(shell, column, *asked, low);
    else if (deciding != nullptr) draw_deciding(shell, column, *deciding);
    else if (outcome != nullptr) draw_outcome(shell, column, *outcome);
    else if (sitting != nullptr && sitting->looks_at(session) == lesson::Sitting::Looked::kRight)
      command = draw_right_run(column, *sitting, session);
    else if (over && sitting != nullptr) command = draw_mark(shell, column, *sitting);
    else if (builds) command = draw_build(shell, column, *sitting);
    else command = draw_summary(shell, column);
    shell.question_height = std::ceil(column.y() - top + 2 * pad);
    if (shell.question_height != before) ImGui::SetScrollY(0);  // it says something else
    ImGui::SetCursorScreenPos({column.x(), column.y() + pad - 1});
    ImGui::Dummy({1, 1});
    app::fade_foot(pane.list(), {card.x + 1, card.y, card.width - 2, card.height - 1}, look->panel);
  }
  shell.measured_anew = shell.measured_anew || shell.question_height != before;
  lead_on(shell, command);
}

}  // namespace snug::desktop
