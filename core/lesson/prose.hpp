// The lessons' prose: paragraphs apart by an empty line, **strong** words.
#pragma once

#include <string_view>
#include <vector>

#include "lesson/lesson.hpp"

namespace snug::lesson {

/// Line ends within a paragraph are spaces. closed: false where a ** has no partner.
[[nodiscard]] std::vector<Paragraph> paragraphs_of(std::string_view text, bool& closed);

}  // namespace snug::lesson
