// The texts with their markup, of which the page makes HTML.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/told/words.hpp"
#include "lesson/lesson.hpp"

namespace snug::app::told {

struct Link {
  Word<"lesson", "mesh", "algorithm", "step", "mark", "situation"> kind;
  std::string target;
  SNUG_FIELDS(kind, target);
};

struct Stretch {
  std::string text;
  IfAny<bool> strong, emphasis, code;
  IfAny<Word<"sub", "sup">> script;
  IfAny<std::string> tex;
  IfAny<Link> link;
  IfAny<std::string> figure;  // its name in Figures::prose_figures
  IfAny<int> sentence;
  SNUG_FIELDS(text, strong, emphasis, code, script, tex, link, figure, sentence);
};
using Paragraph = List<Stretch>;

/// A row of a paragraph or of a list has one cell.
struct Block {
  Word<"paragraph", "bullets", "numbers", "table"> kind;
  List<List<Paragraph>> rows;
  std::vector<bool> right;
  SNUG_FIELDS(kind, rows, right);
};

[[nodiscard]] Paragraph paragraph_of(const lesson::Paragraph& own);
/// That of a text with inline markup, such as a prompt.
[[nodiscard]] Paragraph prompt_of(std::string_view text);
[[nodiscard]] Block block_of(const lesson::Block& own);

}  // namespace snug::app::told
