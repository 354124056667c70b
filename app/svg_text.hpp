// Numbers, colours and words as an SVG file has them.
#pragma once

#include <string>
#include <string_view>

#include "app/palette.hpp"

namespace snug::app {

__attribute__((format(printf, 1, 2))) std::string printed(const char* format, ...);
/// A length with two decimals at most: "12", "12.5".
[[nodiscard]] std::string px_text(float value);
[[nodiscard]] std::string hex(Color color);
/// The opacity of a colour as an attribute, where it is not full.
[[nodiscard]] std::string opacity_text(const char* name, Color color);
[[nodiscard]] std::string escaped(std::string_view words);

}  // namespace snug::app
