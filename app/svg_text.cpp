#include "app/svg_text.hpp"

#include <array>
#include <cstdarg>
#include <cstdio>

namespace snug::app {

std::string printed(const char* format, ...) {
  std::array<char, 256> text{};
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text.data(), text.size(), format, arguments);
  va_end(arguments);
  return text.data();
}

std::string px_text(float value) {
  std::string text = printed("%.2f", static_cast<double>(value));
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string hex(Color color) { return printed("#%02x%02x%02x", color & 0xff, color >> 8 & 0xff, color >> 16 & 0xff); }

std::string opacity_text(const char* name, Color color) {
  const auto alpha = color >> 24;
  return alpha == 0xff ? "" : printed(" %s=\"%.2f\"", name, alpha / 255.0);
}

std::string escaped(std::string_view words) {
  std::string text;
  for (const char c : words) {
    if (c == '&') text += "&amp;";
    else if (c == '<') text += "&lt;";
    else if (c == '>') text += "&gt;";
    else if (c == '"') text += "&quot;";
    else text += c;
  }
  return text;
}

}  // namespace snug::app
