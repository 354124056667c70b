// The figures and the proof of a test of two boxes.
#pragma once

#include <span>
#include <vector>

#include "lesson/figures.hpp"

namespace snug::lesson {

/// The axes that a trace has tested, in its order.
[[nodiscard]] std::vector<query::AxisTested<double, 3>> axes_seen(std::span<const Recorder<fit::Step3>::Entry> steps);

/// Keys: distance radius_a radius_b gap tests. run: with boxes.
[[nodiscard]] std::vector<Figure> box_figures(const RunView& run);

/// In the end.
[[nodiscard]] std::vector<Proof> box_proofs(const RunView& run);

}  // namespace snug::lesson
