#include "io/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fast_float/fast_float.h>
#include <limits>
#include <string>

#include "geometry/point_set.hpp"

namespace snug::io {
namespace {

constexpr std::string_view kBlanks = " \t\v\f";
constexpr std::string_view kDigits = "0123456789";

/// What Windows writes for what is not finite, filled up with zeros: "1.#IND", "1.#QNAN0", "1.#INF00". word: unsigned.
std::optional<double> parse_windows(std::string_view word) {
  const std::string name = lower_case(word.substr(0, word.find_last_not_of('0') + 1));
  if (name == "1.#inf") return std::numeric_limits<double>::infinity();
  if (name == "1.#ind" || name == "1.#qnan" || name == "1.#snan") return std::numeric_limits<double>::quiet_NaN();
  return std::nullopt;
}

/// What decimal commas leave of numbers: "1,5", or "5 2" where commas separate. "1,5,2" is a list.
bool has_decimal_comma(std::string_view word) {
  const std::size_t at = word.find_first_of(", \t");
  return at != std::string_view::npos && (kDigits.find(word[0]) < kDigits.size() || word[0] == '+' || word[0] == '-') &&
         word.find(',', at + 1) == std::string_view::npos && kDigits.find(word.back()) < kDigits.size();
}

}  // namespace

bool Lines::next() {
  if (rest_.empty()) return false;
  const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
  line_ = rest_.substr(0, end);
  rest_.remove_prefix(end);
  const std::string_view two = rest_.substr(0, 2);
  if (ends_ == Ends::kUnknown && !two.empty()) {
    const bool lone_cr = two[0] == '\r' && two != "\r\n";
    if (two == "\n\r") ends_ = Ends::kLfCr;
    else ends_ = lone_cr ? Ends::kCr : Ends::kUsual;
  }
  const bool pair = (two == "\r\n" && ends_ != Ends::kCr) || (two == "\n\r" && ends_ == Ends::kLfCr);
  rest_.remove_prefix(pair ? 2 : std::min<std::size_t>(1, rest_.size()));
  ++number_;
  return true;
}

bool Lines::next_filled() {
  while (next())
    if (!trim(line_).empty()) return true;
  return false;
}

bool is_utf16(std::string_view bytes) {
  if (bytes.substr(0, 2) == "\xff\xfe" || bytes.substr(0, 2) == "\xfe\xff") return true;
  const std::string_view start = bytes.substr(0, 8);
  if (start.size() < 8) return false;
  for (const std::size_t zero : {0, 1}) {
    bool all = true;
    for (std::size_t i = 0; i < start.size(); ++i) all = all && (start[i] == '\0') == (i % 2 == zero);
    if (all) return true;
  }
  return false;
}

std::string_view trim(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

std::string_view without_comment(std::string_view line) {
  std::size_t at = line.find('#');
  while (at != std::string_view::npos && at > 0 && kBlanks.find(line[at - 1]) == std::string_view::npos)
    at = line.find('#', at + 1);
  return line.substr(0, at);
}

std::int64_t take_padding(std::string_view& text) {
  const std::size_t end = text.find_last_not_of(std::string_view("\0\x1a", 2)) + 1;
  const std::size_t taken = text.size() - end;
  text.remove_suffix(taken);
  return static_cast<std::int64_t>(taken);
}

std::string_view take_word(std::string_view& rest) {
  rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
  const std::string_view word = rest.substr(0, rest.find_first_of(kBlanks));
  rest.remove_prefix(word.size());
  return word;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

std::string quoted(std::string_view text) {
  constexpr std::size_t kShown = 32;
  std::string result = "\"";
  for (const char c : text.substr(0, kShown)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (text.size() > kShown ? "...\"" : "\"");
}

std::string counted(std::int64_t n, std::string_view noun) {
  std::string result = std::to_string(n) + ' ';
  result += noun;
  return n == 1 ? result : result + 's';
}

std::optional<double> parse_number(std::string_view word) {
  if (!word.empty() && word.front() == '+') {
    word.remove_prefix(1);
    if (!word.empty() && word.front() == '-') return std::nullopt;
  }
  const bool negative = !word.empty() && word.front() == '-';
  if (const auto value = parse_windows(word.substr(negative ? 1 : 0))) return negative ? -*value : *value;
  double value = 0;
  const char* end = word.data() + word.size();
  const auto result = fast_float::from_chars(word.data(), end, value);
  // A number out of range still gives the nearest value: an infinity, or zero.
  if (result.ec == std::errc::invalid_argument || result.ptr != end) return std::nullopt;
  return value;
}

std::optional<std::int64_t> parse_integer(std::string_view word) {
  if (!word.empty() && word.front() == '+') {
    word.remove_prefix(1);
    if (!word.empty() && word.front() == '-') return std::nullopt;
  }
  std::int64_t value = 0;
  const char* end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, value);
  if (result.ec != std::errc{} || result.ptr != end) return std::nullopt;
  return value;
}

tl::expected<double, std::string> parse_coordinate(std::string_view word, bool allow_not_finite) {
  const std::optional<double> value = parse_number(word);
  if (!value)
    return tl::unexpected(quoted(word) + " is not a number" +
                          (has_decimal_comma(word) ? ": write decimals with a point, not a comma" : ""));
  std::string_view fault = fault_of_coordinate(*value, allow_not_finite);
  // An infinity that was written in digits is a number that no double can represent.
  if (std::isinf(*value) && word.find('#') == std::string_view::npos &&
      word.find_first_of(kDigits) != std::string_view::npos)
    fault = fault_of_coordinate(std::numeric_limits<double>::max(), allow_not_finite);
  if (fault.empty()) return *value;
  return tl::unexpected(quoted(word).append(" ").append(fault));
}

std::string_view fault_of_coordinate(double value, bool allow_not_finite) {
  if (!std::isfinite(value)) return allow_not_finite ? "" : "is not a finite number";
  if (std::abs(value) > PointSet<double, 3>::kLargest) return "is too large: coordinates reach to 2^508, about 8.3e152";
  return {};
}

std::string shortest_text(double value) {
  std::array<char, 32> digits{};
  for (const char* format : {"%.15g", "%.16g", "%.17g"}) {
    std::snprintf(digits.data(), digits.size(), format, value);
    if (std::strtod(digits.data(), nullptr) == value) break;
  }
  return digits.data();
}

}  // namespace snug::io
