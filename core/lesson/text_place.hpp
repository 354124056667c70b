// Where in a lesson's file a text has what is wrong with it.
#pragma once

#include <string_view>

#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// Where the words stand in the text of that key; from the beginning of a stretch of it on, where that is given. Where
/// the text has not got them, where that stretch is, or the text.
[[nodiscard]] FilePlace place_in_text(const toml::table& table, std::string_view key, std::string_view words,
                                      std::string_view from = {});

}  // namespace snug::lesson
