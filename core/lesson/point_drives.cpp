// What sliders drive of points.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/generate.hpp"
#include "geometry/random.hpp"
#include "geometry/turn.hpp"
#include "lesson/point_subject.hpp"

namespace snug::lesson {
namespace {

Point3 centroid_of(const std::vector<Point3>& points) {
  Point3 sum = Point3::Zero();
  for (const Point3& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

/// A unit direction along no axis and no diagonal, so that the coordinates round differently.
Point3 slanting(int dim) { return dim == 2 ? Point3(0.8, 0.6, 0) : Point3(0.6, 0.48, 0.64); }

void jitter(std::vector<Point3>& points, int dim, std::uint64_t seed, double by) {
  Random random(seed);
  for (Point3& point : points)
    for (int axis = 0; axis < dim; ++axis) point[axis] += by * random.between(-1, 1);
}

/// Scales the points' offsets from a line through the middle; what lies along it stays.
void squeeze(std::vector<Point3>& points, const Point3& middle, const Point3& along, double times) {
  for (Point3& point : points) {
    const Point3 on_line = middle + along * along.dot(point - middle);
    point = on_line + (point - on_line) * times;
  }
}

}  // namespace

std::vector<Drive> PointSubject::drives() const {
  std::vector<Drive> all{{.name = "offset"},
                         {.name = "jitter"},
                         {.name = "scale", .unit = "times", .rest = 1},
                         {.name = "squeeze", .unit = "times", .rest = 1},
                         {.name = "angle", .unit = "degrees"}};
  if (origin_.generated > 0)
    all.push_back({.name = "count", .unit = handle_words()[1], .now = static_cast<double>(count()), .whole = true});
  return all;
}

Done PointSubject::drive(std::string_view name, double from, double to) {
  if (name == "count" && origin_.generated > 0) return drive_count(to);
  std::vector<Point3> points = all_points(unrounded_);
  const Point3 middle = centroid_of(points);
  if (name == "offset") {
    for (Point3& point : points) point += slanting(dim()) * (to - from);
  } else if (name == "jitter") {
    jitter(points, dim(), origin_.seed, to - from);
  } else if (name == "scale") {
    if (!(from > 0 && to > 0)) return tl::unexpected(InputError{.what = "a scale must be above 0"});
    for (Point3& point : points) point = middle + (point - middle) * (to / from);
  } else if (name == "squeeze") {
    if (!(from > 0 && to > 0)) return tl::unexpected(InputError{.what = "a squeeze must be above 0"});
    squeeze(points, middle, slanting(dim()), to / from);
  } else if (name == "angle") {
    const Matrix<double, 3> rotation = snug::turn(Point3::UnitZ(), (to - from) * std::numbers::pi / 180);
    for (Point3& point : points) point = middle + rotation * (point - middle);
  } else {
    return Subject::drive(name, from, to);
  }
  return take(points, dim(), triangles_);
}

/// Fewer points are the first of these; more are these and the last of as many generated ones.
Done PointSubject::drive_count(double to) {
  if (!(to >= 1 && to <= kMostGenerated))
    return tl::unexpected(InputError{.what = "a set must have 1 to " + std::to_string(kMostGenerated) + " points"});
  const auto count = static_cast<std::size_t>(std::llround(to));
  std::vector<Point3> points = all_points(unrounded_);
  if (count > points.size()) {
    const auto more = *generate(origin_.source, static_cast<int>(count), dim(), origin_.seed);
    points.insert(points.end(), more.begin() + static_cast<std::ptrdiff_t>(points.size()), more.end());
  }
  points.resize(count);
  return take(points, dim(), nullptr);
}

}  // namespace snug::lesson
