// A reader for each format. Their errors name no file: read_points adds the name.
#pragma once

#include <cstddef>
#include <limits>
#include <string_view>

#include "io/point_file.hpp"
#include "io/text.hpp"

namespace snug::io {

inline void pass_over(PointFile& file, Passed what, std::int64_t n = 1) {
  file.passed[static_cast<std::size_t>(what)] += n;
}

/// The most points that an Index can number.
inline constexpr std::size_t kMostPoints = std::numeric_limits<Index>::max();
inline constexpr std::string_view kTooManyPoints = "there are more than 2147483647 points";

/// Two or three numbers a line, and perhaps more columns, which are passed over; '#' and "//" start a comment, and the
/// first line may be a header. csv: a tab separates fields, as a comma or a semicolon does, so that an empty field is
/// noticed.
[[nodiscard]] Read<PointFile> read_rows(std::string_view text, bool csv, const Wanted& wanted);

/// Object File Format as text: vertices, then polygons. Source: Geomview manual, "OFF Files".
[[nodiscard]] Read<PointFile> read_off(std::string_view text, const Wanted& wanted);

/// Wavefront OBJ: the v lines are points, the f lines faces, everything else is ignored.
/// Source: Wavefront Technologies, "Advanced Visualizer Manual", appendix B1, 1993.
[[nodiscard]] Read<PointFile> read_obj(std::string_view text, const Wanted& wanted);
/// Whether the word begins a statement of OBJ ("v", "f", "usemtl" ...).
[[nodiscard]] bool is_obj_keyword(std::string_view word);

/// Stanford PLY: x, y and perhaps z of the element vertex are points, the element face has faces.
/// Source: G. Turk, "The PLY Polygon File Format", 1994.
[[nodiscard]] Read<PointFile> read_ply(std::string_view bytes, const Wanted& wanted);

/// Stereolithography, as text and as bytes. Source: 3D Systems, "StereoLithography Interface Specification", 1988.
[[nodiscard]] Read<PointFile> read_stl_text(std::string_view text, const Wanted& wanted);
[[nodiscard]] Read<PointFile> read_stl_binary(std::string_view bytes, const Wanted& wanted);
/// Whether the size is exactly what the header's count of triangles calls for.
[[nodiscard]] bool has_size_of_stl(std::string_view bytes);

}  // namespace snug::io
