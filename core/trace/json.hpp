// Writes JSON as text: the only place in core that writes the punctuation between values.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

namespace snug {

/// Writes values one after the other, with commas between them. The caller writes a key before each value of an object,
/// and closes what it opened.
class JsonWriter {
 public:
  void open_object() { open('{'); }
  void close_object() { text_ += '}'; }
  void open_list() { open('['); }
  void close_list() { text_ += ']'; }

  void key(std::string_view name) {
    text(name);
    text_ += ':';
  }

  void text(std::string_view value) {
    separate();
    text_ += '"';
    for (const char c : value) put(c);
    text_ += '"';
  }
  void number(double value) {
    std::array<char, 32> digits{};
    std::snprintf(digits.data(), digits.size(), "%.17g", value);
    literal(digits.data());
  }
  void number(int value) { literal(std::to_string(value)); }
  void flag(bool value) { literal(value ? "true" : "false"); }
  /// Writes a number (as given), true, false or null.
  void literal(std::string_view text) {
    separate();
    text_ += text;
  }

  [[nodiscard]] std::string take() { return std::exchange(text_, {}); }

 private:
  void open(char bracket) {
    separate();
    text_ += bracket;
  }
  /// Writes a comma unless this is the first value: no value ends in these characters (a text ends in quotes).
  void separate() {
    if (!text_.empty() && std::string_view("{[:").find(text_.back()) == std::string_view::npos) text_ += ',';
  }
  void put(char c) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') text_ += '\\';
    if (byte >= 0x20) {
      text_ += c;
      return;
    }
    std::array<char, 8> escape{};
    std::snprintf(escape.data(), escape.size(), "\\u%04x", static_cast<unsigned>(byte));
    text_ += escape.data();
  }

  std::string text_;
};

}  // namespace snug
