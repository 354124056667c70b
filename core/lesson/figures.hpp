// The figures of the inspector, the lines of the proof, and how numbers are formatted.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace snug::lesson {

/// A row of the inspector, with its value as text and unit.
struct Figure {
  std::string name;  // "Radius so far"
  std::string key;   // "radius": the name in window.snug.state().readout
  std::string text;  // "2.118 units"
  double value = 0;
  std::string unit;      // "units", "%", "points"; empty for a count
  bool known = true;     // false: there is no value yet, the text is a dash, and readouts leave it out
  bool of_step = false;  // whether it is the step's own: other steps do not tell it
  std::span<const std::string_view> names{};  // what the values 0, 1, 2 … are called; empty for a number
};

/// A line of the proof: a statement about the volume, and whether it is true.
struct Proof {
  std::string text;  // "contains all 26 points, exactly"
  bool holds = false;
  bool claimed = false;  // whether the algorithm guarantees it; if not, a false `holds` is no fault
};

/// Four significant digits and at most three decimals, or more if a small number would have fewer than two digits left:
/// "2.118", "21.18", "0.042", "0.0042", "2,118", "1.234 × 10¹⁰". The minus sign is U+2212.
inline constexpr int kUsualDigits = 4;
[[nodiscard]] std::string number_text(double value, int digits = kUsualDigits);

/// The same without commas between thousands, for coordinates, between which commas stand: "2118".
[[nodiscard]] std::string coordinate_text(double value);

/// A whole number as superscripts: "⁻⁴⁸".
[[nodiscard]] std::string raised(int n);

/// While one exists, number_text gives numbers so many decimals, unless it is asked for other digits: those that a
/// lesson's file wishes for (StageView::decimals). A number that is not 0 is never written as 0.
class WithDecimals {
 public:
  explicit WithDecimals(std::optional<int> decimals);
  ~WithDecimals();
  WithDecimals(const WithDecimals&) = delete;
  WithDecimals& operator=(const WithDecimals&) = delete;

 private:
  std::optional<int> before_;
};

/// A number as a person writes it: "10", "0.5", "1,200".
[[nodiscard]] std::string plain_number(double value);

/// A number with its unit, which is named in the plural: "1 point", "1 vertex", "3 points"; without a unit, the number.
[[nodiscard]] std::string with_unit(double value, std::string_view units);

/// A count, n >= 0, with thousands separators: "475", "1,839".
[[nodiscard]] std::string count_text(std::int64_t n);

/// The number of digits, at least four, with which two numbers differ. Four, if they are equal in nine digits: then
/// they differ only by rounding.
[[nodiscard]] int digits_apart(double a, double b);

/// Two numbers with as many digits, at least four, as make them differ: "0.9921" and "0.9917". If they differ only by
/// rounding, the texts are equal.
[[nodiscard]] std::pair<std::string, std::string> number_texts_apart(double a, double b);

/// A number with so many decimals: "0.30", "−1.0", "1,234.5". Zero has no minus sign.
[[nodiscard]] std::string decimal_text(double value, int decimals);

/// How many decimals show a gap with two digits; 0 if that are more than fit beside each other.
[[nodiscard]] int decimals_showing(double gap);

/// A length as number_text writes it, or with so many decimals if those are more.
[[nodiscard]] std::string length_text(double value, int decimals);

/// A gap, with two digits if it is small: "0.123", "0.0034", "0.00034".
[[nodiscard]] std::string gap_text(double gap);

/// How much larger a size is than the smallest, 0.1 for 10 per cent: 0 if both are 0; none if unknown or infinite.
[[nodiscard]] std::optional<double> excess_of(double size, std::optional<double> smallest);

/// 0.091 as "+9.1 %".
[[nodiscard]] std::string percent_text(double ratio);

/// A figure's text without a plus sign: "9.1 %".
[[nodiscard]] std::string without_plus(std::string text);

/// The same for looseness, which can be large: "+35.0 %", "+385 %", "+1,885 %".
[[nodiscard]] std::string looseness_text(double ratio);

}  // namespace snug::lesson
