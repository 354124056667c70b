// The figures of the inspector and the lines of the proof, from a run and a place in its trace.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "fit/catalogue.hpp"
#include "lesson/boxes.hpp"

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

/// A run and how much of it has been shown.
struct RunView {
  const AnyPointSet* points = nullptr;
  const fit::Algorithm* algorithm = nullptr;
  const fit::Recording* recording = nullptr;
  int step = 0;
  std::optional<double> smallest;  // the optimum's size; none where it is not known
  const BoxPair* boxes = nullptr;  // where there are boxes in place of points
};

/// Keys: radius (of balls) or measure (of others) excess outside seen outside_by support pass best candidates mean_x
/// mean_y mean_z variance_1 … deviation_1 … (along the axis of greatest spread first), and the operations' names. All
/// are stable. The excess has no value while a point is outside: a ball that holds too little is no better than the
/// optimum.
[[nodiscard]] std::vector<Figure> figures_of(const RunView& run);

[[nodiscard]] std::vector<Proof> proofs_of(const RunView& run);

/// Four digits that count, at most three behind the point: "2.118", "21.18", "1.234 × 10¹⁰". The minus is a real one.
[[nodiscard]] std::string number_text(double value, int digits = 4);

/// Two numbers with as many digits, four or more, as tell them apart: "0.9921" and "0.9917". Nine do not tell apart
/// what differs by rounding alone: the texts are equal then.
[[nodiscard]] std::pair<std::string, std::string> number_texts_apart(double a, double b);

/// How much larger a size is than the smallest, 0.1 for 10 per cent: 0 where both are, none where nothing is known.
[[nodiscard]] std::optional<double> excess_of(double size, std::optional<double> smallest);

/// 0.091 as "+9.1 %".
[[nodiscard]] std::string percent_text(double ratio);

}  // namespace snug::lesson
