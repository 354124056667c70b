#include "desktop/stored_panel.hpp"

#include <algorithm>
#include <utility>

#include "app/marks.hpp"
#include "desktop/column.hpp"
#include "lesson/stored.hpp"

namespace snug::desktop {
namespace {

using app::Face;

constexpr float kRow = 22, kSmall = 12;
constexpr double kNews = 1.5;  // seconds for which a number that has changed is marked

/// Whether a member's numbers have changed a moment ago.
bool is_news(Shell& shell, const lesson::StoredMember& member) {
  const double now = ImGui::GetTime();
  const auto [known, first] = shell.stored_before.try_emplace(member.mark, member.text, -kNews);
  auto& [text, since] = known->second;
  if (text != member.text) text = member.text, since = now;
  const bool news = now - since < kNews;
  if (news) shell.measured_anew = true;
  return news;
}

/// Draws a member: as it is declared, and its numbers, below that where they do not fit beside. Returns whether it is
/// pointed at.
bool draw_member(Shell& shell, Column& column, const lesson::StoredMember& member) {
  const app::Look& look = column.look();
  const bool news = is_news(shell, member);
  const Face face = news ? Face::kMonoBold : Face::kMono;
  const float declared = app::measure(look, Face::kMono, kSmall, member.declared).x;
  const float numbers = app::measure(look, Face::kMonoBold, kSmall, member.text).x;
  const float row = look.px(kRow);
  const bool below = declared + numbers + 8 > column.width();
  const float height = below ? row * 1.8f : row;
  const app::Rect rect{column.x() - 8, column.y(), column.width() + 16, height};
  const app::Touch touch = app::touch_area(member.mark.c_str(), rect, member.declared);
  shell.stored_rows.emplace_back(member.mark, rect);
  const bool meant = touch.hovered || touch.focused || touch.held;
  if (meant) column.list()->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, look->lit, 4);
  app::text(column.list(), look, Face::kMono, kSmall, {column.x(), app::middle_of(rect.y + row / 2, look.px(kSmall))},
            look->ink, member.declared);
  app::text_right(column.list(), look, face, kSmall,
                  {column.x() + column.width(), app::middle_of(rect.y + height - row / 2, look.px(kSmall))},
                  news ? look->support_text : look->ink, member.text);
  column.gap(height);
  return meant;
}

void draw_operation(Column& column, const lesson::StoredOperation& operation) {
  const app::Look& look = column.look();
  const float indent = look.px(48), top = column.y();
  app::text(column.list(), look, Face::kRegular, 13, {column.x(), top + look.px(2)}, look->muted, operation.name);
  const float height =
      app::paragraph(column.list(), look, operation.least ? Face::kSemiBold : Face::kRegular, 13, 18,
                     {column.x() + indent, top}, column.width() - indent - 16, look->ink, operation.says);
  if (operation.least)
    app::tick(column.list(), {column.x() + column.width() - 6, top + look.px(9)}, 5, look->optimum, 2);
  column.gap(std::max(height, look.px(18)));
}

/// Returns the mark of the member that is pointed at; empty for none.
std::string draw_form(Shell& shell, Column& column, const lesson::StoredForm& form) {
  const app::Look& look = column.look();
  std::string meant;
  column.words(form.name, Face::kSemiBold, 14);
  const bool asks = shell.demo && shell.session().conversation().asked() != nullptr;
  if (!asks) column.words(form.bytes(), Face::kRegular, 12, look->muted);
  column.gap(2);
  for (const lesson::StoredMember& member : form.members)
    if (draw_member(shell, column, member)) meant = member.mark;
  column.gap(4);
  if (!shell.demo)  // the members are what a slide is about
    for (const lesson::StoredOperation& operation : form.operations) draw_operation(column, operation);
  column.gap(14);
  return meant;
}

}  // namespace

void draw_side_tabs(Shell& shell, const app::Rect& rect) {
  const app::Look& look = shell.app().look();
  const app::Pane pane("##side tabs", rect);
  pane.list()->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, look->panel);
  using Tab = Shell::SideTab;
  float x = rect.x + 24;
  for (const Tab tab : shell.side_tabs) {
    const auto [id, words] = tab == Tab::kStored ? std::pair("tab stored", lesson::kStoredWord)
                             : tab == Tab::kCode ? std::pair("tab code", std::string_view("Code"))
                                                 : std::pair("tab numbers", std::string_view("Numbers"));
    const bool on = shell.side_tab == tab;
    const float width = app::measure(look, Face::kSemiBold, 14, words).x;
    if (app::touch_area(id, {x - 8, rect.y, width + 16, rect.height}, words).clicked) shell.side_tab = tab;
    app::text(pane.list(), look, on ? Face::kSemiBold : Face::kRegular, 14,
              {x, app::middle_of(rect.y + rect.height / 2, look.px(14))}, on ? look->ink : look->muted, words);
    if (on)
      pane.list()->AddRectFilled({x, rect.y + rect.height - 3}, {x + width, rect.y + rect.height - 1}, look->current,
                                 1);
    x += width + 28;
  }
  app::rule(pane.list(), rect.x, rect.y + rect.height - 1, rect.width, look->line);
}

void draw_stored_panel(Shell& shell, const app::Rect& rect) {
  const app::Look& look = shell.app().look();
  if (shell.stored_before.empty()) ImGui::SetNextWindowScroll({0, 0});  // another lesson's begins at its top
  const app::Pane pane("##stored", rect, app::Pane::Kind::kScrolls);
  pane.list()->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, look->panel);
  Column column(look, rect.x + 24, rect.y + 14 - ImGui::GetScrollY(), rect.width - 48);
  std::string meant;
  shell.stored_rows.clear();
  for (const lesson::StoredVolume& volume : lesson::stored_of(shell.session())) {
    column.heading(volume.title);
    for (const lesson::StoredForm& form : volume.forms)
      if (std::string mark = draw_form(shell, column, form); !mark.empty()) meant = std::move(mark);
  }
  ImGui::SetCursorScreenPos({column.x(), column.y() - 2});
  ImGui::Dummy({1, 1});
  app::fade_foot(pane.list(), rect, look->panel);
  if (shell.stored_lit == meant) return;
  shell.stored_lit = std::move(meant);
  shell.measured_anew = true;
}

}  // namespace snug::desktop
