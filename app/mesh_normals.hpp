// The normals of a mesh's vertices.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/vector.hpp"

namespace snug::app {

/// One unit normal for each vertex, weighted by area; zero if no triangle has the vertex.
[[nodiscard]] std::vector<Vector<float, 3>> mesh_normals(std::span<const Vector<float, 3>> points,
                                                         std::span<const std::array<Index, 3>> triangles);

}  // namespace snug::app
