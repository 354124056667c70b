#include "desktop/prose_panel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/marks.hpp"
#include "app/subjects/cost/costs.hpp"
#include "desktop/column.hpp"
#include "desktop/prose.hpp"
#include "lesson/say.hpp"
#include "lesson/speaking.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/cost/cost.hpp"

namespace snug::desktop {
namespace {

using app::Face;

constexpr float kMargin = 28;
constexpr double kReads = 6;  // seconds: who has scrolled the prose reads it for so long

void draw_tabs(Shell& shell, const app::Look& look, ImDrawList* list, const app::Rect& rect) {
  float x = rect.x + kMargin;
  for (const bool points : {false, true}) {
    const std::string_view words = points ? shell.session().subject().tools_word() : "Lesson";
    const bool on = shell.points_tab == points;
    const float width = app::measure(look, Face::kSemiBold, 14, words).x;
    if (app::touch_area(points ? "tab points" : "tab lesson", {x - 8, rect.y, width + 16, rect.height}).clicked)
      shell.points_tab = points;
    app::text(list, look, on ? Face::kSemiBold : Face::kRegular, 14,
              {x, app::middle_of(rect.y + rect.height / 2, look.px(14))}, on ? look->ink : look->muted, words);
    if (on) list->AddRectFilled({x, rect.y + rect.height - 3}, {x + width, rect.y + rect.height - 1}, look->current, 1);
    x += width + 28;
  }
  app::rule(list, rect.x, rect.y + rect.height - 1, rect.width, look->line);
}

void draw_task(Shell& shell, Column& column) {
  const auto& task = shell.session().lesson().task;
  const auto grade = shell.session().grade();
  if (!task || !grade) return;
  const app::Look& look = column.look();
  column.begin_card();
  column.heading(lesson::kTaskWord, look->current_text);
  column.words(task->prompt);
  column.gap(10);
  const float middle = column.y() + look.px(11);
  if (grade->done) app::tick(column.list(), {column.x() + 6, middle}, 6, look->optimum, 2.25f);
  else app::ring(column.list(), {column.x() + 6, middle}, 5, look->muted, 1.5f);
  Column beside(look, column.x() + 22, column.y(), column.width() - 22);
  beside.words(grade->says, Face::kRegular, 14, grade->done ? look->optimum_text : look->muted);
  column.gap(beside.y() - column.y() + 8);
  std::vector<std::string> buttons{lesson::start_task_text(shell.session())};
  if (!task->hint.empty()) buttons.emplace_back(lesson::kHintWord);
  const int clicked = column.buttons("task", buttons, shell.hint_shown ? 1 : -1);
  if (clicked == 0) shell.session().start_task();
  if (clicked == 1) shell.hint_shown = !shell.hint_shown;
  if (shell.hint_shown) column.words(task->hint, Face::kRegular, 13, look->muted);
  column.end_card();
}

/// Does what a link of the prose says.
void follow(Shell& shell, const lesson::Link& link) {
  switch (link.kind) {
    case lesson::Link::Kind::kLesson: shell.tell(shell.open(link.target)); break;
    case lesson::Link::Kind::kMesh: shell.use_mesh(link.target); break;
    case lesson::Link::Kind::kAlgorithm: shell.tell(shell.session().choose(0, link.target)); break;
    case lesson::Link::Kind::kStep: shell.session().go(std::stoi(link.target)); break;  // of digits, as it was read
    case lesson::Link::Kind::kMark: break;                                              // lights while it is pointed at
  }
}

/// The section that the step, or the question, is about is brought into view, but not under the eyes of one who reads.
void follow_step(Shell& shell, int now, float top, float bottom, bool reads) {
  if (now != shell.section) {
    shell.section = now;
    const float from = ImGui::GetScrollY(), height = ImGui::GetWindowHeight();
    if (now >= 0 && !reads && (top < from || bottom > from + height))
      shell.scroll_to = std::max(0.0f, top - height / 8);
  }
  if (shell.scroll_to < 0) return;
  shell.measured_anew = true;
  if (ImGui::IsWindowAppearing()) return;  // how long the prose is has not been found yet
  if (reads) shell.scroll_to = -1;
  const float left = std::min(shell.scroll_to, ImGui::GetScrollMaxY()) - ImGui::GetScrollY();
  const bool there = std::abs(left) < 1 || shell.app().settings().reduced_motion || shell.scroll_to < 0;
  if (shell.scroll_to >= 0) ImGui::SetScrollY(ImGui::GetScrollY() + (there ? left : left * 0.25f));
  if (there) shell.scroll_to = -1;
}

void draw_lesson(Shell& shell, Column& column) {
  const lesson::Lesson& lesson = shell.session().lesson();
  const std::vector<std::string_view> lit = shell.app().marks_in_hand();
  const int now = lesson::section_at(shell.session()).value_or(-1);
  if (shell.unread) {
    ImGui::SetScrollY(0);
    shell.section = -1, shell.scroll_to = -1, shell.unread = false, shell.measured_anew = true;
  }
  shell.scrolled = ImGui::GetScrollY();
  const float beginning = column.y() + ImGui::GetScrollY();
  float top = 0, bottom = 0;
  ProseTouch touch;
  for (int i = 0; const lesson::Section& section : lesson.sections) {
    if (i > 0) column.gap(16);
    const float from = column.y();
    column.title(section.title);
    for (const lesson::Paragraph& paragraph : section.paragraphs) {
      ImGui::PushID(static_cast<int>(column.y() - from) + 10000 * i);
      const ProseTouch here = draw_prose(column, paragraph, lit);
      ImGui::PopID();
      if (here.hovered != nullptr) touch.hovered = here.hovered;
      if (here.clicked != nullptr) touch.clicked = here.clicked;
      touch.links.insert(touch.links.end(), here.links.begin(), here.links.end());
      column.gap(10);
    }
    if (i++ != now) continue;
    const float x = column.x() - 16, end = column.y() - 10;
    column.list()->AddRectFilled({x, from + 4}, {x + 3, end}, column.look()->current, 2);
    top = from + ImGui::GetScrollY() - beginning, bottom = end + ImGui::GetScrollY() - beginning;
  }
  const bool marks = touch.hovered != nullptr && touch.hovered->kind == lesson::Link::Kind::kMark;
  shell.links.clear();
  for (const PlacedLink& one : touch.links) shell.links.emplace_back(one.link->target, one.rect);
  shell.app().light(marks ? std::string_view(touch.hovered->target) : std::string_view());
  const bool pointed = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  if (pointed && ImGui::GetIO().MouseWheel != 0) shell.read_at = ImGui::GetTime();
  follow_step(shell, now, top, bottom, pointed || ImGui::GetTime() - shell.read_at < kReads);
  column.gap(12);
  draw_task(shell, column);
  if (touch.clicked != nullptr) follow(shell, lesson::Link(*touch.clicked));  // another lesson has other links
}

/// What came of one of the chart's questions, which are decided all at once.
void draw_outcome(Column& column, const lesson::Outcome& outcome) {
  const app::Look& look = column.look();
  column.begin_card();
  const bool open = outcome.skipped || outcome.pending;  // neither right nor wrong
  const app::Color color = outcome.right ? look->optimum_text : open ? look->muted : look->wrong_text;
  const float middle = column.y() + look.px(10);
  if (outcome.right) app::tick(column.list(), {column.x() + 6, middle}, 6, look->optimum, 2.25f);
  else if (!open) app::cross(column.list(), {column.x() + 6, middle}, 5, look->wrong, 2.25f);
  Column beside(look, column.x() + (open ? 0 : 22), column.y(), column.width());
  beside.heading(lesson::verdict_text(outcome), color);
  column.gap(look.px(24));
  if (!open) column.words(std::string(lesson::kPredictionWord) + ": " + outcome.predicted, Face::kSemiBold, 14);
  column.words(outcome.says);
  if (!outcome.because.empty() && !outcome.pending) {
    column.gap(6);
    column.words(outcome.because, Face::kRegular, 14, look->muted);
  }
  column.end_card();
}

/// Which of the charts is shown.
void draw_chart_choice(Shell& shell, Column& column, const app::Costs& costs) {
  std::vector<std::string> words;
  std::vector<bool> enabled;
  for (int i = 0; i < app::kCostViews; ++i) {
    words.emplace_back(app::kCostViewTitles[i]);
    enabled.push_back(costs.may_see(shell.session(), static_cast<app::CostView>(i)));
  }
  const int clicked = column.buttons("chart", words, static_cast<int>(costs.view()), enabled);
  if (clicked >= 0) shell.app().command("show_" + std::string(app::kCostViewNames[clicked]));
  if (enabled.back()) return;
  column.words(app::kPredictFirst, Face::kRegular, 13, column.look()->muted);
  column.gap(8);
}

/// The tools of a lesson with the charts: choose one, measure, stop, save; and how the predictions came out.
void draw_costs(Shell& shell, Column& column) {
  const app::Costs* const measured = app::costs_of(shell.app());
  if (measured == nullptr) return;
  const app::Costs& costs = *measured;
  draw_chart_choice(shell, column, costs);
  const bool ready = shell.session().asked() == nullptr, any = costs.sheet().rows() > 0;
  const int clicked = column.buttons("costs", {costs.running() ? "Stop" : "Measure", "Save CSV", "Save JSON"}, -1,
                                     {ready || costs.running(), any, any});
  if (clicked == 0) shell.app().command(costs.running() ? "stop_measuring" : "measure");
  if (clicked > 0) shell.save_costs(clicked == 1 ? "csv" : "json");
  const app::Look& look = column.look();
  if (costs.running()) {
    const float share = static_cast<float>(costs.progress());
    column.list()->AddRectFilled({column.x(), column.y()}, {column.x() + column.width(), column.y() + 4}, look->track,
                                 2);
    column.list()->AddRectFilled({column.x(), column.y()}, {column.x() + column.width() * share, column.y() + 4},
                                 look->current, 2);
  }
  column.gap(12);
  if (ready) {
    column.words(costs.status(shell.session()), Face::kRegular, 13, look->muted);
    column.gap(8);
  }
  if (ready && !costs.running() && lesson::costs_of(shell.session()) != nullptr)
    for (const lesson::Outcome& outcome : shell.session().outcomes()) draw_outcome(column, outcome), column.gap(8);
}

/// A choice with its label before it, on a row of its own: titles are long.
int draw_labelled(Column& column, std::string_view label, const std::vector<std::string>& words, int chosen) {
  const app::Look& look = column.look();
  const float row = look.px(34);
  const float before = std::max(app::measure(look, Face::kRegular, 13, lesson::kAlgorithmWord).x,
                                app::measure(look, Face::kRegular, 13, lesson::kCompareWord).x) +
                       12;
  app::text(column.list(), look, Face::kRegular, 13, {column.x(), app::middle_of(column.y() + row / 2, look.px(13))},
            look->muted, label);
  const int clicked = column.chooser(std::string(label).c_str(), before, column.width() - before, words, chosen);
  column.gap(row + 6);
  return clicked;
}

/// How the chart's predictions came out; of a run's, the card on the stage says it.
void draw_score(Shell& shell, Column& column) {
  const std::string score = shell.session().score();
  if (score.empty()) return;
  column.begin_card();
  column.words(score, Face::kSemiBold, 14);
  column.gap(8);
  const bool again = column.buttons("again", {std::string(lesson::kPredictAgainWord)}) == 0;
  column.end_card();
  if (!again) return;
  shell.session().forget_answers();
  if (app::Cover* const cover = shell.app().cover()) cover->show(false);  // it would give the answers away
  else shell.app().command("first");
}

void draw_algorithms(Shell& shell, Column& column) {
  lesson::Session& session = shell.session();
  std::vector<std::string> titles, beside{std::string(lesson::kNoneWord)};
  std::vector<std::string> names, beside_names{""};
  int main = -1, second = 0;
  for (const std::string& name : session.lesson().algorithms) {
    const lesson::Method* algorithm = lesson::find_method(session.lesson(), name);
    if (algorithm == nullptr) continue;
    if (algorithm == session.method(0)) main = static_cast<int>(titles.size());
    titles.emplace_back(algorithm->title), names.push_back(name);
    if (algorithm == session.method(0)) continue;
    if (algorithm == session.method(1)) second = static_cast<int>(beside.size());
    beside.emplace_back(algorithm->title), beside_names.push_back(name);
  }
  if (const int chosen = draw_labelled(column, lesson::kAlgorithmWord, titles, main); chosen >= 0)
    shell.tell(session.choose(0, names[chosen]));
  if (names.size() < 2) return;
  if (const int chosen = draw_labelled(column, lesson::kCompareWord, beside, second); chosen >= 0)
    shell.tell(session.choose(1, beside_names[chosen]));
}

/// The pseudocode, the line of the step lit. Lines too long for the column are broken, and set in.
void draw_pseudocode(Shell& shell, Column& column) {
  constexpr float kSize = 12, kLeading = 22;
  const lesson::Session& session = shell.session();
  const app::Look& look = column.look();
  const int lit = session.line();
  const float advance = app::measure(look, Face::kMono, kSize, " ").x;
  int number = 0;
  for (const std::string_view line : session.pseudocode(0)) {
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    const bool on = number++ == lit;
    float inset = advance * static_cast<float>(indent) + 4;
    const auto parts = app::lines_of(look, on ? Face::kMonoBold : Face::kMono, kSize, line.substr(indent),
                                     column.width() - inset - advance * 2);
    const float height = look.px(kLeading) * static_cast<float>(parts.size());
    if (on)
      column.list()->AddRectFilled({column.x() - 8, column.y()}, {column.x() + column.width() + 8, column.y() + height},
                                   look->lit, 4);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const float y = column.y() + look.px(kLeading) * (static_cast<float>(i) + 0.5f);
      app::text(column.list(), look, on ? Face::kMonoBold : Face::kMono, kSize,
                {column.x() + inset + (i > 0 ? advance * 2 : 0), app::middle_of(y, look.px(kSize))}, look->ink,
                parts[i]);
    }
    column.gap(height);
  }
}

/// The lower part of a column, which scrolls. needed: its height, as drawn; one more frame is due where it was another.
template <class Draw>
void draw_lower(Shell& shell, const char* id, const app::Rect& rect, float& needed, Draw draw) {
  const app::Look& look = shell.app().look();
  const app::Pane pane(id, rect, app::Pane::Kind::kScrolls);
  pane.list()->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, look->panel);
  app::rule(pane.list(), rect.x, rect.y, rect.width, look->line);
  const float top = rect.y + 16 - ImGui::GetScrollY(), margin = std::min(kMargin, rect.width * 0.09f);
  Column column(look, rect.x + margin, top, rect.width - 2 * margin);
  draw(column);
  ImGui::SetCursorScreenPos({column.x(), column.y() - 2});
  ImGui::Dummy({1, 1});
  const float height = std::ceil(column.y() - top + 16);
  if (height != needed) needed = height, shell.measured_anew = true;
}

}  // namespace

void draw_prose_panel(Shell& shell, const app::Rect& rect) {
  const app::Look& look = shell.app().look();
  const float tabs = look.px(44);
  const bool charts = app::costs_of(shell.app()) != nullptr;
  const float pinned = charts ? std::min(shell.pinned_height, rect.height - tabs - look.px(120)) : 0;
  {
    const app::Pane pane("##column", {rect.x, rect.y, rect.width, tabs});
    pane.list()->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, look->panel);
    draw_tabs(shell, look, pane.list(), {rect.x, rect.y, rect.width, tabs});
  }
  const app::Rect upper{rect.x, rect.y + tabs, rect.width - 1, rect.height - tabs - pinned};
  {
    const app::Pane pane(shell.points_tab ? "##points" : "##prose", upper, app::Pane::Kind::kScrolls);
    pane.list()->AddRectFilled({upper.x, upper.y}, {upper.x + upper.width, upper.y + upper.height}, look->panel);
    Column column(look, upper.x + kMargin, upper.y + 20 - ImGui::GetScrollY(), upper.width - 2 * kMargin);
    if (shell.points_tab) draw_point_tools(shell, column);
    else draw_lesson(shell, column);
    ImGui::SetCursorScreenPos({column.x(), column.y() + 8});
    ImGui::Dummy({1, 1});
  }
  if (charts) {
    const app::Rect lower{rect.x, upper.y + upper.height, rect.width - 1, pinned};
    draw_lower(shell, "##pinned", lower, shell.pinned_height, [&](Column& column) {
      draw_costs(shell, column);
      if (!shell.session().lesson().subject->asks_of_steps) draw_score(shell, column);
    });
  }
  const app::Pane edge("##edge", {rect.x + rect.width - 1, rect.y, 1, rect.height});
  edge.list()->AddRectFilled({rect.x + rect.width - 1, rect.y}, {rect.x + rect.width, rect.y + rect.height},
                             look->line);
}

void draw_code_panel(Shell& shell, const app::Rect& rect) {
  draw_lower(shell, "##code", rect, shell.code_height, [&](Column& column) {
    draw_algorithms(shell, column);
    column.gap(4);
    draw_pseudocode(shell, column);
    column.gap(16);
  });
}

}  // namespace snug::desktop
