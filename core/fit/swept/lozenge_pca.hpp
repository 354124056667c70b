// A lozenge along the two longest principal axes of the points.
// Source: E. Larsen, S. Gottschalk, M. C. Lin, D. Manocha, "Fast proximity queries with swept sphere volumes", 1999.
#pragma once

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "fit/obb/principal_frame.hpp"
#include "fit/swept/lozenge_steps.hpp"
#include "fit/swept/swept_radius.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 8> kLozengePcaPseudocode{
    "m ← mean of the points",
    "C ← covariance about m",
    "axes ← eigenvectors of C",
    "radius ← half the least extent (2-D: by the vertices)",
    "pull the rectangle's four sides in",
    "move vertices out to points left outside",
    "radius ← to the farthest point, exactly",
    "return lozenge",
};

/// The lozenge under construction, in the frame of the points: its rectangle goes from low to high along the axes
/// `first` and `second`, and in space lies at that height along the third.
template <class Scalar, int Dim>
class LozengeMaker {
 public:
  using Local = std::vector<Vector<Scalar, Dim>>;

  explicit LozengeMaker(const PrincipalFrame<Scalar, Dim>& frame) : frame_(frame), local_(frame.local) {
    measure_extents();
  }

  [[nodiscard]] Lozenge<Scalar, Dim> lozenge() const {
    const auto along = [&](int axis, Scalar length) -> Vector<Scalar, Dim> {
      return frame_.to_scene(length * Vector<Scalar, Dim>::Unit(axis));
    };
    Vector<Scalar, Dim> corner = Vector<Scalar, Dim>::Zero();
    corner[edge_axes_[0]] = low_[0];
    corner[edge_axes_[1]] = low_[1];
    if constexpr (Dim == 3) corner[thin_axis()] = height_;
    return {frame_.origin + frame_.to_scene(corner),
            {along(edge_axes_[0], high_[0] - low_[0]), along(edge_axes_[1], high_[1] - low_[1])},
            radius_ / frame_.scale};
  }

  /// Finds the radius: in space half of the thickness; in the plane the largest with which no rounded corner of the box
  /// cuts a point off, because the area is the box's less (4 - pi) radius^2.
  ThicknessFound find_radius() {
    ThicknessFound found;
    if constexpr (Dim == 3) {
      const auto [least, greatest] = ends_along(thin_axis());
      const Scalar low = at(least, thin_axis()), high = at(greatest, thin_axis());
      height_ = low + (high - low) / 2;
      radius_ = (high - low) / 2;
      found = {least, greatest, 0};
    } else {
      radius_ = std::min(high_[0] - low_[0], high_[1] - low_[1]) / 2;
      found.least = ends_along(edge_axes_[1]).first;  // sets the radius if no corner does
      for (Index i = 0; i < size(); ++i) {
        const Scalar most = corner_radius(i);
        if (!(most < radius_)) continue;
        radius_ = most;
        found.least = i;
      }
    }
    found.radius = static_cast<double>(radius_) / static_cast<double>(frame_.scale);
    return found;
  }

  /// Pulls a side in: side 2 e is the start of edge e, 2 e + 1 its end. It must stay within the reach of each point.
  SidePulledIn pull_in(int side) {
    const std::size_t edge = side / 2;
    const bool is_end = side % 2 == 1;
    Scalar& bound = is_end ? high_[edge] : low_[edge];
    const Scalar sign = is_end ? Scalar{1} : Scalar{-1};
    const Scalar before = bound;
    SidePulledIn pulled{side, 0, 0};
    for (Index i = 0; i < size(); ++i) {
      const Scalar needed = at(i, edge_axes_[edge]) - sign * reach(i);
      if (i > 0 && sign * needed <= sign * bound) continue;
      bound = needed;
      pulled.point = i;
    }
    pulled.by = std::abs(static_cast<double>(before) - static_cast<double>(bound)) / static_cast<double>(frame_.scale);
    return pulled;
  }

  /// Keeps opposite sides in order, which only rounding can swap.
  void order_sides() {
    for (std::size_t edge = 0; edge < 2; ++edge)
      if (low_[edge] > high_[edge]) low_[edge] = high_[edge] = (low_[edge] + high_[edge]) / 2;
  }

  /// If the point lies past a vertex and out of its reach, moves that vertex out to it; otherwise does nothing.
  std::optional<CornerMovedOut> move_corner_to(Index i) {
    CornerMovedOut moved{0, i, 0, 0};
    std::array<Scalar, 2> past{};
    for (std::size_t edge = 0; edge < 2; ++edge) {
      const Scalar coordinate = at(i, edge_axes_[edge]);
      const bool is_end = coordinate > high_[edge];
      past[edge] = is_end ? coordinate - high_[edge] : low_[edge] - coordinate;
      if (past[edge] <= 0) return std::nullopt;
      moved.corner |= is_end ? 1 << edge : 0;
    }
    const Scalar reached = reach(i) + tolerance::kLocalCoordinate<Scalar>;
    if (past[0] * past[0] + past[1] * past[1] <= reached * reached) return std::nullopt;
    const std::array<Scalar, 2> by = cheapest_move(past, reach(i));
    for (std::size_t edge = 0; edge < 2; ++edge) {
      const bool is_end = (moved.corner >> edge & 1) != 0;
      (is_end ? high_ : low_)[edge] += is_end ? by[edge] : -by[edge];
    }
    moved.along_first = static_cast<double>(by[0]) / static_cast<double>(frame_.scale);
    moved.along_second = static_cast<double>(by[1]) / static_cast<double>(frame_.scale);
    return moved;
  }

  [[nodiscard]] Index size() const { return static_cast<Index>(local_.size()); }

 private:
  [[nodiscard]] Scalar at(Index i, int axis) const { return local_[i][axis]; }
  [[nodiscard]] int thin_axis() const { return 3 - edge_axes_[0] - edge_axes_[1]; }

  [[nodiscard]] std::pair<Index, Index> ends_along(int axis) const {
    std::pair<Index, Index> ends{0, 0};
    for (Index i = 1; i < size(); ++i) {
      if (at(i, axis) < at(ends.first, axis)) ends.first = i;
      if (at(i, axis) > at(ends.second, axis)) ends.second = i;
    }
    return ends;
  }

  /// Lays the rectangle along the axes of greatest extent, as large as the points' extents.
  void measure_extents() {
    std::array<std::pair<Scalar, int>, Dim> lengths;
    for (int axis = 0; axis < Dim; ++axis) {
      const auto [least, greatest] = ends_along(axis);
      lengths[axis] = {at(greatest, axis) - at(least, axis), axis};
    }
    std::sort(lengths.rbegin(), lengths.rend());
    for (std::size_t edge = 0; edge < 2; ++edge) {
      edge_axes_[edge] = lengths[edge].second;
      const auto [least, greatest] = ends_along(edge_axes_[edge]);
      low_[edge] = at(least, edge_axes_[edge]);
      high_[edge] = at(greatest, edge_axes_[edge]);
    }
  }

  /// How far beyond the rectangle's side, along the rectangle, the point may lie.
  [[nodiscard]] Scalar reach(Index i) const {
    if constexpr (Dim == 2) {
      return radius_;
    } else {
      const Scalar height = at(i, thin_axis()) - height_;
      return std::sqrt(std::max(radius_ * radius_ - height * height, Scalar{0}));
    }
  }

  /// The radius of the circle that touches both sides at the point's nearest corner and passes through the point. With
  /// u and v the point's distances from the sides, (r - u)^2 + (r - v)^2 = r^2.
  [[nodiscard]] Scalar corner_radius(Index i) const {
    const auto inside = [&](std::size_t edge) {
      const Scalar coordinate = at(i, edge_axes_[edge]);
      return std::min(coordinate - low_[edge], high_[edge] - coordinate);
    };
    const Scalar u = inside(0), v = inside(1);
    return u + v + std::sqrt(2 * u * v);
  }

  /// How far to move a vertex along each edge, to bring it within the point's reach: along one, the other, or both
  /// alike, whichever adds the least. past: how far the point is past the vertex's sides, each at most reach.
  [[nodiscard]] std::array<Scalar, 2> cheapest_move(const std::array<Scalar, 2>& past, Scalar reach) const {
    const auto left = [](Scalar square) { return std::sqrt(std::max(square, Scalar{0})); };
    const Scalar first = std::max(past[0] - left(reach * reach - past[1] * past[1]), Scalar{0});
    const Scalar second = std::max(past[1] - left(reach * reach - past[0] * past[0]), Scalar{0});
    const Scalar apart = past[0] - past[1];
    const Scalar both = std::max((past[0] + past[1] - left(2 * reach * reach - apart * apart)) / 2, Scalar{0});
    // How much the lozenge grows when an edge does; in space, up to a factor of its radius.
    constexpr auto kPi = std::numbers::pi_v<Scalar>;
    const auto growth = [&](std::size_t edge) {
      return high_[1 - edge] - low_[1 - edge] + (Dim == 2 ? 2 : kPi / 2) * radius_;
    };
    const Scalar by_first = first * growth(0), by_second = second * growth(1), by_both = both * (growth(0) + growth(1));
    if (by_both <= std::min(by_first, by_second)) return {both, both};
    return by_first <= by_second ? std::array{first, Scalar{0}} : std::array{Scalar{0}, second};
  }

  const PrincipalFrame<Scalar, Dim>& frame_;
  const Local& local_;
  std::array<int, 2> edge_axes_{};
  std::array<Scalar, 2> low_{}, high_{};
  Scalar height_ = 0;
  Scalar radius_ = 0;
};

/// The points on the boundary, each once: not those that touched a side which a vertex moved later.
template <class Scalar, int Dim>
[[nodiscard]] std::vector<Index> touching(const Lozenge<Scalar, Dim>& lozenge, PointSpan<Scalar, Dim> points,
                                          std::vector<Index> candidates) {
  const double size = swept_size(lozenge, points);
  std::vector<Index> support;
  for (const Index i : candidates)
    if (touches(lozenge, points[i], size) && std::find(support.begin(), support.end(), i) == support.end())
      support.push_back(i);
  return support;
}

/// The lozenge whose rectangle lies along the principal axes of greatest extent, and whose sides are pulled in as far
/// as the points allow. Its radius is half of the remaining extent; in the plane, the largest that cuts no point off.
/// points: n >= 1 finite points, scene units. O(n) time and memory.
template <class Scalar, int Dim, StepObserver<LozengeStep<Scalar, Dim>> Observer = Ignore>
Fit<Lozenge<Scalar, Dim>> lozenge_pca(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  using Step = LozengeStep<Scalar, Dim>;
  const auto frame = principal_frame<Step>(points, observe);
  LozengeMaker<Scalar, Dim> maker(frame);
  const ThicknessFound thickness = maker.find_radius();
  observe(Step{3, true, maker.lozenge(), thickness});
  std::vector<Index> support{thickness.least};
  if (thickness.greatest != kNoIndex) support.push_back(thickness.greatest);
  for (int side = 0; side < 4; ++side) {
    const SidePulledIn pulled = maker.pull_in(side);
    support.push_back(pulled.point);
    observe(Step{4, true, maker.lozenge(), pulled});
  }
  maker.order_sides();
  for (Index i = 0; i < points.size(); ++i)
    if (const auto moved = maker.move_corner_to(i)) {
      support.push_back(i);
      observe(Step{5, true, maker.lozenge(), *moved});
    }
  observe.count(Operation::kPointsTouched, 8 * std::int64_t{points.size()});
  observe.count(Operation::kSquareRoots, 5 * std::int64_t{points.size()});

  Lozenge<Scalar, Dim> lozenge = maker.lozenge();
  const SweptRadius radius = hold_all(lozenge, points);
  observe.count(Operation::kPointsTouched, points.size());
  observe.count(Operation::kDistanceTests, points.size());
  observe(Step{6, true, lozenge, RadiusChecked{radius.farthest, radius.widened}});
  support = touching(lozenge, points, std::move(support));
  observe(Step{7, true, lozenge, Finished{support}});
  return {lozenge, std::move(support)};
}

}  // namespace snug::fit
