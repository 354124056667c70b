#include "lesson/subjects/pair/difference.hpp"

#include <algorithm>

#include "geometry/sort.hpp"
#include "query/distance/gjk_simplex.hpp"

namespace snug::lesson {
namespace {

/// Twice the signed area of a triangle: > 0 if it turns to the left.
double turn_of(const Point3& a, const Point3& b, const Point3& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// A half of the outline of points in the order of x. Its last point begins the other half.
void add_half(std::vector<DifferenceVertex>& outline, std::span<const DifferenceVertex> points) {
  const std::size_t first = outline.size();
  for (const DifferenceVertex& point : points) {
    while (outline.size() >= first + 2 && !(turn_of(outline[outline.size() - 2].at, outline.back().at, point.at) > 0))
      outline.pop_back();
    outline.push_back(point);
  }
  outline.pop_back();
}

}  // namespace

/// Source: A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979.
std::vector<DifferenceVertex> difference_outline(const VolumePair& pair) {
  const std::vector<Point3> a = core_of(pair.held[0]), b = core_of(pair.held[1]);
  std::vector<DifferenceVertex> all;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      all.push_back({static_cast<Index>(i), static_cast<Index>(j), a[i] - b[j]});
  if (all.size() < 2 || pair.dim != 2) return all.size() == 1 ? all : std::vector<DifferenceVertex>();
  sort_stably(all, [](const DifferenceVertex& p, const DifferenceVertex& q) {
    return p.at[0] != q.at[0] ? p.at[0] < q.at[0] : p.at[1] < q.at[1];
  });
  std::vector<DifferenceVertex> outline;
  add_half(outline, all);
  std::reverse(all.begin(), all.end());
  add_half(outline, all);
  return outline;
}

std::vector<Point3> difference_points(const VolumePair& pair, std::span<const Index> corners) {
  const std::vector<Point3> a = core_of(pair.held[0]), b = core_of(pair.held[1]);
  std::vector<Point3> points;
  for (std::size_t i = 0; i + 1 < corners.size(); i += 2) {
    if (corners[i] == kNoIndex || corners[i + 1] == kNoIndex) return {};
    points.push_back(a[corners[i]] - b[corners[i + 1]]);
  }
  return points;
}

Point3 nearest_of(std::span<const Point3> points) {
  query::Simplex<double> simplex;
  for (const Point3& p : points) simplex.corners[simplex.size++] = {p[0], p[1], p[2]};
  const auto nearest = simplex.nearest_to_origin().point;
  return {nearest[0], nearest[1], nearest[2]};
}

}  // namespace snug::lesson
