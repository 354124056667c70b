// Formulas in the prose. The page typesets them from TeX when it is built; everything else shows them in one line.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace snug::lesson {

/// TeX in a line of Unicode: \sum_i x_i^2 becomes "∑ᵢ xᵢ²". Sub- and superscripts without Unicode characters
/// keep their _ and ^; fractions and roots are written with / and √. Errors: an unknown command, an unmatched
/// brace.
[[nodiscard]] tl::expected<std::string, std::string> plain_formula(std::string_view tex);

}  // namespace snug::lesson
