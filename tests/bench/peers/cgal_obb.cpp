#define CGAL_EIGEN3_ENABLED
#include "bench/peers/cgal_obb.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/optimal_bounding_box.h>

#include <array>
#include <cmath>
#include <vector>

namespace snug::bench {

double cgal_obb_volume(PointSpan<double, 3> points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> theirs;
  for (const auto& p : points) theirs.emplace_back(p[0], p[1], p[2]);
  std::array<Kernel::Point_3, 8> corners;
  CGAL::oriented_bounding_box(theirs, corners, CGAL::parameters::use_convex_hull(true));
  const auto length = [&](std::size_t to) { return std::sqrt((corners[to] - corners[0]).squared_length()); };
  return length(1) * length(3) * length(5);
}

}  // namespace snug::bench
