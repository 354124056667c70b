// Answers as a text that a device keeps until the next visit, in the page's storage or in the window's state file.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/ask.hpp"

namespace snug::lesson {

/// The answers as TOML. Pending ones stay pending: the next measurement decides them.
[[nodiscard]] std::string kept_text(std::span<const Outcome> outcomes);

/// Reads what kept_text wrote. Returns none if the text is damaged.
[[nodiscard]] std::vector<Outcome> outcomes_of(std::string_view kept);

}  // namespace snug::lesson
