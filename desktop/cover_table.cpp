#include "desktop/cover_table.hpp"

#include <algorithm>

#include "app/cover.hpp"
#include "app/marks.hpp"
#include "app/widgets.hpp"
#include "desktop/measured_before.hpp"

namespace snug::desktop {
namespace {

using app::Face;

constexpr float kTableRow = 20, kHeadSize = 12, kCellSize = 12.5f, kFirstShare = 0.17f, kTableMargin = 16;
constexpr float kSaysSize = 13, kSaysLeading = 19;

struct Seen {
  app::WordTable table;
  std::string says;  // above it, of one that was measured before; empty for none
};

Seen seen_table(Shell& shell) {
  if (shell.app().session() == nullptr || shell.app().cover() == nullptr) return {};
  if (const MeasuredTable* const before = shell.measured_before())
    return {measured_words(*before), measured_says(*before)};
  app::WordTable table = shell.app().cover()->table(shell.session());
  // A lab sheet asks for its figures, whether it can be sorted or not.
  return {table.sorts.empty() && shell.sheet() == nullptr ? app::WordTable{} : std::move(table), {}};
}

float says_height(const app::Look& look, float width, const std::string& says) {
  if (says.empty()) return 0;
  const auto lines = app::lines_of(look, Face::kRegular, kSaysSize, says, width - 2 * kTableMargin);
  return look.px(kSaysLeading) * static_cast<float>(lines.size()) + 4;
}

/// How wide the names of the rows are.
float first_width(const app::Look& look, const app::WordTable& table) {
  float widest = 0;
  for (const auto& row : table.rows)
    widest = std::max(widest, app::measure(look, Face::kSemiBold, kCellSize, row[0]).x);
  return widest + look.px(14);
}

/// Where a column ends, in which words stand flush right; the first column's words begin at its left.
float end_of(const app::Rect& rect, std::size_t column, std::size_t columns, float names) {
  const float first = std::max(rect.width * kFirstShare, std::min(names, rect.width / 2));
  if (column == 0) return rect.x + first;
  return rect.x + first + (rect.width - first) * static_cast<float>(column) / static_cast<float>(columns - 1);
}

/// A triangle that points down: the least stands first.
void draw_sorted(ImDrawList* list, ImVec2 at, float size, app::Color color) {
  list->AddTriangleFilled({at.x - size, at.y - size * 0.6f}, {at.x + size, at.y - size * 0.6f},
                          {at.x, at.y + size * 0.8f}, color);
}

/// Returns the command of the head that was pressed; empty for none.
std::string draw_heads(ImDrawList* list, const app::Look& look, const app::Rect& rect, const app::WordTable& table) {
  std::string pressed;
  const float names = first_width(look, table);
  for (std::size_t i = 0; i < table.head.size(); ++i) {
    const float right = end_of(rect, i, table.head.size(), names),
                left = i == 0 ? rect.x : end_of(rect, i - 1, table.head.size(), names);
    const app::Rect cell{left, rect.y, right - left, look.px(kTableRow)};
    const std::string id = "head " + table.head[i];
    const bool sorts = !table.sorts.empty(), sorted = static_cast<int>(i) == table.sorted;
    const app::Touch touch = sorts ? app::touch_area(id.c_str(), cell, "Sort by " + table.head[i]) : app::Touch{};
    if (touch.clicked) pressed = table.sorts[i];
    const app::Color color = sorted || touch.hovered ? look->current_text : look->muted;
    const float y = app::middle_of(cell.y + cell.height / 2, look.px(kHeadSize));
    const float width = app::measure(look, Face::kSemiBold, kHeadSize, table.head[i]).x,
                x = i == 0 ? left : right - width;
    app::text(list, look, Face::kSemiBold, kHeadSize, {x, y}, color, table.head[i]);
    if (sorted) draw_sorted(list, {x - look.px(8), cell.y + cell.height / 2}, look.px(4), color);
  }
  return pressed;
}

void draw_cells(ImDrawList* list, const app::Look& look, const app::Rect& row, const app::WordTable& table,
                std::size_t i) {
  const bool picked = static_cast<int>(i) == table.picked;
  const float y = app::middle_of(row.y + row.height / 2, look.px(kCellSize));
  if (picked) {
    list->AddRectFilled({row.x - 8, row.y}, {row.x + row.width + 8, row.y + row.height}, look->lit, 4);
    app::diamond(list, {row.x + look.px(4), row.y + row.height / 2}, look.px(4.5f), look->support, look->lit);
  }
  app::text(list, look, Face::kSemiBold, kCellSize, {row.x + (picked ? look.px(14) : 0), y},
            picked ? look->support_text : look->ink, table.rows[i][0]);
  const float names = first_width(look, table);
  for (std::size_t k = 1; k < table.rows[i].size(); ++k) {
    const bool best = !table.best.empty() && table.best[i][k];
    // What is said of a figure has no room here; a figure with a reservation is paler, and has a question mark.
    const std::string& cell = table.rows[i][k];
    const std::size_t end = cell.find(", ");
    const bool doubtful = table.sorts.empty() && end != std::string::npos;
    app::text_right(list, look, best ? Face::kMonoBold : Face::kMono, kCellSize,
                    {end_of(row, k, table.head.size(), names), y},
                    best       ? look->optimum_text
                    : doubtful ? look->muted
                               : look->ink,
                    doubtful ? cell.substr(0, end) + " ?" : cell);
  }
}

}  // namespace

float cover_table_height(Shell& shell, const app::Look& look, float width) {
  const auto [table, says] = seen_table(shell);
  if (table.rows.empty()) return 0;
  return look.px(kTableRow) * static_cast<float>(table.rows.size() + 1) + 12 + says_height(look, width, says);
}

void draw_cover_table(Shell& shell, const app::Rect& rect) {
  const auto [table, says] = seen_table(shell);
  if (table.rows.empty()) return;
  const app::Look& look = shell.app().look();
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const float words = says_height(look, rect.width, says);
  app::Rect row{rect.x + kTableMargin, rect.y + 6 + words, rect.width - 2 * kTableMargin, look.px(kTableRow)};
  app::paragraph(list, look, Face::kRegular, kSaysSize, kSaysLeading, {row.x, rect.y + 6}, row.width, look->muted,
                 says);
  std::string pressed = draw_heads(list, look, row, table);
  app::rule(list, row.x, row.y + row.height - 1, row.width, look->line);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    row.y += row.height;
    const std::string id = "row " + table.rows[i][0];
    if (!table.picks.empty() && app::touch_area(id.c_str(), row, table.rows[i][0]).clicked) pressed = table.picks[i];
    draw_cells(list, look, row, table, i);
  }
  if (!pressed.empty()) shell.app().command(pressed);
}

}  // namespace snug::desktop
