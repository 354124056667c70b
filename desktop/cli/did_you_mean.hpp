// What somebody meant who mistyped a name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace snug::desktop {

/// `; did you mean "ritter"?` for the only known name that begins with the word, or else the nearest, which is one slip
/// in four letters away at most; else nothing. A slip is a letter that is missing, too much, wrong or swapped with its
/// neighbour.
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

}  // namespace snug::desktop
