// A lesson's prose in a column: its terms, formulas, and the words that speak to the stage.
#pragma once

#include <span>
#include <string_view>

#include "desktop/column.hpp"
#include "lesson/lesson.hpp"

namespace snug::desktop {

/// The links under the pointer; null for none.
struct ProseTouch {
  const lesson::Link* hovered = nullptr;
  const lesson::Link* clicked = nullptr;
};

/// lit: the marks whose words are lit, for their handle is pointed at.
ProseTouch draw_prose(Column& column, const lesson::Paragraph& paragraph, std::span<const std::string_view> lit);

}  // namespace snug::desktop
