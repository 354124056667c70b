// The figures and the proof of a test of a box against a frustum.
#pragma once

#include <span>
#include <vector>

#include "lesson/subjects/frustum/frustum.hpp"

namespace snug::lesson {

/// The plane that the last of these steps is about: the one just tested, or the one that a verdict rests on; -1 for
/// none.
[[nodiscard]] int plane_at(FrustumSteps steps);

/// Keys: plane signs p_distance n_distance planes_tested corners verdict. Tests by vertices have no p_distance and
/// n_distance, but the vertex's distance.
[[nodiscard]] std::vector<Figure> frustum_figures(const View& view, const BoxPair& pair);

/// The proofs at the end of the run; none before.
[[nodiscard]] std::vector<Proof> frustum_proofs(const View& view, const BoxPair& pair);

}  // namespace snug::lesson
