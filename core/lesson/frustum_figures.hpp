// The figures and the proof of a test of a box against a frustum.
#pragma once

#include <span>
#include <vector>

#include "lesson/figures.hpp"

namespace snug::lesson {

/// The plane that the last of these steps speaks of: the one just tested, or the one that a verdict rests on. -1 where
/// it speaks of none.
[[nodiscard]] int plane_at(std::span<const Recorder<fit::Step3>::Entry> steps);

/// Keys: plane signs p_distance n_distance planes_tested corners verdict. Of tests by corners, p_distance and
/// n_distance are left out, and distance is the corner's. run: with a box and a frustum.
[[nodiscard]] std::vector<Figure> frustum_figures(const RunView& run);

/// In the end.
[[nodiscard]] std::vector<Proof> frustum_proofs(const RunView& run);

}  // namespace snug::lesson
