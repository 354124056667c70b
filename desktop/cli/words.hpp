// Texts that commands put together.
#pragma once

#include <algorithm>
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

/// How many letters a text of UTF-8 has.
[[nodiscard]] inline std::size_t letters_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

/// The text with blanks after it, or before it (right), so that it has at least so many letters.
[[nodiscard]] inline std::string padded(std::string text, std::size_t width, bool right = false) {
  const std::size_t letters = letters_of(text);
  if (letters < width) text.insert(right ? 0 : text.size(), width - letters, ' ');
  return text;
}

/// The text with another in the place of each such part.
[[nodiscard]] inline std::string replaced(std::string text, std::string_view part, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += by.size())
    text.replace(at, part.size(), by);
  return text;
}

/// The text with blanks in place of control characters, which a terminal would obey and a table would break at: those
/// of ASCII, and those that UTF-8 writes in two bytes. lines: its line ends stay.
[[nodiscard]] inline std::string without_controls(std::string text, bool lines = false) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto code = [&](std::size_t at) { return at < text.size() ? static_cast<unsigned char>(text[at]) : 0; };
    if ((code(i) < 0x20 && !(lines && text[i] == '\n')) || code(i) == 0x7f) text[i] = ' ';
    else if (code(i) == 0xc2 && code(i + 1) >= 0x80 && code(i + 1) < 0xa0) text.replace(i, 2, " ");
  }
  return text;
}

/// The text as XML has it, in elements and attributes.
[[nodiscard]] inline std::string xml_text(std::string text) {
  text = replaced(replaced(std::move(text), "&", "&amp;"), "<", "&lt;");
  return replaced(replaced(std::move(text), ">", "&gt;"), "\"", "&quot;");
}

}  // namespace snug::desktop
