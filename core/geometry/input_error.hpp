// Why an input is refused: what is wrong, and where.
#pragma once

#include <cstdint>
#include <string>

namespace snug {

struct InputError {
  enum class Unit : std::uint8_t { kNone, kLine, kByte };

  std::string what;  // one sentence fragment, no full stop: "the x coordinate is not finite"
  std::string file;  // empty if the input is not a file
  Unit unit = Unit::kNone;
  std::int64_t position = 0;  // a line counted from 1, or a byte counted from 0

  /// "FILE:LINE: what", "FILE:byte N: what", "FILE: what" or "what".
  [[nodiscard]] std::string message() const {
    std::string text = file;
    if (unit == Unit::kLine) text += (file.empty() ? "line " : ":") + std::to_string(position);
    if (unit == Unit::kByte) text += (file.empty() ? "byte " : ":byte ") + std::to_string(position);
    return text.empty() ? what : text + ": " + what;
  }
};

}  // namespace snug
