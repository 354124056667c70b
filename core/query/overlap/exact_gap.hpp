// How far apart two boxes are along one axis of the separating-axis test, in exact arithmetic: what the row of a table
// really says, however the test that filled it in rounds.
#pragma once

#include "geometry/obb.hpp"

namespace snug::query {

/// The gap along an axis by its index in the table, scene units; below 0 where the projections overlap. Its sign is
/// exact on the numbers as they are, its size within rounding; 0 if they touch, or if the edges are exactly parallel,
/// so that there is no such axis. a, b: as for separating_exactly (obb_sat_exact.hpp).
template <class Scalar, int Dim>
[[nodiscard]] double exact_gap(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b, int place);

/// Whether two boxes share points, and some move, however short, parts them: no gap is above 0, and one is exactly 0.
/// a, b: as for separating_exactly.
template <class Scalar, int Dim>
[[nodiscard]] bool touch_exactly(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b);

}  // namespace snug::query
