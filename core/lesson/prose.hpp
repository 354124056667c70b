// The lessons' prose: paragraphs separated by empty lines, **strong** words, [words](kind:target) that link to the
// stage, and $formulas$ in TeX.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lesson/lesson.hpp"

namespace snug::lesson {

/// The first thing wrong with a text ("has a ** without a partner"), the first line of the paragraph that has it, and
/// the faulty words. All empty if nothing is wrong.
struct ProseFault {
  std::string what, paragraph, words;
};

/// Splits a text into paragraphs. Line ends within a paragraph become spaces.
[[nodiscard]] std::vector<Paragraph> paragraphs_of(std::string_view text, ProseFault& fault);

/// The words of a paragraph, without markup.
[[nodiscard]] std::string plain_text(const Paragraph& paragraph);

}  // namespace snug::lesson
