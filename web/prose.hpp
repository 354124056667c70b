// The lesson's texts for the page, which makes HTML of them.
#pragma once

#include <emscripten/val.h>

#include <string_view>

#include "lesson/prose_figures.hpp"
#include "lesson/session.hpp"

namespace snug::web {

/// A paragraph as [{text, strong, emphasis, code, script, tex, link, figure, sentence}]: what does not hold is left
/// out, and figure is the figure's name in the view's proseFigures.
[[nodiscard]] emscripten::val stretch_array(const lesson::Paragraph& paragraph);
/// The same of a text with inline markup, such as a prompt.
[[nodiscard]] emscripten::val prompt_array(std::string_view text);
/// {kind, rows, right}: rows of cells, each a paragraph.
[[nodiscard]] emscripten::val block_object(const lesson::Block& block);
/// The figures of the lesson's texts as they are now: {name: {text, says, known}}.
[[nodiscard]] emscripten::val prose_figures_object(const lesson::Session& session);

}  // namespace snug::web
