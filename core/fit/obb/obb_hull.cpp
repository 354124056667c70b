#include "fit/obb/obb_hull.hpp"

namespace snug::fit {

template <class Count>
RectangleFrame<3> rectangle_along(const Vector<double, 3>& direction, const std::vector<Vector<double, 3>>& points,
                                  Count& count) {
  const Matrix<double, 3> across = frame(direction, Vector<double, 3>::Zero());
  std::vector<Vector<double, 2>> cast;
  cast.reserve(points.size());
  for (const auto& p : points) cast.emplace_back(across.col(1).dot(p), across.col(2).dot(p));
  const auto n = static_cast<std::int64_t>(points.size());
  count.count(Operation::kPointsTouched, n);
  count.count(Operation::kDotProducts, 2 * n);
  const RectangleFrame<2> found =
      smallest_rectangle(quickhull_2d<double>(std::span<const Vector<double, 2>>(cast), count), count);
  const Vector<double, 2> side = found.axes.col(0);
  return {frame(across.col(0), across.col(1) * side[0] + across.col(2) * side[1]), found.edge_a, found.edge_b};
}

template RectangleFrame<3> rectangle_along(const Vector<double, 3>&, const std::vector<Vector<double, 3>>&, Ignore&);
template RectangleFrame<3> rectangle_along(const Vector<double, 3>&, const std::vector<Vector<double, 3>>&, Tally&);

}  // namespace snug::fit
