// Answers as a text that a device may keep until the next visit: in a page's storage, in a window's state file.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/ask.hpp"

namespace snug::lesson {

/// TOML. What is pending stays so: it is decided by the next measurement.
[[nodiscard]] std::string kept_text(std::span<const Outcome> outcomes);

/// What kept_text wrote, of which a device may have lost or damaged any part: then none.
[[nodiscard]] std::vector<Outcome> outcomes_of(std::string_view kept);

}  // namespace snug::lesson
