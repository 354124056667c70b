// The smallest ball, by trying all candidates: to check other algorithms on few points, and to show what O(n^5) means.
#pragma once

#include <array>
#include <string_view>

#include "fit/sphere/sphere_steps.hpp"
#include "fit/sphere/support_ball.hpp"
#include "geometry/tolerance.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 6> kBruteForcePseudocode{
    "for each pair, triple (and in 3-D quadruple) of points",
    "  candidate ← smallest around them",
    "  if candidate is smaller than best",
    "    if no point lies outside candidate",
    "      best ← candidate",
    "return best",
};

inline constexpr std::array<std::string_view, 6> kBruteForceSlidePseudocode{
    "for each triple (in 3-D quadruple) of points",
    "  candidate ← the one through all of them",
    "  if candidate is smaller than best",
    "    if no point lies outside candidate",
    "      best ← candidate",
    "return best; if there is none, try fewer points",
};

/// Which subsets are tried.
enum class Subsets { kAll, kLargest };

/// Callers refuse more points than this: 40 points in 3-D have 102,050 candidates.
inline constexpr Index kBruteForceLimit = 40;

/// The state of one run over subsets, in lexicographic order: all those of two to Dim + 1 points, small ones first; or
/// those of Dim + 1 alone, and smaller ones only where no such ball contains all points.
template <class Scalar, int Dim, class Observer>
class BruteForce {
 public:
  BruteForce(PointSpan<Scalar, Dim> points, Subsets subsets, Observer& observe)
      : points_(points), subsets_(subsets), observe_(observe) {}

  Fit<Sphere<Scalar, Dim>> run() {
    if (subsets_ == Subsets::kAll)
      for (int size = 2; size <= Dim + 1; ++size) choose(size, 0, {});
    else
      for (int size = Dim + 1; size >= 2 && !has_ball_; --size) choose(size, 0, {});
    if (!has_ball_) attempt({0});  // one point, or the same one many times
    if (!has_ball_) start_anywhere();
    best_.radius = enclosing_radius(best_.center, points_, farthest_points(best_.center, points_));
    observe_(Step{5, true, best_, Finished{support_.list()}});
    return {best_, support_};
  }

 private:
  using Step = SphereStep<Scalar, Dim>;
  using Tried = CandidateTried<Scalar, Dim>;
  using Verdict = typename Tried::Verdict;

  void choose(int more, Index first, const Support& chosen) {
    if (more == 0) return attempt(chosen);
    for (Index i = first; i < points_.size(); ++i) {
      Support with = chosen;
      with.add(i);
      choose(more - 1, i + 1, with);
    }
  }

  void attempt(const Support& support) {
    const auto ball = ball_through(points_, support);
    observe_.count(Operation::kBallSolves, 1);
    // If the centre is outside their hull, fewer of these points support a smaller ball, which is a candidate itself.
    const bool all = subsets_ == Subsets::kAll;
    if (!ball && !all) return tell(1, {support, best_, Verdict::kDependent, kNoIndex});
    if (!ball || (all && !ball->center_in_hull())) return tell(1, {support, best_, Verdict::kNoBall, kNoIndex});
    const Sphere<Scalar, Dim> candidate{ball->center.template cast<Scalar>(), static_cast<Scalar>(ball->radius)};
    if (has_ball_ && !(candidate.radius < best_.radius))
      return tell(2, {support, candidate, Verdict::kNotSmaller, kNoIndex});
    const Index outside = first_outside(candidate);
    if (outside != kNoIndex) return tell(3, {support, candidate, Verdict::kLeavesPointOutside, outside});
    best_ = candidate;
    support_ = support;
    has_ball_ = true;
    tell(4, {support, candidate, Verdict::kKept, kNoIndex});
  }

  /// If rounding leaves a point outside every candidate, starts from any of them: the last check finds the radius.
  void start_anywhere() {
    best_.center = points_[0];
    support_ = {0};
    has_ball_ = true;
  }

  void tell(int line, const Tried& tried) { observe_(Step{line, has_ball_, best_, tried}); }

  [[nodiscard]] Index first_outside(const Sphere<Scalar, Dim>& ball) {
    const Vector<double, Dim> center = ball.center.template cast<double>();
    const double reach = static_cast<double>(ball.radius);
    // The centre is rounded to the scalar; for points far from the origin, that is much more than the distance's own
    // rounding error. A third of what the certificate allows covers both, and what it lets in is no more than 3 ulps
    // larger than the smallest. Tested by "every family keeps its promises".
    const double size = reach + center.cwiseAbs().maxCoeff();
    const double limit = reach + tolerance::kOptimalityRoundoffs / 3 * tolerance::roundoff<Scalar>(size);
    for (Index i = 0; i < points_.size(); ++i) {
      observe_.count(Operation::kPointsTouched, 1);
      observe_.count(Operation::kDistanceTests, 1);
      if (scaled_norm<double, Dim>(points_[i].template cast<double>() - center) > limit) return i;
    }
    return kNoIndex;
  }

  PointSpan<Scalar, Dim> points_;
  Subsets subsets_;
  Observer& observe_;
  Sphere<Scalar, Dim> best_;
  Support support_;
  bool has_ball_ = false;
};

/// The smallest enclosing ball, by trying every ball that two, three (or in 3-D four) points support.
/// points: 1 <= n <= kBruteForceLimit finite points, scene units. O(n^(Dim + 2)) time.
template <class Scalar, int Dim, StepObserver<SphereStep<Scalar, Dim>> Observer = Ignore>
Fit<Sphere<Scalar, Dim>> brute_force(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  return BruteForce<Scalar, Dim, std::remove_reference_t<Observer>>(points, Subsets::kAll, observe).run();
}

/// The smallest ball through exactly Dim + 1 of the points that contains all others, as lectures print it. It is the
/// smallest of all only where so many points support that. Where the points lie on a line or in a plane, so that no
/// such ball contains them, fewer points are tried. points: as for brute_force. O(n^(Dim + 2)) time.
template <class Scalar, int Dim, StepObserver<SphereStep<Scalar, Dim>> Observer = Ignore>
Fit<Sphere<Scalar, Dim>> brute_force_slide(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  return BruteForce<Scalar, Dim, std::remove_reference_t<Observer>>(points, Subsets::kLargest, observe).run();
}

}  // namespace snug::fit
