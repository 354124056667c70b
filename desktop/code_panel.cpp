// The choice of algorithms, and the pseudocode with the current line.
#include <algorithm>

#include "app/marks.hpp"
#include "desktop/lower_panel.hpp"
#include "desktop/prose_panel.hpp"
#include "lesson/code_told.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects.hpp"

namespace snug::desktop {
namespace {

using app::Face;

/// The width of the labels where they stand before their choices.
float label_width(const app::Look& look) {
  return std::max(app::measure(look, Face::kRegular, 13, lesson::kAlgorithmWord).x,
                  app::measure(look, Face::kRegular, 13, lesson::kCompareWord).x) +
         12;
}

/// Whether a title is too long for a choice beside its label. All labels then stand above their choices: no title is
/// cut off, and the choices are one below the other.
bool stand_above(const Column& column, const std::vector<std::string>& titles) {
  constexpr float kAround = 44;  // pixels of a chooser's width that no words have
  const float width = column.width() - label_width(column.look());
  return std::any_of(titles.begin(), titles.end(), [&](const std::string& title) {
    return app::measure(column.look(), Face::kSemiBold, 14, title).x + kAround > width;
  });
}

/// A choice with its label before it or above it.
int draw_labelled(Column& column, std::string_view label, const std::vector<std::string>& words, int chosen,
                  bool above) {
  const app::Look& look = column.look();
  const float row = look.px(34), height = above ? look.px(20) : row, before = above ? 0 : label_width(look);
  app::text(column.list(), look, Face::kRegular, 13, {column.x(), app::middle_of(column.y() + height / 2, look.px(13))},
            look->muted, label);
  if (above) column.gap(height);
  const int clicked = column.chooser(std::string(label).c_str(), before, column.width() - before, words, chosen);
  column.gap(row + 6);
  return clicked;
}

void draw_algorithms(Shell& shell, Column& column) {
  lesson::Session& session = shell.session();
  std::vector<std::string> titles, beside{std::string(lesson::kNoneWord)};
  std::vector<std::string> names, beside_names{""};
  int main = -1, second = 0;
  for (const std::string& name : session.lesson().algorithms) {
    const lesson::Method* algorithm = lesson::find_method(session.lesson(), name);
    if (algorithm == nullptr) continue;
    if (algorithm == session.player().method(0)) main = static_cast<int>(titles.size());
    titles.push_back(lesson::title_in(session.lesson(), *algorithm)), names.push_back(name);
    if (algorithm == session.player().method(0)) continue;
    if (algorithm == session.player().method(1)) second = static_cast<int>(beside.size());
    beside.push_back(lesson::title_in(session.lesson(), *algorithm)), beside_names.push_back(name);
  }
  const bool above = stand_above(column, titles);
  if (const int chosen = draw_labelled(column, lesson::kAlgorithmWord, titles, main, above); chosen >= 0)
    shell.tell(session.player().choose(0, names[chosen]));
  if (names.size() < 2) return;
  if (const int chosen = draw_labelled(column, lesson::kCompareWord, beside, second, above); chosen >= 0)
    shell.tell(session.player().choose(1, beside_names[chosen]));
}

/// The pseudocode, the line of the step lit. Lines too long for the column are broken, and set in.
void draw_pseudocode(Shell& shell, Column& column) {
  constexpr float kSize = 12, kLeading = 22;
  const lesson::Session& session = shell.session();
  const app::Look& look = column.look();
  const auto [lines, lit] = lesson::code_told(session);
  const float advance = app::measure(look, Face::kMono, kSize, " ").x;
  int number = 0;
  for (const std::string_view line : lines) {
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    const bool on = number++ == lit;
    float inset = advance * static_cast<float>(indent) + 4;
    const auto parts = app::lines_of(look, on ? Face::kMonoBold : Face::kMono, kSize, line.substr(indent),
                                     column.width() - inset - advance * 2);
    const float height = look.px(kLeading) * static_cast<float>(parts.size());
    if (on && shell.code_seen != lit)  // a column that is too low for all of it follows the step
      ImGui::SetScrollFromPosY(column.y() + height / 2 - ImGui::GetWindowPos().y);
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
  shell.code_seen = lit;
}

}  // namespace

void draw_code_panel(Shell& shell, const app::Rect& rect) {
  draw_lower(shell, "##code", rect, shell.code_height, [&](Column& column) {
    if (shell.app().sitting() == nullptr && !shell.demo) draw_algorithms(shell, column);
    column.gap(4);
    draw_pseudocode(shell, column);
    column.gap(16);
  });
}

}  // namespace snug::desktop
