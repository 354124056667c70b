// Finds the line of an error within a text of a lesson's file.
#pragma once

#include <string_view>

#include "lesson/toml.hpp"

namespace snug::lesson {

/// The line, counted from 1, of some words in the text of a key; searched from the start of a stretch of it, if that is
/// given. If the text does not contain them, the line of that stretch, or of the text.
[[nodiscard]] int line_in_text(const toml::table& table, std::string_view key, std::string_view words,
                               std::string_view from = {});

}  // namespace snug::lesson
