#include "lesson/own_points.hpp"

#include <algorithm>

#include "fit/catalogue.hpp"
#include "geometry/generate.hpp"

namespace snug::lesson {
const std::vector<std::string>& mesh_names() {
  static const std::vector<std::string> names{"bunny", "teapot", "dragon"};
  return names;
}

tl::expected<AnyPointSet, InputError> to_set(const std::vector<Vector<double, 3>>& points, int dim) {
  return io::to_point_set({dim, points, {}}, {}, 0, false);
}

tl::expected<AnyPointSet, InputError> own_points(const Lesson& lesson, std::uint64_t seed,
                                                 const std::optional<io::PointFile>& mesh) {
  if (lesson.boxes) return places(*lesson.boxes);
  const Points& points = lesson.points;
  if (!points.mesh.empty()) {
    if (!mesh) return tl::unexpected(InputError{.what = "the mesh " + points.mesh + " is not loaded"});
    return to_set(mesh->points, mesh->dim);
  }
  if (points.generate.empty()) return to_set(points.list, points.dim);
  const auto made = generate(points.generate, points.count, points.dim, seed);
  if (!made) return tl::unexpected(InputError{.what = "there is no generator " + points.generate});
  return to_set(*made, points.dim);
}

AnyPointSet start_of_task(const Lesson& lesson, const AnyPointSet& own) {
  const Index count = std::min(fit::size_of(own), Index{lesson.task->points});
  std::vector<Vector<double, 3>> points;
  for (Index i = 0; i < count; ++i) points.push_back(fit::point_of(own, i));
  return *to_set(points, fit::dim_of(own));  // of points that were accepted before
}

}  // namespace snug::lesson
