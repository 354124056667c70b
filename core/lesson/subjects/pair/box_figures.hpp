// The figures and the proof of a test of two boxes.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lesson/subjects/pair/pair.hpp"

namespace snug::lesson {

/// The axes that a trace has tested, in its order.
[[nodiscard]] std::vector<query::AxisTested<double, 3>> axes_seen(PairSteps steps);

/// The axis that the last of these steps is about: the one just tested, or the one that a verdict rests on. None if
/// there is no such axis, for example when boxes overlap and the test ends at the first gap.
[[nodiscard]] std::optional<query::AxisTested<double, 3>> axis_at(PairSteps steps);

/// Keys: axis distance radius_a radius_b gap tests, in space length, and of a naive test exact_gap and wrong_rows. All
/// but tests and wrong_rows are about one axis, axis_at.
[[nodiscard]] std::vector<Figure> box_figures(const View& view, const BoxPair& pair);

/// Whether a figure with this key stands in the table's row of its axis.
[[nodiscard]] bool is_along_axis(std::string_view key);

/// The proofs at the end of the run; none before.
[[nodiscard]] std::vector<Proof> box_proofs(const View& view, const BoxPair& pair);

}  // namespace snug::lesson
