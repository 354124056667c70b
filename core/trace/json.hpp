// JSON as text: what stands between values is written here, and nowhere else in core.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

namespace snug {

/// Writes values one after the other, with the commas between them. Who calls it sees to it that a key stands before
/// each value of an object, and that what was opened is closed.
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
  /// A number as it is to stand there, true, false or null.
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
  /// A comma, unless nothing stands before: no value ends in one of these, for texts end in a quotation mark.
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
