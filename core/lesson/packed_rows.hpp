// Packs rows of numbers into one short word of an address, exact to the last bit. 800 points fit into an address that
// would be too long as decimals.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lesson/session.hpp"

namespace snug::lesson {

/// A word of letters, digits, - and _. Numbers with few decimals, as in most files, take two or three letters each;
/// others take eleven.
[[nodiscard]] std::string packed_rows(const Rows& rows);
/// None if the word was not made by packed_rows.
[[nodiscard]] std::optional<Rows> unpacked_rows(std::string_view word);

}  // namespace snug::lesson
