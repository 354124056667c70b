// Points as a lesson names them, made into a set.
#pragma once

#include <optional>
#include <vector>

#include "io/point_file.hpp"
#include "lesson/lesson.hpp"

namespace snug::lesson {

/// In double. dim: 2 (z is dropped) or 3. Errors: as of PointSet::make.
[[nodiscard]] tl::expected<AnyPointSet, InputError> to_set(const std::vector<Vector<double, 3>>& points, int dim);

/// The lesson's own points at a seed; of a mesh, the file's; of boxes, their places. Errors: as of PointSet::make and
/// of places; a mesh that is missing.
[[nodiscard]] tl::expected<AnyPointSet, InputError> own_points(const Lesson& lesson, std::uint64_t seed,
                                                               const std::optional<io::PointFile>& mesh);

/// The first of the lesson's own points, as many as its task is for (or all, where it has fewer).
[[nodiscard]] AnyPointSet start_of_task(const Lesson& lesson, const AnyPointSet& own);

/// How many points a set may be generated with.
inline constexpr int kMostGenerated = 100000;

}  // namespace snug::lesson
