// Texts that commands put together.
#pragma once

#include <string>
#include <string_view>

namespace snug::desktop {

/// "ritter, welzl"
template <class Words>
[[nodiscard]] std::string joined(const Words& words, std::string_view between = ", ") {
  std::string text;
  for (const std::string_view word : words) text.append(text.empty() ? "" : between).append(word);
  return text;
}

/// The text with another in the place of each such part.
[[nodiscard]] inline std::string replaced(std::string text, std::string_view part, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += by.size())
    text.replace(at, part.size(), by);
  return text;
}

/// The text as XML has it, in elements and attributes.
[[nodiscard]] inline std::string xml_text(std::string text) {
  text = replaced(replaced(std::move(text), "&", "&amp;"), "<", "&lt;");
  return replaced(replaced(std::move(text), ">", "&gt;"), "\"", "&quot;");
}

}  // namespace snug::desktop
