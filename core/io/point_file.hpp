// Point files: xyz, csv, txt, OBJ, PLY and STL, from bytes to points, or one sentence that says where it went wrong.
#pragma once

#include <array>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/input_error.hpp"
#include "geometry/point_set.hpp"

namespace snug::io {

/// What a file holds. dim: 2 or 3; in 2-D every z is 0. At least one point, all finite.
struct PointFile {
  int dim = 3;
  std::vector<Vector<double, 3>> points;
  std::vector<std::array<Index, 3>> triangles;  // of a mesh, each index in range; empty where the file has no faces
};

/// Reads a whole file's bytes. name: the file's name, for its extension and for errors; the format is told apart by
/// content first and extension second. STL's repeated corners are merged where their bits are equal.
/// Errors: of form and of content, with line (text) or byte (binary). Memory stays within a few times the bytes given,
/// whatever a header claims.
[[nodiscard]] tl::expected<PointFile, InputError> read_points(std::string_view bytes, std::string_view name);

/// The points of a file as a set. dim: 2 or 3, or 0 for the file's own; 3 may be asked of a 2-D file (z = 0), 2 of a
/// 3-D file is refused. single: whether to round to float. Errors: as of PointSet::make, with the file's name.
[[nodiscard]] tl::expected<AnyPointSet, InputError> to_point_set(const PointFile& file, std::string_view name, int dim,
                                                                 bool single);

}  // namespace snug::io
