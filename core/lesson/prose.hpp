// The lessons' prose: paragraphs apart by an empty line, **strong** words, [words](kind:target) that speak to the
// stage, and $formulas$ in TeX.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lesson/lesson.hpp"

namespace snug::lesson {

/// The first thing wrong with a text ("has a ** without a partner"), in which of its paragraphs, by that one's first
/// line, and the words that are at fault. All empty for nothing.
struct ProseFault {
  std::string what, paragraph, words;
};

/// Line ends within a paragraph are spaces.
[[nodiscard]] std::vector<Paragraph> paragraphs_of(std::string_view text, ProseFault& fault);

/// Its words alone.
[[nodiscard]] std::string plain_text(const Paragraph& paragraph);

}  // namespace snug::lesson
