// DiTO: a box on the best edges and faces of a ditetrahedron of extreme points.
// Source: T. Larsson, L. Källberg, "Fast computation of tight-fitting oriented bounding boxes", Game Engine Gems 2,
// 2011: their DiTO-14, ditetrahedron OBB; boxes are compared by volume. In 2-D the base is a segment, with a triangle
// on either side.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "fit/obb/obb_from_axes.hpp"
#include "fit/obb/obb_trials.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 8> kObbDitoPseudocode{
    "extremes ← farthest along 7 fixed normals",
    "base ← triangle of three far extremes",
    "for each edge of it: try a box",
    "apexes ← farthest above and below the base",
    "for each face and edge on them: try a box",
    "extents ← all points, on the best axes",
    "if the AABB is smaller: take it",
    "return box",
};

/// The points with the least and the greatest projection onto each of the slab axes of a k-DOP, least first. One pass
/// over blocks, and a second over those blocks that have an extreme.
template <class Scalar, int Dim>
class SlabExtremes {
 public:
  static constexpr int kDirections = Dim == 2 ? 4 : 7;

  explicit SlabExtremes(PointSpan<Scalar, Dim> points) : points_(points) {
    std::vector<Reach> blocks;
    Reach all;
    for (Index begin = 0; begin < points.size(); begin += kBlock) {
      blocks.push_back(reach_of(begin));
      for (std::size_t k = 0; k < kDirections; ++k) {
        all.least[k] = std::min(all.least[k], blocks.back().least[k]);
        all.greatest[k] = std::max(all.greatest[k], blocks.back().greatest[k]);
      }
    }
    for (std::size_t k = 0; k < kDirections; ++k) {
      Index begin = 0;
      for (const Reach& block : blocks) {
        if (least[k] == kNoIndex && block.least[k] == all.least[k]) least[k] = find(begin, k, all.least[k]);
        if (greatest[k] == kNoIndex && block.greatest[k] == all.greatest[k])
          greatest[k] = find(begin, k, all.greatest[k]);
        begin += kBlock;
      }
    }
  }

  std::array<Index, kDirections> least = none(), greatest = none();

 private:
  static constexpr Index kBlock = 1024;
  using Along = std::array<Scalar, kDirections>;

  struct Reach {
    Along least = filled(std::numeric_limits<Scalar>::infinity());
    Along greatest = filled(-std::numeric_limits<Scalar>::infinity());
  };

  static constexpr Along filled(Scalar value) {
    Along along{};
    along.fill(value);
    return along;
  }
  static constexpr std::array<Index, kDirections> none() {
    std::array<Index, kDirections> indices{};
    indices.fill(kNoIndex);
    return indices;
  }

  /// Projects a point onto the axes of kdop_axes<2>(8) or kdop_axes<3>(14), in their order.
  static Along project(const Vector<Scalar, Dim>& p) {
    if constexpr (Dim == 2) return {p[0], p[1], p[0] + p[1], p[0] - p[1]};
    else {
      const Scalar sum = p[0] + p[1], difference = p[0] - p[1];
      return {p[0], p[1], p[2], sum + p[2], sum - p[2], difference + p[2], p[2] - difference};
    }
  }

  [[nodiscard]] Reach reach_of(Index begin) const {
    const Index end = begin + std::min(points_.size() - begin, kBlock);
    Reach reach;
    for (Index i = begin; i < end; ++i) {
      const Along along = project(points_[i]);
      for (std::size_t k = 0; k < kDirections; ++k) {
        reach.least[k] = std::min(reach.least[k], along[k]);
        reach.greatest[k] = std::max(reach.greatest[k], along[k]);
      }
    }
    return reach;
  }

  [[nodiscard]] Index find(Index begin, std::size_t k, Scalar projection) const {
    while (project(points_[begin])[k] != projection) ++begin;
    return begin;
  }

  PointSpan<Scalar, Dim> points_;
};

/// The state of one run. Candidate axes are judged by their boxes around the extremes alone.
template <class Scalar, int Dim, class Observer>
class ObbDito {
 public:
  ObbDito(PointSpan<Scalar, Dim> points, Observer& observe)
      : points_(points), observe_(observe), chosen_(extremes(points)), trials_(coordinates(), observe) {}

  Fit<Obb<Scalar, Dim>> run() {
    constexpr std::int64_t kDirections = SlabExtremes<Scalar, Dim>::kDirections;
    observe_.count(Operation::kPointsTouched, points_.size());
    observe_.count(Operation::kDotProducts, kDirections * points_.size());
    observe_.count(Operation::kComparisons, 2 * kDirections * points_.size());
    tell(0, chosen_);
    if (find_base()) try_apexes();
    return finish();
  }

 private:
  using Step = ObbStep<Scalar, Dim>;
  using Point = Vector<double, Dim>;

  /// The extremes, each once.
  static std::vector<Index> extremes(PointSpan<Scalar, Dim> points) {
    const SlabExtremes<Scalar, Dim> found(points);
    std::vector<Index> chosen(found.least.begin(), found.least.end());
    chosen.insert(chosen.end(), found.greatest.begin(), found.greatest.end());
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
  }
  [[nodiscard]] std::vector<Vector<Scalar, Dim>> coordinates() const {
    std::vector<Vector<Scalar, Dim>> points;
    for (const Index i : chosen_) points.push_back(points_[i]);
    return points;
  }

  [[nodiscard]] const Point& at(std::size_t k) const { return trials_.local().at[k]; }
  [[nodiscard]] std::size_t size() const { return chosen_.size(); }

  void tell(int line, std::vector<Index> points) {
    observe_(Step{line, trials_.least() < std::numeric_limits<double>::infinity(), trials_.box(),
                  PointsChosen{std::move(points)}});
  }

  /// The extreme for which far is greatest; none if that is within rounding of zero.
  template <class Far>
  [[nodiscard]] std::optional<std::size_t> farthest(Far&& far) const {
    std::size_t best = 0;
    for (std::size_t k = 1; k < size(); ++k)
      if (far(k) > far(best)) best = k;
    if (!(far(best) > trials_.floor())) return std::nullopt;
    return best;
  }

  void attempt(const Matrix<double, Dim>& axes, std::initializer_list<std::size_t> on, int line) {
    std::array<Index, 4> points{};
    auto end = points.begin();
    for (const std::size_t k : on) *end++ = chosen_[k];
    trials_.attempt(axes, std::span(points).first(on.size()), line);
  }

  // Finds the farthest pair and, in space, the point farthest from their line. Returns false if there is no such base:
  // then the points coincide or (as far as the extremes tell) lie on a line, and the box along it has been tried.
  bool find_base() {
    double most = -1;
    for (std::size_t a = 0; a < size(); ++a)
      for (std::size_t b = a + 1; b < size(); ++b)
        if (const double square = (at(b) - at(a)).squaredNorm(); square > most) {
          most = square;
          base_ = {a, b};
        }
    if (size() < 2) return false;
    const Point along = at(base_[1]) - at(base_[0]);
    if constexpr (Dim == 2) {
      tell(1, {chosen_[base_[0]], chosen_[base_[1]]});
      attempt(frame(along), {base_[0], base_[1]}, 2);
      return true;
    } else {
      const auto third = farthest([&](std::size_t k) { return unit<3>(along).cross(at(k) - at(base_[0])).norm(); });
      if (!third) {
        attempt(frame(along, Point::Zero()), {base_[0], base_[1]}, 2);
        return false;
      }
      base_.push_back(*third);
      tell(1, {chosen_[base_[0]], chosen_[base_[1]], chosen_[base_[2]]});
      try_triangle(base_[0], base_[1], base_[2], 2);
      return true;
    }
  }

  /// Tries a box on each edge of a triangle, with one face in the triangle's plane.
  void try_triangle(std::size_t a, std::size_t b, std::size_t c, int line) {
    if constexpr (Dim == 3) {
      const Point ab = at(b) - at(a), bc = at(c) - at(b), ca = at(a) - at(c);
      const Point normal = ab.cross(bc);
      attempt(frame(normal, ab), {a, b, c}, line);
      attempt(frame(normal, bc), {b, c, a}, line);
      attempt(frame(normal, ca), {c, a, b}, line);
    }
  }

  void try_apexes() {
    const Point corner = at(base_[0]), along = at(base_[1]) - corner;
    Point across;
    if constexpr (Dim == 2) across = frame(along).col(1);
    else across = unit<3>(along.cross(at(base_[2]) - corner));
    for (const double side : {1.0, -1.0}) {
      const auto apex = farthest([&](std::size_t k) { return side * across.dot(at(k) - corner); });
      if (!apex) continue;
      tell(3, {chosen_[*apex]});
      for (std::size_t k = 0; k < base_.size(); ++k) {
        const std::size_t a = base_[k];
        if constexpr (Dim == 2) attempt(frame(at(*apex) - at(a)), {a, *apex}, 4);
        else try_triangle(a, base_[(k + 1) % 3], *apex, 4);
      }
    }
  }

  // The extremes only tell which axes are promising. Whether the best axes beat the coordinate axes takes all points;
  // along the coordinate axes, the extremes are those of all points.
  Fit<Obb<Scalar, Dim>> finish() {
    BoxOnAxes<Scalar, Dim> found = obb_from_axes(trials_.scalar_axes(), points_);
    tell_extents(found, points_.size(), 5, observe_);
    const LocalPoints<Dim>& local = trials_.local();
    const LocalBox<Dim> aabb(Matrix<double, Dim>::Identity(), local.at);
    Vector<double, Dim> lengths = 2 * found.box.half_extents.template cast<double>();
    for (int i = 0; i < Dim; ++i) lengths[i] = std::ldexp(lengths[i], -local.exponent);
    if (padded_measure<Dim>(aabb.greatest - aabb.least, trials_.floor()) <
        padded_measure<Dim>(lengths, trials_.floor())) {
      found = obb_from_axes<Scalar, Dim>(Matrix<Scalar, Dim>::Identity(), points_);
      tell_extents(found, points_.size(), 6, observe_);
    }
    return finish_box(found, 7, observe_);
  }

  PointSpan<Scalar, Dim> points_;
  Observer& observe_;
  std::vector<Index> chosen_;
  ObbTrials<Scalar, Dim, Observer> trials_;
  std::vector<std::size_t> base_;
};

/// A tight box in linear time: a few extremes propose axes and judge them.
/// points: n >= 1 finite points, scene units. O(n) time: two passes, or three if the AABB wins.
template <class Scalar, int Dim, StepObserver<ObbStep<Scalar, Dim>> Observer = Ignore>
Fit<Obb<Scalar, Dim>> obb_dito(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  return ObbDito<Scalar, Dim, std::remove_reference_t<Observer>>(points, observe).run();
}

}  // namespace snug::fit
