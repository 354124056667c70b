#include "desktop/strip.hpp"

#include <algorithm>

#include "app/look.hpp"
#include "app/widgets.hpp"
#include "desktop/column.hpp"

namespace snug::desktop {
namespace {

using app::Face;

constexpr float kStripMargin = 24, kStripPad = 8, kStripEdge = 4;
constexpr float kMostHeight = 152;  // page pixels at text scale 1: more scrolls

void draw_text(Column& column, const check::DraftText& says) {
  const app::Look& look = column.look();
  column.words(says.heading, Face::kSemiBold, 14);
  for (const check::DraftText::Line& line : says.lines)
    column.words(line.text, Face::kRegular, 14, line.warning ? look->ink : look->wrong_text);
}

}  // namespace

void draw_strip(Shell& shell, const app::Rect& rect) {
  const app::Look& look = shell.app().look();
  const auto all = shell.strip();
  const app::Pane pane("##strip", rect, app::Pane::Kind::kScrolls);
  pane.list()->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, look->panel);
  const float top = rect.y + kStripPad - ImGui::GetScrollY();
  Column column(look, rect.x + kStripMargin, top, rect.width - 2 * kStripMargin);
  for (const check::DraftText& says : all) draw_text(column, says);
  ImGui::SetCursorScreenPos({column.x(), column.y()});
  ImGui::Dummy({1, 1});
  const bool wrong = std::any_of(all.begin(), all.end(), [](const check::DraftText& says) {
    return std::any_of(says.lines.begin(), says.lines.end(), [](const auto& line) { return !line.warning; });
  });
  pane.list()->AddRectFilled({rect.x, rect.y}, {rect.x + kStripEdge, rect.y + rect.height},
                             wrong ? look->wrong : look->muted);
  app::rule(pane.list(), rect.x, rect.y + rect.height - 1, rect.width, look->line);
  const float height = std::min(column.y() - top + 2 * kStripPad, look.px(kMostHeight));
  if (height != shell.strip_height) shell.strip_height = height, shell.measured_anew = true;
}

}  // namespace snug::desktop
