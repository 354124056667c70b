// Whether a volume of any kind really shares a point with a frustum: what the plane test (classify.hpp) is measured by.
#pragma once

#include <optional>

#include "geometry/frustum.hpp"
#include "geometry/volume.hpp"

namespace snug::proximity {

/// Touching volumes share a point. Boxes and spheres are decided exactly on the numbers as they are; other kinds by two
/// bounds on their distance, so that the answer is never wrong. None where rounding leaves it open (a volume that
/// touches, within some roundings of the frustum's size), where the planes bound no frustum with vertices (corners_of),
/// and for an empty volume.
template <class Scalar, int Dim>
[[nodiscard]] std::optional<bool> meets(const Frustum<Scalar, Dim>& frustum, const Volume<Scalar, Dim>& volume);

}  // namespace snug::proximity
