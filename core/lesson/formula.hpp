// Formulas of the prose. The page has them typeset from TeX when it is built; everything else shows them in one line.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace snug::lesson {

/// TeX in a line of Unicode: \sum_i x_i^2 becomes "∑ᵢ xᵢ²". Sub- and superscripts that have no characters of their own
/// keep their _ and ^; fractions and roots are written with / and √. Errors: a command that is none of those that are
/// known here, a brace without a partner.
[[nodiscard]] tl::expected<std::string, std::string> plain_formula(std::string_view tex);

}  // namespace snug::lesson
