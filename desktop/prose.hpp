// Draws a lesson's prose in a column: its terms, formulas, and the links that light up marks on the stage.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "desktop/column.hpp"
#include "lesson/lesson.hpp"

namespace snug::desktop {

/// A word of a link, with its place.
struct PlacedLink {
  const lesson::Link* link;
  app::Rect rect;
};

/// The links under the pointer and the keyboard; null for none. links: all of them, line by line.
struct ProseTouch {
  const lesson::Link* hovered = nullptr;
  const lesson::Link* focused = nullptr;
  const lesson::Link* clicked = nullptr;
  std::vector<PlacedLink> links = {};
};

/// lit: the marks whose words are lit, because their handle is pointed at.
ProseTouch draw_prose(Column& column, const lesson::Paragraph& paragraph, std::span<const std::string_view> lit);

}  // namespace snug::desktop
