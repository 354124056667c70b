#include "lesson/figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace snug::lesson {
namespace {

constexpr int kMostDecimals = 5;    // of lengths around a gap
constexpr double kTwoDigits = 9.5;  // of the last decimal: so much is rounded to 10

std::string printed(const char* format, int precision, double value) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, precision, value);
  return buffer.data();
}

/// "1.500e-09" as "1.500 × 10⁻⁹".
std::string power_of_ten(const std::string& printed) {
  const auto e = printed.find('e');
  return printed.substr(0, e) + " × 10" + raised(std::atoi(printed.c_str() + e + 1));
}

/// Puts commas between the thousands of the whole part: "12,345.6".
std::string with_commas(std::string digits) {
  for (std::size_t at = std::min(digits.find('.'), digits.size()); at > 3;) digits.insert(at -= 3, ",");
  return digits;
}

std::optional<int> wished_decimals;  // by the innermost WithDecimals

/// The size with the decimals that are wished for; empty if it cannot be written so.
std::string with_wished_decimals(double size) {
  if (!wished_decimals || size >= 1e6) return {};
  std::string text = printed("%.*f", *wished_decimals, size);
  const bool zero = text.find_first_not_of("0.") == std::string::npos;
  return zero && size > 0 ? std::string() : with_commas(std::move(text));
}

std::string with_digits(double size, int digits) {
  if (size == 0) return "0.000";
  if (size < 1e-3 || size >= 1e6) return power_of_ten(printed("%.*e", digits - 1, size));
  const int before = static_cast<int>(std::floor(std::log10(size)));  // below 0 for numbers below 1
  const int decimals = std::max(0, before >= 0 ? digits - 1 - before : std::max(digits - 1, 1 - before));
  return with_commas(printed("%.*f", decimals, size));
}

}  // namespace

std::string raised(int n) {
  constexpr std::array<std::string_view, 10> kDigits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = n < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(n))) text += kDigits[digit - '0'];
  return text;
}

WithDecimals::WithDecimals(std::optional<int> decimals) : before_(wished_decimals) { wished_decimals = decimals; }
WithDecimals::~WithDecimals() { wished_decimals = before_; }

std::string number_text(double value, int digits) {
  const double size = std::abs(value);
  std::string text = digits == kUsualDigits ? with_wished_decimals(size) : std::string();
  if (text.empty()) text = with_digits(size, digits);
  return value < 0 ? std::string("−").append(text) : text;
}

std::string coordinate_text(double value) {
  std::string text = number_text(value);
  std::erase(text, ',');
  return text;
}

std::string count_text(std::int64_t n) { return with_commas(std::to_string(n)); }

int digits_apart(double a, double b) {
  constexpr int kMostDigits = 9;
  for (int digits = kUsualDigits; digits <= kMostDigits; ++digits)
    if (number_text(a, digits) != number_text(b, digits)) return digits;
  return kUsualDigits;
}

std::pair<std::string, std::string> number_texts_apart(double a, double b) {
  const int digits = digits_apart(a, b);
  return {number_text(a, digits), number_text(b, digits)};
}

std::string decimal_text(double value, int decimals) {
  const std::string text = with_commas(printed("%.*f", decimals, std::abs(value)));
  return (value < 0 && text.find_first_not_of("0.") != std::string::npos ? "−" : "") + text;
}

int decimals_showing(double gap) {
  for (int decimals = 0; decimals <= kMostDecimals; ++decimals)
    if (std::abs(gap) * std::pow(10, decimals) >= kTwoDigits) return decimals;
  return 0;
}

std::string length_text(double value, int decimals) {
  std::string usual = number_text(value);
  const auto dot = usual.find('.');
  const bool enough = dot != std::string::npos && usual.size() - dot - 1 >= static_cast<std::size_t>(decimals);
  return enough || decimals == 0 || usual.find("×") != std::string::npos ? usual : decimal_text(value, decimals);
}

std::string gap_text(double gap) {
  const int decimals = std::abs(gap) < 1e-3 ? decimals_showing(gap) : 0;
  return decimals > 0 ? decimal_text(gap, decimals) : number_text(gap);
}

std::optional<double> excess_of(double size, std::optional<double> smallest) {
  if (!smallest) return std::nullopt;
  if (*smallest > 0) return size / *smallest - 1;
  return size > 0 ? std::nullopt : std::optional(0.0);
}

std::string percent_text(double ratio) {
  const std::string text = with_commas(printed("%.*f", 1, std::abs(100 * ratio)));
  return (text == "0.0" ? "" : ratio < 0 ? "−" : "+") + text + " %";
}

std::string without_plus(std::string text) {
  if (text.starts_with('+')) text.erase(0, 1);
  return text;
}

std::string plain_number(double value) {
  if (value == std::floor(value) && std::abs(value) < 1e12)
    return (value < 0 ? "−" : "") + count_text(std::llround(std::abs(value)));
  std::string text = number_text(value);
  const std::size_t end = std::min(text.find(" ×"), text.size());  // of the digits, before a power of ten
  if (text.find('.') >= end) return text;
  std::size_t last = text.find_last_not_of('0', end - 1);
  if (text[last] == '.') --last;
  text.erase(last + 1, end - last - 1);
  constexpr std::string_view kOneTimes = "1 × ";
  const std::size_t sign = value < 0 ? std::string_view("−").size() : 0;
  if (std::string_view(text).substr(sign).starts_with(kOneTimes)) text.erase(sign, kOneTimes.size());
  return text;
}

std::string with_unit(double value, std::string_view units) {
  using Ending = std::pair<std::string_view, std::string_view>;
  constexpr std::array kOfOne{
      Ending{"vertices", "vertex"}, Ending{"axes", "axis"}, Ending{"bodies", "body"}, Ending{"xes", "x"},
      Ending{"sses", "ss"},         Ending{"s", ""},        Ending{"s²", "²"},        Ending{"s³", "³"}};
  std::string unit(units);
  const auto fits = [&](const Ending& ending) { return std::abs(value) == 1 && unit.ends_with(ending.first); };
  if (const auto found = std::find_if(kOfOne.begin(), kOfOne.end(), fits); found != kOfOne.end())
    unit.replace(unit.size() - found->first.size(), std::string::npos, found->second);
  return plain_number(value) + (unit.empty() ? "" : " " + unit);
}

std::string looseness_text(double ratio) {
  constexpr double kLarge = 1, kMost = 1e12;  // above the first, tenths mean nothing; the second is the largest count
  if (!(ratio >= kLarge)) return percent_text(ratio);
  return ratio > kMost ? "+" + number_text(100 * ratio) + " %" : "+" + count_text(std::llround(100 * ratio)) + " %";
}

}  // namespace snug::lesson
