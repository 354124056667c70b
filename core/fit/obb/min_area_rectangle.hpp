// The rectangle of least area around a convex polygon, by rotating calipers.
// Source: H. Freeman, R. Shapira, "Determining the minimum-area encasing rectangle for an arbitrary closed curve",
// 1975, for the theorem that one of its sides lies on an edge of the hull; G. T. Toussaint, "Solving geometric problems
// with the rotating calipers", 1983, for trying all edges in one turn around the hull.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fit/obb/obb_frame.hpp"
#include "fit/obb/obb_from_axes.hpp"
#include "geometry/hull.hpp"
#include "geometry/orientation.hpp"
#include "number/double_double.hpp"
#include "number/power_of_two.hpp"

namespace snug::fit {

/// The rectangle on the hull's edge that starts at vertices[on], and the vertices that its other sides touch.
struct CalipersRectangle {
  Index on = 0, right = 0, top = 0, left = 0;  // places in the hull's vertices
  // The distances of the sides from vertices[on], along the edge (back: <= 0) and across it, and the area. The unit is
  // a power of two, about as large as the hull.
  double back = 0, forth = 0, height = 0;
  double area = 0;
};

/// The calipers' turn around a hull of affine_dim 2. The touched vertices are found by exact tests. The sides' lengths
/// have twice a double's digits while differences are taken, so that slivers are ranked correctly too.
template <class Scalar, class Observer>
class Calipers {
 public:
  Calipers(const ConvexHull<Scalar, 2>& hull, Observer& observe) : hull_(hull), observe_(observe) {
    double widest = 0;
    for (Index i = 1; i < size(); ++i) widest = std::max(widest, (point(i) - point(0)).cwiseAbs().maxCoeff());
    unit_ = exponent_of(widest);
  }

  /// The rectangle of least area; of several, the first.
  CalipersRectangle run() {
    CalipersRectangle best, at;
    for (at.on = 0; at.on < size(); ++at.on) {
      turn(at);
      measure(at);
      const bool better = at.on == 0 || at.area < best.area;
      if (better) best = at;
      if constexpr (kWatched<Observer>) tell(at, best, better);
    }
    return best;
  }

  /// The unit of the lengths in a CalipersRectangle: 2 to this power, scene units.
  [[nodiscard]] int unit() const { return unit_; }

  /// The rectangle's axes, the first along the edge.
  [[nodiscard]] Matrix<double, 2> axes(const CalipersRectangle& at) const {
    return frame(Vector<double, 2>(point(at.on + 1) - point(at.on)));
  }

 private:
  using Point = Vector<double, 2>;
  using Wide = std::array<DoubleDouble, 2>;

  [[nodiscard]] Index size() const { return static_cast<Index>(hull_.vertices.size()); }
  [[nodiscard]] Index around(Index i) const { return i < size() ? i : i - size(); }
  [[nodiscard]] Point point(Index i) const { return hull_.vertices[around(i)].template cast<double>(); }

  /// Moves each touched vertex on from where it was (at first, from where the previous one is); none ever moves back.
  void turn(CalipersRectangle& at) {
    const Point a = point(at.on), b = point(at.on + 1);
    const auto along = [&](Index i) { return dot_sign<2>(a, b, point(i), point(i + 1)); };
    at.right = move(at.on == 0 ? 1 : at.right, along);
    at.top = move(at.on == 0 ? at.right : at.top, [&](Index i) { return cross_sign(a, b, point(i), point(i + 1)); });
    at.left = move(at.on == 0 ? at.top : at.left, [&](Index i) { return -along(i); });
  }

  /// The first vertex from which the way to the next does not rise.
  template <class Rise>
  [[nodiscard]] Index move(Index corner, Rise&& rise) {
    std::int64_t tests = 1;
    for (; rise(corner) > 0; ++tests) corner = around(corner + 1);
    observe_.count(Operation::kOrientationTests, tests);
    return corner;
  }

  /// to - from, times 2^-exponent.
  [[nodiscard]] Wide difference(Index from, Index to, int exponent) const {
    Wide d;
    for (int i = 0; i < 2; ++i) {
      const DoubleDouble exact = DoubleDouble::sum(point(to)[i], -point(from)[i]);
      d[i] = {std::ldexp(exact.high, -exponent), std::ldexp(exact.low, -exponent)};
    }
    return d;
  }

  void measure(CalipersRectangle& at) {
    const Wide e = difference(at.on, at.on + 1, std::ilogb((point(at.on + 1) - point(at.on)).cwiseAbs().maxCoeff()));
    const DoubleDouble length = e[0] * e[0] + e[1] * e[1];
    const auto along = [&](Index corner) {
      const Wide d = difference(at.on, corner, unit_);
      return d[0] * e[0] + d[1] * e[1];
    };
    const DoubleDouble back = along(at.left), forth = along(at.right);
    const Wide up = difference(at.on, at.top, unit_);
    const DoubleDouble height = e[0] * up[1] - e[1] * up[0];
    at.area = ((forth - back) * height / length).value();
    const double root = std::sqrt(length.value());
    at.back = back.value() / root;
    at.forth = forth.value() / root;
    at.height = height.value() / root;
    observe_.count(Operation::kDotProducts, 3);
    observe_.count(Operation::kComparisons, 1);
  }

  using Step = ObbStep<Scalar, 2>;

  /// The rectangle as it was measured: only the result is tested against the points exactly.
  [[nodiscard]] Obb<Scalar, 2> box(const CalipersRectangle& at) const {
    const Matrix<double, 2> frame = axes(at);
    const Point middle((at.back + at.forth) / 2, at.height / 2), half((at.forth - at.back) / 2, at.height / 2);
    const double unit = std::ldexp(1.0, unit_);
    return {(point(at.on) + frame * middle * unit).template cast<Scalar>(), frame.template cast<Scalar>(),
            (half * unit).template cast<Scalar>()};
  }

  void tell(const CalipersRectangle& at, const CalipersRectangle& best, bool better) {
    std::vector<Index> touching;
    for (const Index place : {at.on, around(at.on + 1), at.right, at.top, at.left}) {
      const Index index = hull_.indices[place];
      if (std::find(touching.begin(), touching.end(), index) == touching.end()) touching.push_back(index);
    }
    const Obb<Scalar, 2> tried = box(at);
    observe_(Step{better ? 3 : 2, true, box(best), BoxTried<Scalar, 2>{touching, tried, snug::measure(tried), better}});
  }

  const ConvexHull<Scalar, 2>& hull_;
  Observer& observe_;
  int unit_ = 0;
};

/// The rectangle of least area around a hull in the plane. If all points lie on a line, its axes are along and across
/// that line; if they coincide, the coordinate axes. It contains every vertex exactly, and so the hull. hull: as
/// quickhull returns it, with coordinates that a PointSet takes. O(n) time.
template <class Scalar, StepObserver<ObbStep<Scalar, 2>> Observer = Ignore>
Obb<Scalar, 2> min_area_rectangle(const ConvexHull<Scalar, 2>& hull, Observer&& observe = {}) {
  Matrix<double, 2> axes = Matrix<double, 2>::Identity();
  const auto at = [&hull](std::size_t i) -> Vector<double, 2> { return hull.vertices[i].template cast<double>(); };
  if (hull.affine_dim == 1) axes = frame(Vector<double, 2>(at(1) - at(0)));
  if (hull.affine_dim == 2) {
    Calipers<Scalar, std::remove_reference_t<Observer>> calipers(hull, observe);
    axes = calipers.axes(calipers.run());
  }
  const PointSet<Scalar, 2> vertices = *PointSet<Scalar, 2>::make(hull.vertices);
  BoxOnAxes<Scalar, 2> found = obb_from_axes<Scalar, 2>(axes.template cast<Scalar>(), vertices.span());
  for (auto* ends : {&found.least, &found.greatest})
    for (Index& i : *ends) i = hull.indices[i];
  observe.count(Operation::kPointsTouched, vertices.size());
  return finish_box(found, 5, observe).volume;
}

}  // namespace snug::fit
