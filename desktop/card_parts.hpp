// What the cards at the bottom of the stage are made of.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "desktop/column.hpp"
#include "lesson/exercise/sitting.hpp"

namespace snug::desktop {

class Shell;

struct RowButton {
  const char* id;
  std::string_view words;
  app::ButtonKind kind = app::ButtonKind::kOutlined;
  bool enabled = true;
};

/// Draws buttons at the right end of a row, after its text. Returns the one that was clicked, or -1.
int draw_row(Column& column, std::string_view says, app::Color color, std::span<const RowButton> buttons);

/// "Your prediction · 2 of 4", after the mark of its outcome.
void draw_kicker(Column& column, std::string_view words, std::string_view place, lesson::AnswerState standing);

/// Each question in a line that leads back to its reason, in an exercise with its mark. Returns the command of the line
/// that was clicked.
[[nodiscard]] std::string draw_lines(Shell& shell, Column& column, const std::vector<lesson::Marked>& marked);

}  // namespace snug::desktop
