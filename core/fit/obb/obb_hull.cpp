#include "fit/obb/obb_hull.hpp"

namespace snug::fit {

namespace {

/// The points' projection along a direction: its hull, and the axes that it was taken on.
struct Projected {
  Matrix<double, 3> across;
  ConvexHull<double, 2> hull;

  template <class Count>
  Projected(const Vector<double, 3>& direction, const std::vector<Vector<double, 3>>& points, Count& count)
      : across(frame(direction, Vector<double, 3>::Zero())) {
    std::vector<Vector<double, 2>> cast;
    cast.reserve(points.size());
    for (const auto& p : points) cast.emplace_back(across.col(1).dot(p), across.col(2).dot(p));
    const auto n = static_cast<std::int64_t>(points.size());
    count.count(Operation::kPointsTouched, n);
    count.count(Operation::kDotProducts, 2 * n);
    hull = quickhull_2d<double>(std::span<const Vector<double, 2>>(cast), count);
  }

  /// A rectangle of the plane, in space.
  [[nodiscard]] RectangleFrame<3> lifted(const RectangleFrame<2>& found) const {
    const Vector<double, 2> side = found.axes.col(0);
    return {frame(across.col(0), across.col(1) * side[0] + across.col(2) * side[1]), found.edge_a, found.edge_b};
  }
};

/// Counts, and keeps what the calipers report.
struct CalipersWatcher : PartCounter {
  std::vector<BoxTried<double, 2>> tried;
  void operator()(const ObbStep<double, 2>& step) { tried.push_back(*std::get_if<BoxTried<double, 2>>(&step.fact)); }
};

/// The longest vector that `of` gives for a vertex.
template <class Of>
Vector<double, 3> longest(const std::vector<Vector<double, 3>>& vertices, Of&& of) {
  Vector<double, 3> best = Vector<double, 3>::Zero();
  for (const auto& vertex : vertices)
    if (const Vector<double, 3> v = of(vertex); v.squaredNorm() > best.squaredNorm()) best = v;
  return best;
}

}  // namespace

template <class Count>
Vector<double, 3> flat_normal(const std::vector<Vector<double, 3>>& vertices, Count& count) {
  using Vertex = Vector<double, 3>;
  const auto from_first = [&](const Vertex& vertex) -> Vertex { return vertex - vertices.front(); };
  const Vertex along = unit<3>(longest(vertices, from_first));
  const Vertex across = longest(vertices, [&](const Vertex& vertex) -> Vertex {
    const Vertex to = from_first(vertex);
    return to - along.dot(to) * along;
  });
  const auto n = static_cast<std::int64_t>(vertices.size());
  count.count(Operation::kPointsTouched, 2 * n);
  count.count(Operation::kDistanceTests, 2 * n);
  count.count(Operation::kDotProducts, n);
  count.count(Operation::kSquareRoots, 1);
  return along.cross(across);
}

template Vector<double, 3> flat_normal(const std::vector<Vector<double, 3>>&, Ignore&);
template Vector<double, 3> flat_normal(const std::vector<Vector<double, 3>>&, PartCounter&);

template <class Count>
RectangleFrame<3> rectangle_along(const Vector<double, 3>& direction, const std::vector<Vector<double, 3>>& points,
                                  Count& count) {
  const Projected projected(direction, points, count);
  return projected.lifted(smallest_rectangle(projected.hull, count));
}

template RectangleFrame<3> rectangle_along(const Vector<double, 3>&, const std::vector<Vector<double, 3>>&, Ignore&);
template RectangleFrame<3> rectangle_along(const Vector<double, 3>&, const std::vector<Vector<double, 3>>&,
                                           PartCounter&);

RectangleFrame<3> rectangle_along(const Vector<double, 3>& direction, const std::vector<Vector<double, 3>>& points,
                                  PartCounter& count, std::vector<CalipersTurn>& turns) {
  const Projected projected(direction, points, count);
  CalipersWatcher watcher;
  const RectangleFrame<2> found = smallest_rectangle(projected.hull, watcher);
  hand_on(watcher, count);
  for (BoxTried<double, 2>& one : watcher.tried)
    turns.push_back({projected.lifted({one.box.axes, one.on[0], one.on[1]}), std::move(one.on), one.better});
  return projected.lifted(found);
}

}  // namespace snug::fit
