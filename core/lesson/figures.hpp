// The figures of the inspector and the lines of the proof, and how numbers are written.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace snug::lesson {

/// What the inspector shows, by name, in its order; values as text with their unit.
struct Figure {
  std::string name;  // "Radius so far"
  std::string key;   // "radius": the name in window.snug.state().readout
  std::string text;  // "2.118 units"
  double value = 0;
  std::string unit;   // "units", "%", "points"; empty for a count
  bool known = true;  // false: there is no value to speak of yet, and the text is a dash; readouts leave it out
};

/// A line of the proof: what is claimed of the volume, and whether it holds.
struct Proof {
  std::string text;  // "contains all 26 points, exactly"
  bool holds = false;
  bool claimed = false;  // whether the algorithm claims it; where it does not, holds says nothing against it
};

/// Four significant digits, at most three decimals but where a small number would have fewer than two digits left:
/// "2.118", "21.18", "0.042", "0.0042", "1.234 × 10¹⁰". The minus is a real one.
[[nodiscard]] std::string number_text(double value, int digits = 4);

/// A count, n >= 0, with its thousands apart: "475", "1,839".
[[nodiscard]] std::string count_text(std::int64_t n);

/// The number of digits, four or more, that tells two numbers apart. Nine do not tell apart what differs by rounding
/// alone: four then.
[[nodiscard]] int digits_apart(double a, double b);

/// Two numbers with as many digits, four or more, as tell them apart: "0.9921" and "0.9917". Nine do not tell apart
/// what differs by rounding alone: the texts are equal then.
[[nodiscard]] std::pair<std::string, std::string> number_texts_apart(double a, double b);

/// How much larger a size is than the smallest, 0.1 for 10 per cent: 0 where both are, none where nothing is known.
[[nodiscard]] std::optional<double> excess_of(double size, std::optional<double> smallest);

/// 0.091 as "+9.1 %".
[[nodiscard]] std::string percent_text(double ratio);

/// The same of a volume that is much larger than the tightest: "+35.0 %", "+385 %", "+1,885 %".
[[nodiscard]] std::string looseness_text(double ratio);

}  // namespace snug::lesson
