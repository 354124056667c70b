#include "fit/hull/quickhull_simplex.hpp"

#include <array>
#include <cmath>

#include "geometry/orientation.hpp"
#include "number/power_of_two.hpp"
#include "number/tuple.hpp"

namespace snug::fit {
namespace {

using Point = Vector<double, 3>;

template <class Scalar>
class SimplexSearch {
 public:
  explicit SimplexSearch(PointSpan<Scalar, 3> points) : points_(points) {}

  std::vector<Index> run() {
    const auto ends = farthest_extremes();
    const Index a = ends[0], b = ends[1];
    if (points_[a] == points_[b]) return {0};
    const Point origin = at(a), along = from(origin, b) / from(origin, b).norm();
    const Index c = most([&](Index i) { return cross(along, from(origin, i)).squaredNorm(); },
                         [&](Index i) { return !collinear(at(a), at(b), at(i)); });
    if (c == kNoIndex) return {a, b};
    const Point normal = cross(along, from(origin, c));
    const Index d = most([&](Index i) { return std::abs(normal.dot(from(origin, i))); },
                         [&](Index i) { return orient3d(at(a), at(b), at(c), at(i)) != 0; });
    if (d == kNoIndex) return {a, b, c};
    return {a, b, c, d};
  }

 private:
  [[nodiscard]] Point at(Index i) const { return points_[i].template cast<double>(); }
  /// The point relative to an origin, scaled so that no product overflows and none that matters underflows.
  [[nodiscard]] Point from(const Point& origin, Index i) const { return (at(i) - origin) * scale_; }

  std::array<Index, 2> farthest_extremes() {
    std::array<Index, 3> least{}, greatest{};
    for (Index i = 1; i < points_.size(); ++i)
      for (int axis = 0; axis < 3; ++axis) {
        auto& low = least[axis];
        auto& high = greatest[axis];
        if (points_[i][axis] < points_[low][axis]) low = i;
        if (points_[i][axis] > points_[high][axis]) high = i;
      }
    std::array<Index, 2> pair{};
    double widest = 0, longest = -1;
    for (std::size_t axis = 0; axis < 3; ++axis)
      widest = std::max(widest, (at(greatest[axis]) - at(least[axis])).cwiseAbs().maxCoeff());
    scale_ = to_unit_size(widest);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double square = from(at(least[axis]), greatest[axis]).squaredNorm();
      if (square > longest) {
        longest = square;
        pair = {least[axis], greatest[axis]};
      }
    }
    return pair;
  }

  /// The point of the greatest value, if good() accepts it; else the first point that good() accepts.
  template <class Value, class Good>
  [[nodiscard]] Index most(Value&& value, Good&& good) const {
    Index best = 0;
    double greatest = -1;
    for (Index i = 0; i < points_.size(); ++i)
      if (const double v = value(i); v > greatest) {
        greatest = v;
        best = i;
      }
    if (good(best)) return best;
    for (Index i = 0; i < points_.size(); ++i)
      if (good(i)) return i;
    return kNoIndex;
  }

  PointSpan<Scalar, 3> points_;
  double scale_ = 1;
};

}  // namespace

template <class Scalar>
std::vector<Index> spanning_simplex(PointSpan<Scalar, 3> points) {
  return SimplexSearch<Scalar>(points).run();
}
template std::vector<Index> spanning_simplex(PointSpan<float, 3>);
template std::vector<Index> spanning_simplex(PointSpan<double, 3>);

}  // namespace snug::fit
