// Tells touching from overlapping, where that can be decided without rounding.
#pragma once

#include <optional>

#include "geometry/volume.hpp"

namespace snug::query {

/// Whether two volumes share points, but an arbitrarily short move can part them. Exact on the numbers as they are.
/// None for pairs that only rounded arithmetic decides: those with a volume other than a sphere, an AABB or an OBB; a
/// sphere with an OBB; an OBB with an AABB whose centre rounds.
template <class Scalar, int Dim>
[[nodiscard]] std::optional<bool> touch(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b);

}  // namespace snug::query
