// The figures of the inspector and the lines of the proof, and how numbers are written.
#pragma once

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

/// A line of the proof: what is claimed of the ball, and whether it holds.
struct Proof {
  std::string text;  // "holds all 26 points, exactly"
  bool holds = false;
  bool claimed = false;  // whether the algorithm claims it; where it does not, holds says nothing against it
};

/// Four digits that count, at most three behind the point: "2.118", "21.18", "1.234 × 10¹⁰". The minus is a real one.
[[nodiscard]] std::string number_text(double value, int digits = 4);

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

/// A length beside another one, as short as it still says something: "0.58", "0.0042", "123.4".
[[nodiscard]] std::string short_figure(double value);

}  // namespace snug::lesson
