// The shape of what a function takes or gives: how numbers one after the other are written as JSON, and what may be
// left out of them.
//
//   n              a number               b             true (1) or false (0)
//   i              a whole number         one|two       one of these words, by its place
//   3T             a list of three T      *T            a list of any length, which stands before it
//   {name:T,...}   an object
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "write/function.hpp"

namespace snug::write {

/// Writes the numbers as JavaScript reads them. −0 keeps its sign; infinity and NaN have JavaScript's names.
[[nodiscard]] std::string json_of(std::string_view shape, const Numbers& numbers);

/// Whether there are as many numbers as the shape takes, and no list is longer than it says.
[[nodiscard]] bool fits(std::string_view shape, const Numbers& numbers);

/// The same with one thing simpler each: an element of a list left out, a number rounded, halved or 0.
[[nodiscard]] std::vector<Numbers> simpler(std::string_view shape, const Numbers& numbers);

}  // namespace snug::write
