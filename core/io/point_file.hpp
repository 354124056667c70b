// Reads point files: xyz, csv, txt, OBJ, PLY, STL and OFF. An error is one sentence that says what is wrong and where.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/input_error.hpp"
#include "geometry/point_set.hpp"

namespace snug::io {

/// What a reader may pass over. Everything else that it does not understand is an error.
enum class Passed : std::uint8_t { kNan, kColumns, kHeader, kStatements, kFaces, kDamaged, kLines, kBytes, kEnd };
using PassedOver = std::array<std::int64_t, 9>;  // how many of each

/// "passed over: 2 damaged faces, 1 face of fewer than three vertices"; empty if nothing was.
[[nodiscard]] std::string passed_text(const PassedOver& passed);

/// The contents of a file: at least one point, all finite. dim: 2 or 3; in 2-D every z is 0.
struct PointFile {
  int dim = 3;
  std::vector<Vector<double, 3>> points;
  // A mesh has faces, each index in range. There are none if the file has none, or if nobody wants them.
  std::vector<std::array<Index, 3>> triangles;
  PassedOver passed = {};
};

/// What is wanted of a file.
struct Wanted {
  bool skip_nan = false;  // whether points that are not finite, and their faces, are passed over; else they are errors
  bool faces = true;      // whether the faces too; else a damaged one is passed over, which otherwise is an error
};

/// Whether a file's extension, in lower case, is one of the formats'.
[[nodiscard]] bool is_point_extension(std::string_view extension);

/// Reads a whole file's bytes. name: the file's name, for its extension and for errors; the format is recognized by
/// content first and extension second. STL's repeated corners are merged where their bits are equal.
/// Errors in form or content, with the line (text) or byte (binary). Memory stays within a few times the bytes given,
/// whatever a header claims.
[[nodiscard]] tl::expected<PointFile, InputError> read_points(std::string_view bytes, std::string_view name,
                                                              const Wanted& wanted = {});

/// The points of a file as a set. dim: 2 or 3, or 0 for the file's own; a 2-D file may be read as 3-D (z = 0), but not
/// a 3-D file as 2-D. single: whether to round to float. Errors: as of PointSet::make, with the file's name.
[[nodiscard]] tl::expected<AnyPointSet, InputError> to_point_set(const PointFile& file, std::string_view name, int dim,
                                                                 bool single);

}  // namespace snug::io
