// Where in a lesson's file a text has what is wrong with it.
#pragma once

#include <string_view>

#include "lesson/toml_table.hpp"

namespace snug::lesson {

[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The text of that key, as it stands in the file; empty if there is none.
[[nodiscard]] std::string_view text_of(const toml::table& table, std::string_view key);

/// Where the text of that key has its letter `at`.
[[nodiscard]] FilePlace place_in_text(const toml::table& table, std::string_view key, std::size_t at);

/// Where the words first stand in the text of that key, or where the text begins.
[[nodiscard]] FilePlace place_in_text(const toml::table& table, std::string_view key, std::string_view words);

}  // namespace snug::lesson
