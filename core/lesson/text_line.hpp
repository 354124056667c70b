// Where in a lesson's file a text has what is wrong with it.
#pragma once

#include <string_view>

#include "lesson/toml.hpp"

namespace snug::lesson {

/// The line, counted from 1, on which the words stand in the text of that key; from the beginning of a stretch of it
/// on, where that is given. Where the text has not got them, the line of that stretch, or of the text.
[[nodiscard]] int line_in_text(const toml::table& table, std::string_view key, std::string_view words,
                               std::string_view from = {});

}  // namespace snug::lesson
