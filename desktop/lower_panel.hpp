// The lower part of a column beside the stage, which scrolls separately.
#pragma once

#include <algorithm>
#include <cmath>

#include "desktop/column.hpp"
#include "desktop/shell.hpp"

namespace snug::desktop {

inline constexpr float kMargin = 28;

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
  app::fade_foot(pane.list(), rect, look->panel);
  const float height = std::ceil(column.y() - top + 16);
  if (height != needed) needed = height, shell.measured_anew = true;
}

}  // namespace snug::desktop
