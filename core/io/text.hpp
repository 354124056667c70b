// What the text formats share: lines, words, numbers, and how an error quotes what it found.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "geometry/input_error.hpp"

namespace snug::io {

template <class T>
using Read = tl::expected<T, InputError>;

[[nodiscard]] inline tl::unexpected<InputError> at_line(std::int64_t line, std::string what) {
  return tl::unexpected(InputError{std::move(what), {}, InputError::Unit::kLine, line});
}
[[nodiscard]] inline tl::unexpected<InputError> at_byte(std::int64_t byte, std::string what) {
  return tl::unexpected(InputError{std::move(what), {}, InputError::Unit::kByte, byte});
}

/// A text's lines with their numbers. A line ends with LF, CRLF, CR or LFCR; blank ones count. The first line end
/// decides whether a CR alone ends a line: if so, an LF byte after a CR belongs to the data.
class Lines {
 public:
  explicit Lines(std::string_view text, std::int64_t first = 1) : rest_(text), number_(first - 1) {}

  /// Goes to the next line; false at the end of the text.
  bool next();
  /// Goes to the next line that is not blank.
  bool next_filled();

  [[nodiscard]] std::string_view line() const { return line_; }
  /// The line's number; at the end of the text, that of the last line.
  [[nodiscard]] std::int64_t number() const { return number_; }
  /// The text after the line.
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  enum class Ends : std::uint8_t { kUnknown, kUsual, kCr, kLfCr };

  Ends ends_ = Ends::kUnknown;
  std::string_view rest_;
  std::string_view line_;
  std::int64_t number_;
};

/// Whether the text is UTF-16: it has that byte order mark, or every second byte at its start is zero.
[[nodiscard]] bool is_utf16(std::string_view bytes);
/// What is said of such a file.
inline constexpr const char* kIsUtf16 = "the text is UTF-16: save it as UTF-8";

[[nodiscard]] std::string_view trim(std::string_view text);

/// A line without its comment: '#' begins one at the line's start or after a blank, and not in a word such as "1.#IND".
[[nodiscard]] std::string_view without_comment(std::string_view line);

/// Removes padding from a text's end: zero bytes and DOS's end-of-file mark. Returns how many bytes.
std::int64_t take_padding(std::string_view& text);

/// Takes the next word, between blanks and tabs, off the front of rest; returns an empty one if there is none.
[[nodiscard]] std::string_view take_word(std::string_view& rest);

/// Lower-cases ASCII letters only, whatever the locale.
[[nodiscard]] std::string lower_case(std::string_view text);

/// The text in quotation marks, shortened and made printable.
[[nodiscard]] std::string quoted(std::string_view text);

/// "1 byte", "2 bytes".
[[nodiscard]] std::string counted(std::int64_t n, std::string_view noun);

/// A decimal number, a leading + allowed; also nan and the infinities, as Windows writes them too: "-1.#IND". None if
/// the word is not a number.
[[nodiscard]] std::optional<double> parse_number(std::string_view word);

/// None if the word is not a 64-bit integer.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view word);

/// A coordinate that a PointSet takes, or one that is not finite if that is allowed, or what is wrong with it.
[[nodiscard]] tl::expected<double, std::string> parse_coordinate(std::string_view word, bool allow_not_finite);

/// What is wrong with a coordinate; empty if it is taken.
[[nodiscard]] std::string_view fault_of_coordinate(double value, bool allow_not_finite);

/// The shortest text that reads back as the same number; value: finite.
[[nodiscard]] std::string shortest_text(double value);

}  // namespace snug::io
