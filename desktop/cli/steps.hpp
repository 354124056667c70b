// Steps from one to another, as they are typed.
#pragma once

#include <array>
#include <optional>
#include <string>

namespace snug::desktop {

/// "3-12" as two steps, the first before the last; none if it is no range.
[[nodiscard]] std::optional<std::array<int, 2>> steps_of(const std::string& text);

}  // namespace snug::desktop
