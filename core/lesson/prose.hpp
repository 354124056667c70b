// The lessons' prose: paragraphs apart by an empty line, **strong** words, [words](kind:target) that speak to the
// stage, and $formulas$ in TeX.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lesson/lesson.hpp"

namespace snug::lesson {

/// Line ends within a paragraph are spaces. wrong: what is wrong with it ("has a ** without a partner"); empty for
/// nothing.
[[nodiscard]] std::vector<Paragraph> paragraphs_of(std::string_view text, std::string& wrong);

/// Its words alone.
[[nodiscard]] std::string plain_text(const Paragraph& paragraph);

}  // namespace snug::lesson
