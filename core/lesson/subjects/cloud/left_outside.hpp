// The points that a finished sphere leaves outside, judged in exact arithmetic on the numbers as they are.
#pragma once

#include <vector>

#include "lesson/subjects/cloud/fit_run.hpp"

namespace snug::lesson {

struct LeftOutside {
  std::vector<Index> points;
  // The point that lies farthest outside:
  Index worst = kNoIndex;
  double by = 0;  // scene units
  // An ulp, the distance to the next number, in the scalar of the points; scene units:
  double radius_ulp = 0;  // of the radius
  double size_ulp = 0;    // of the largest coordinate of the points
  [[nodiscard]] double ulps() const { return by / radius_ulp; }
};

/// How far a point lies outside, scene units; below 0 inside.
[[nodiscard]] double outside_by(const Point3& point, const fit::Sphere3& sphere);

[[nodiscard]] LeftOutside left_outside(const AnyPointSet& points, const fit::Sphere3& sphere);

/// "0.62 ulps", "1 ulp".
[[nodiscard]] std::string ulps_text(double ulps);

/// Adds the figures of a finished run: how many points it leaves outside, how far the worst one is, and its steps.
void add_left_outside(std::vector<Figure>& figures, const FitRun& run);

}  // namespace snug::lesson
