// How one text differs from another: what was put in place of one stretch of it. An address has room for that.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace snug::lesson {

/// "where-how many letters go-what comes"; empty where nothing has changed. Letters are counted in UTF-16, as scripts
/// count them. Both texts: UTF-8.
[[nodiscard]] std::string change_of(std::string_view from, std::string_view to);
/// The text with such a change; none where it says no change of that text.
[[nodiscard]] std::optional<std::string> changed(std::string_view from, std::string_view change);

}  // namespace snug::lesson
