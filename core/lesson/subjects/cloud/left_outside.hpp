// The points that a finished sphere, or a hull in the plane, leaves outside, judged in exact arithmetic on the numbers
// as they are.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/subjects/cloud/fit_run.hpp"

namespace snug::lesson {

struct LeftOutside {
  std::vector<Index> points;
  // The point that lies farthest outside:
  Index worst = kNoIndex;
  double by = 0;  // scene units
  // An ulp, the distance to the next number, in the scalar of the points; scene units:
  double radius_ulp = 0;          // of the radius, none of a radius of 0; of a hull the same as the next
  double size_ulp = 0;            // of the largest coordinate of the points
  double extent = 0;              // the radius, or half of a hull's width; scene units
  std::vector<Index> dents = {};  // of a hull: the vertices at which its outline turns inward
  [[nodiscard]] bool none() const { return points.empty() && dents.empty(); }
  /// Infinite where a radius of 0 has no ulp.
  [[nodiscard]] double ulps() const { return by > 0 ? by / radius_ulp : 0; }
};

/// An ulp of a size in the scalar of the points, scene units.
[[nodiscard]] double ulp_of(const AnyPointSet& points, double size);

/// How far a point lies outside, scene units; below 0 inside.
[[nodiscard]] double outside_by(const Point3& point, const fit::Sphere3& sphere);

[[nodiscard]] LeftOutside left_outside(const AnyPointSet& points, const fit::Sphere3& sphere);
/// support: the ring of its vertices, as the fit gives it.
[[nodiscard]] LeftOutside left_outside_hull(const AnyPointSet& points, std::span<const Index> support);
/// For a sphere or a hull in the plane; none for any other volume.
[[nodiscard]] std::optional<LeftOutside> left_by(const AnyPointSet& points, const fit::Result& result);

/// "0.62 ulps", "1 ulp".
[[nodiscard]] std::string ulps_text(double ulps);

/// How far the worst point is outside: "0.62 ulps of the radius"; in units where the radius has no ulp.
/// of: what an ulp is of.
[[nodiscard]] std::string worst_text(const LeftOutside& left, std::string_view of);

/// What an ulp is of: " of the radius", " of the coordinates".
[[nodiscard]] const char* of_ulps(const fit::Result& result);

/// Adds the figures of a finished run: how many points it leaves outside, how far the worst one is, and its steps.
void add_left_outside(std::vector<Figure>& figures, const FitRun& run);

}  // namespace snug::lesson
