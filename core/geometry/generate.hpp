// Point sets by kind and seed, the same everywhere.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/vector.hpp"

namespace snug {

/// The kinds' names.
[[nodiscard]] std::span<const std::string_view> generator_kinds();

/// n points of a kind, of about unit size around the origin; in 2-D z is 0. Empty if the kind is unknown or n < 1.
/// cube: uniform in [-1, 1]^dim. ball: uniform in the unit ball. sphere: on its surface. gaussian: variance 1/4 in each
/// coordinate. stick: gaussian, ten times longer along a tilted axis. clusters: a large and two small far ones.
/// lattice: integer coordinates, scaled. line: on a tilted line. blocks: a node of each 3 x 3 block of a grid, whose
/// step is a power of two.
[[nodiscard]] std::optional<std::vector<Vector<double, 3>>> generate(std::string_view kind, int n, int dim,
                                                                     std::uint64_t seed);

/// Generates one point after the other.
using PointStream = std::function<Vector<double, 3>()>;
/// The points of generate, for callers that cannot wait for all of them.
[[nodiscard]] std::optional<PointStream> generate_stream(std::string_view kind, int n, int dim, std::uint64_t seed);

}  // namespace snug
