#include "fit/obb_hull.hpp"

namespace snug::fit {

RectangleFrame<3> rectangle_along(const Vector<double, 3>& direction, const std::vector<Vector<double, 3>>& points) {
  const Matrix<double, 3> across = frame(direction, Vector<double, 3>::Zero());
  std::vector<Vector<double, 2>> cast;
  cast.reserve(points.size());
  for (const auto& p : points) cast.emplace_back(across.col(1).dot(p), across.col(2).dot(p));
  Ignore ignore;
  const RectangleFrame<2> found = smallest_rectangle(quickhull_2d<double>(std::span<const Vector<double, 2>>(cast)), ignore);
  const Vector<double, 2> side = found.axes.col(0);
  return {frame(across.col(0), across.col(1) * side[0] + across.col(2) * side[1]), found.edge_a, found.edge_b};
}

}  // namespace snug::fit
