// Directions that a mesh's vertices face.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/vector.hpp"

namespace snug::app {

/// Area-weighted and of unit length, one per vertex; zero where no triangle says anything.
[[nodiscard]] std::vector<Vector<float, 3>> mesh_normals(std::span<const Vector<float, 3>> points,
                                                         std::span<const std::array<Index, 3>> triangles);

}  // namespace snug::app
