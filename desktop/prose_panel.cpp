#include "desktop/prose_panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/cover.hpp"
#include "app/marks.hpp"
#include "desktop/lower_panel.hpp"
#include "desktop/prose.hpp"
#include "lesson/playground.hpp"
#include "lesson/say.hpp"
#include "lesson/situations.hpp"
#include "lesson/speaking.hpp"
#include "lesson/subjects.hpp"

namespace snug::desktop {
namespace {

using app::Face;

constexpr double kReads = 6;  // seconds for which a student counts as reading after scrolling the prose

void draw_tabs(Shell& shell, const app::Look& look, ImDrawList* list, const app::Rect& rect) {
  float x = rect.x + kMargin;
  using Tab = Shell::Tab;
  if (!shell.session().stage().subject().file() && shell.tab == Tab::kFile) shell.tab = Tab::kLesson;
  if (shell.sheet() == nullptr && shell.tab == Tab::kSheet) shell.tab = Tab::kLesson;
  if (!shell.narrow && shell.tab == Tab::kSide) shell.tab = Tab::kLesson;
  struct Word {
    Tab tab;
    const char* id;
    std::string_view words;
  };
  std::vector<Word> all{{Tab::kLesson, "tab lesson", "Lesson"}};
  if (shell.app().sitting() == nullptr || shell.app().sitting()->adds())
    all.push_back({Tab::kPoints, "tab points", shell.session().stage().subject().tools().word});
  if (shell.session().stage().subject().file()) all.push_back({Tab::kFile, "tab file", lesson::kFileWord});
  if (shell.sheet() != nullptr) all.push_back({Tab::kSheet, "tab sheet", lesson::kHandInWord});
  if (shell.narrow) all.push_back({Tab::kSide, "tab side", "Numbers"});
  constexpr float kSize = 14, kApart = 28, kLeastApart = 16;
  const auto width_of = [&](const Word& word, float size) {
    return app::measure(look, Face::kSemiBold, size, word.words).x;
  };
  float wanted = 0;
  for (const Word& word : all) wanted += width_of(word, kSize);
  const float gaps = static_cast<float>(all.size()) - 1, room = rect.width - 2 * kMargin;
  const float apart = wanted + gaps * kApart <= room ? kApart : kLeastApart;
  const float size =
      kSize * std::min(1.0f, (room - gaps * apart) / wanted);  // large words that have no room are smaller
  for (const Word& word : all) {
    const bool on = shell.tab == word.tab;
    const float width = width_of(word, size);
    if (app::touch_area(word.id, {x - 8, rect.y, width + 16, rect.height}, word.words).clicked) shell.tab = word.tab;
    app::text(list, look, on ? Face::kSemiBold : Face::kRegular, size,
              {x, app::middle_of(rect.y + rect.height / 2, look.px(size))}, on ? look->ink : look->muted, word.words);
    if (on) list->AddRectFilled({x, rect.y + rect.height - 3}, {x + width, rect.y + rect.height - 1}, look->current, 1);
    x += width + apart;
  }
  app::rule(list, rect.x, rect.y + rect.height - 1, rect.width, look->line);
}

void draw_task(Shell& shell, Column& column, std::size_t number) {
  lesson::Session& session = shell.session();
  const lesson::Task& task = session.lesson().tasks[number];
  const bool done = session.was_done(number);
  const app::Look& look = column.look();
  column.begin_card();
  column.heading(lesson::task_heading(number, session.lesson().tasks.size()), look->current_text);
  lesson::ProseFigures figures(session.conversation());
  draw_prompt(column, task.prompt, figures, {.leading = 22, .ground = look->panel});
  column.gap(10);
  const float middle = column.y() + look.px(11);
  if (done) app::tick(column.list(), {column.x() + 6, middle}, 6, look->optimum, 2.25f);
  else app::ring(column.list(), {column.x() + 6, middle}, 5, look->muted, 1.5f);
  Column beside(look, column.x() + 22, column.y(), column.width() - 22);
  beside.words(lesson::task_says(session, number), Face::kRegular, 14,
               done && session.grade(number).done ? look->optimum_text
                                                  : look->muted);  // green where it is solved as it stands
  column.gap(beside.y() - column.y() + 8);
  const bool hint_shown = shell.hint_of == static_cast<int>(number);
  std::vector<std::string> buttons{lesson::start_task_text(session, task)};
  if (!task.hint.empty()) buttons.emplace_back(lesson::kHintWord);
  const int back = session.can_solve_again(number) ? static_cast<int>(buttons.size()) : -1;
  if (back >= 0) buttons.emplace_back(lesson::kBackToSolutionWord);
  const std::string id = "task " + std::to_string(number);
  const int clicked = column.buttons(number == 0 ? "task" : id.c_str(), buttons, hint_shown ? 1 : -1);
  if (clicked == 0) session.stage().start_task(number);
  if (clicked == back && back >= 0) shell.tell(session.solve_again(number));
  else if (clicked == 1) shell.hint_of = hint_shown ? -1 : static_cast<int>(number);
  if (hint_shown) draw_prompt(column, task.hint, figures, {13, 20, Face::kRegular, look->muted, look->panel});
  column.end_card();
}

void draw_tasks(Shell& shell, Column& column) {
  const std::size_t tasks = shell.session().lesson().tasks.size();
  if (tasks == 0 || shell.app().sitting() != nullptr) return;  // what is built has its own card
  if (std::exchange(shell.task_wanted, false)) {
    const float top = ImGui::GetWindowPos().y;
    ImGui::SetScrollFromPosY(column.y() - top, 0.1f);
    shell.read_at = ImGui::GetTime(), shell.measured_anew = true;
  }
  for (std::size_t i = 0; i < tasks; ++i) {
    if (i > 0) column.gap(12);
    draw_task(shell, column, i);
  }
}

/// The way to the playground with what stands on the stage, and back.
void draw_playground(Shell& shell, Column& column) {
  column.gap(12);
  if (const auto back = shell.way_back()) {
    const std::string words = lesson::way_back_text(shell.lessons()[*back].lesson.title);
    if (column.buttons("back from the playground", {words}) == 0) shell.open_at_place(*back);
  } else if (shell.playground()) {
    const std::string words(lesson::playground_text(shell.session()));
    if (column.buttons("playground", {words}) == 0) shell.go_to_playground();
  }
}

/// Follows a link in the prose.
void follow(Shell& shell, const lesson::Link& link) {
  switch (link.kind) {
    case lesson::Link::Kind::kLesson: shell.open_at_place(link.target); break;
    case lesson::Link::Kind::kMesh: shell.use_mesh(link.target); break;
    case lesson::Link::Kind::kAlgorithm: shell.tell(shell.session().player().choose(0, link.target)); break;
    case lesson::Link::Kind::kStep: shell.session().go(std::stoi(link.target)); break;  // of digits, as it was read
    case lesson::Link::Kind::kSituation: shell.tell(shell.session().stage().show_situation(link.target)); break;
    case lesson::Link::Kind::kMark: break;  // lights while it is pointed at, or has the keyboard
  }
}

/// Scrolls to the section about the step or the question, unless the student is reading.
void follow_step(Shell& shell, int now, float top, float bottom, bool reads) {
  if (now != shell.section) {
    shell.section = now;
    const float from = ImGui::GetScrollY(), height = ImGui::GetWindowHeight();
    if (now >= 0 && !reads && (top < from || bottom > from + height))
      shell.scroll_to = std::max(0.0f, top - height / 8);
  }
  if (shell.scroll_to < 0) return;
  shell.measured_anew = true;
  if (ImGui::IsWindowAppearing()) return;  // the prose's length is not known yet
  if (reads) shell.scroll_to = -1;
  const float left = std::min(shell.scroll_to, ImGui::GetScrollMaxY()) - ImGui::GetScrollY();
  const bool there = std::abs(left) < 1 || shell.app().settings().reduced_motion || shell.scroll_to < 0;
  if (shell.scroll_to >= 0) ImGui::SetScrollY(ImGui::GetScrollY() + (there ? left : left * 0.25f));
  if (there) shell.scroll_to = -1;
}

/// The button that brings the situation that a section is about to the stage.
void draw_show(Shell& shell, Column& column, const lesson::Section& section, int number) {
  if (section.situation.empty()) return;
  const bool on = section.situation == shell.session().stage().situation();
  const std::string& title = lesson::situation_title(shell.session().lesson(), section.situation);
  const std::string id = "situation of section " + std::to_string(number) + " ";
  column.gap(4);
  if (column.buttons(id.c_str(), {"Show: " + title}, on ? 0 : -1) == 0)
    shell.tell(shell.session().stage().show_situation(section.situation));
}

void draw_lesson(Shell& shell, Column& column) {
  const lesson::Lesson& lesson = shell.session().lesson();
  const std::vector<std::string_view> lit = shell.app().marks_in_hand();
  const int now = lesson::section_at(shell.session()).value_or(-1);
  if (shell.unread) {
    ImGui::SetScrollY(0);
    const bool begins =
        shell.session().player().step() == 0 || shell.session().player().previewing();  // who begins reads from the top
    shell.section = begins ? now : -1, shell.scroll_to = -1, shell.unread = false, shell.measured_anew = true;
  }
  if (const float by = std::exchange(shell.scroll_by, 0.0f); by != 0) {
    ImGui::SetScrollY(std::clamp(ImGui::GetScrollY() + by, 0.0f, ImGui::GetScrollMaxY()));
    shell.read_at = ImGui::GetTime(), shell.measured_anew = true;
  }
  shell.scrolled = ImGui::GetScrollY();
  const float beginning = column.y() + ImGui::GetScrollY();
  float top = 0, bottom = 0;
  ProseTouch touch;
  lesson::ProseFigures figures(shell.session().conversation());
  for (int i = 0; const lesson::Section& section : lesson.sections) {
    if (i > 0) column.gap(16);
    const float from = column.y();
    column.title(section.title);
    draw_show(shell, column, section, i);
    for (int number = 0; const lesson::Block& block : section.blocks) {
      ImGui::PushID(1000 * i + number++);
      touch.add(draw_block(column, block, figures, lit));
      ImGui::PopID();
      column.gap(10);
    }
    if (i++ != now) continue;
    const float x = column.x() - 16, end = column.y() - 10;
    column.list()->AddRectFilled({x, from + 4}, {x + 3, end}, column.look()->current, 2);
    top = from + ImGui::GetScrollY() - beginning, bottom = end + ImGui::GetScrollY() - beginning;
  }
  const lesson::Link* const meant = touch.hovered != nullptr ? touch.hovered : touch.focused;
  const bool marks = meant != nullptr && meant->kind == lesson::Link::Kind::kMark;
  shell.links.clear();
  shell.figures = std::move(touch.figures);
  for (const PlacedLink& one : touch.links) shell.links.emplace_back(one.link->target, one.rect);
  shell.app().light(marks ? std::string_view(meant->target) : std::string_view(shell.stored_lit));
  const bool pointed = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  if (pointed && ImGui::GetIO().MouseWheel != 0) shell.read_at = ImGui::GetTime();
  const bool reads = pointed || touch.focused != nullptr || ImGui::GetTime() - shell.read_at < kReads;
  follow_step(shell, now, top, bottom, reads);
  column.gap(12);
  draw_tasks(shell, column);
  if (shell.app().sitting() == nullptr) draw_playground(shell, column);
  if (touch.clicked != nullptr) follow(shell, lesson::Link(*touch.clicked));  // another lesson replaces the links
}

}  // namespace

void draw_prose_panel(Shell& shell, const app::Rect& rect) {
  const app::Look& look = shell.app().look();
  const float tabs = look.px(44);
  {
    const app::Pane pane("##column", {rect.x, rect.y, rect.width, tabs});
    pane.list()->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, look->panel);
    draw_tabs(shell, look, pane.list(), {rect.x, rect.y, rect.width, tabs});
  }
  const app::Rect upper{rect.x, rect.y + tabs, rect.width - 1, rect.height - tabs};
  if (shell.tab == Shell::Tab::kSide) {  // which stands below
    shell.links.clear();
    shell.app().light(shell.stored_lit);
  } else {
    constexpr std::array<const char*, 4> kPanes{"##prose", "##points", "##file", "##sheet"};
    const app::Pane pane(kPanes[static_cast<std::size_t>(shell.tab)], upper, app::Pane::Kind::kScrolls);
    pane.list()->AddRectFilled({upper.x, upper.y}, {upper.x + upper.width, upper.y + upper.height}, look->panel);
    Column column(look, upper.x + kMargin, upper.y + 20 - ImGui::GetScrollY(), upper.width - 2 * kMargin);
    if (shell.tab != Shell::Tab::kLesson) shell.app().light(shell.stored_lit);
    switch (shell.tab) {
      case Shell::Tab::kLesson: draw_lesson(shell, column); break;
      case Shell::Tab::kPoints: draw_tools(shell, column); break;
      case Shell::Tab::kFile: draw_file(shell, column, upper.height - kMargin); break;
      case Shell::Tab::kSheet: draw_sheet(shell, column); break;
      case Shell::Tab::kSide: break;
    }
    ImGui::SetCursorScreenPos({column.x(), column.y() + 8});
    ImGui::Dummy({1, 1});
    app::fade_foot(pane.list(), upper, look->panel);
  }
}

}  // namespace snug::desktop
