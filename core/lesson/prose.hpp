// The lessons' prose: paragraphs separated by empty lines, **strong** words, [words](kind:target) that link to the
// stage, and $formulas$ in TeX.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lesson/lesson.hpp"

namespace snug::lesson {

/// Something wrong with a text ("has a ** without a partner"), the first line of the paragraph that has it, and the
/// faulty words, if it is only some of them.
struct ProseFault {
  std::string what, paragraph, words;
};

/// Splits a text into paragraphs. Line ends within a paragraph become spaces. Adds what is wrong to faults.
[[nodiscard]] std::vector<Paragraph> paragraphs_of(std::string_view text, std::vector<ProseFault>& faults);

/// The words of a paragraph, without markup.
[[nodiscard]] std::string plain_text(const Paragraph& paragraph);

}  // namespace snug::lesson
