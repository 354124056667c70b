// Draws a lesson's texts in a column: paragraphs, lists and tables, with their terms, formulas, figures of the run, and
// the links that light up marks on the stage.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "desktop/column.hpp"
#include "lesson/prose_figures.hpp"

namespace snug::desktop {

/// How words are written that are not marked.
struct Writing {
  float size = 15, leading = 24;  // at text scale 1
  app::Face face = app::Face::kRegular;
  app::Color color = 0;   // 0: ink
  app::Color ground = 0;  // behind code; 0: raised
};

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
  std::vector<std::string> figures = {};  // as they were drawn

  /// Takes in those of another text.
  void add(const ProseTouch& other);
};

/// Draws a part of a section. lit: the marks whose words are lit, because their handle is pointed at.
ProseTouch draw_block(Column& column, const lesson::Block& block, lesson::ProseFigures& figures,
                      std::span<const std::string_view> lit);

/// Draws a text with inline markup, such as a prompt.
void draw_prompt(Column& column, std::string_view text, lesson::ProseFigures& figures, const Writing& writing);

}  // namespace snug::desktop
