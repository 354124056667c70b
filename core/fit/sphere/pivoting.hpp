// Finds the smallest ball from any starting ball: points outside enter the support set, the farthest first, until none
// is left outside. Source: B. Gärtner, "Fast and robust smallest enclosing balls", 1999.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "fit/sphere/sphere_steps.hpp"
#include "fit/sphere/support_ball.hpp"
#include "geometry/tolerance.hpp"

namespace snug::fit {

/// The current ball, and the steps that let points enter its support set.
template <class Scalar, int Dim, class Observer>
class Pivoting {
  using Step = SphereStep<Scalar, Dim>;

 public:
  /// The lines of the pseudocode for "all points were tested" and for "one entered".
  struct Lines {
    int tested, let_in;
  };
  Pivoting(PointSpan<Scalar, Dim> points, Lines lines, Observer& observe)
      : points_(points), lines_(lines), observe_(observe) {}

  /// The ball in the fitter's own scalar, and in twice double's digits.
  [[nodiscard]] const Sphere<Scalar, Dim>& current() const { return current_; }
  [[nodiscard]] const SupportBall<Dim>& ball() const { return ball_; }
  [[nodiscard]] Scalar square_to(Index i) const { return (points_[i] - current_.center).squaredNorm(); }
  [[nodiscard]] bool outside(Scalar square) const { return square > limit_; }

  void take(const SupportBall<Dim>& ball) {
    ball_ = ball;
    current_ = {ball_.center.template cast<Scalar>(), static_cast<Scalar>(ball_.radius)};
    limit_ = current_.radius * current_.radius * (1 + tolerance::kSquaredDistance<Scalar>);
    observe_.count(Operation::kBallSolves, 1);
  }

  /// Replaces the current ball, and reports the change of the support set. entered: kNoIndex for none.
  void replace(const SupportBall<Dim>& ball, Index entered, int line) {
    const Support before = ball_.support;
    take(ball);
    observe_(Step{line, true, current_, SupportReplaced{entered, before, ball_.support}});
  }

  /// Lets the farthest of a few points enter, again and again, until none of them lies outside. Each entry makes the
  /// ball strictly larger, so this ends whatever the rounding. Returns whether the ball has changed.
  bool let_in(std::span<const Index> few, int line) {
    for (bool grew = false;; grew = true) {
      const Index farthest = farthest_outside(few);
      if (farthest == kNoIndex || ball_.support.contains(farthest)) return grew;
      const SupportBall<Dim> next = smallest_ball_with(points_, farthest, ball_.support);
      if (!smaller(ball_, next)) return grew;
      replace(next, farthest, line);
    }
  }

  /// A recursion in exact arithmetic ends with its centre in the support's hull. If rounding moved it out, the smallest
  /// ball of these few points is a sound start.
  void drop_idle_support(int line) {
    if (ball_.center_in_hull()) return;
    const Support support = ball_.support;
    SupportBall<Dim> best = *ball_through(points_, Support{support[0]});
    for (const Index i : support) {
      const SupportBall<Dim> ball = smallest_ball_with(points_, i, support);
      if (smaller(best, ball)) best = ball;
    }
    replace(best, kNoIndex, line);
  }

  /// Tests all points, and lets the farthest of each block enter, until no point lies outside. Then sets the radius so
  /// that the ball contains every point exactly.
  [[nodiscard]] Fit<Sphere<Scalar, Dim>> finish() {
    FarthestPoints<Scalar> far = test_all();
    while (let_in(outsiders(far), lines_.let_in)) far = test_all();
    Sphere<Scalar, Dim> result = current_;
    result.radius = enclosing_radius(result.center, points_, far);
    return {result, ball_.support};
  }

 private:
  [[nodiscard]] FarthestPoints<Scalar> test_all() {
    observe_.count(Operation::kPointsTouched, points_.size());
    observe_.count(Operation::kDistanceTests, points_.size());
    return farthest_points(current_.center, points_);
  }

  [[nodiscard]] std::vector<Index> outsiders(const FarthestPoints<Scalar>& far) {
    std::vector<Index> outside;
    for (const auto& block : far.of_block)
      if (this->outside(block.square)) outside.push_back(block.point);
    observe_(Step{lines_.tested, true, current_, AllChecked{static_cast<Index>(outside.size())}});
    return outside;
  }

  [[nodiscard]] Index farthest_outside(std::span<const Index> few) {
    Index farthest = kNoIndex;
    Scalar most = limit_;
    for (const Index i : few) {
      const Scalar square = square_to(i);
      if (square > most) {
        most = square;
        farthest = i;
      }
    }
    observe_.count(Operation::kDistanceTests, static_cast<std::int64_t>(few.size()));
    return farthest;
  }

  PointSpan<Scalar, Dim> points_;
  Lines lines_;
  Observer& observe_;
  SupportBall<Dim> ball_;
  Sphere<Scalar, Dim> current_;
  Scalar limit_ = 0;  // squared distances above it are outside
};

}  // namespace snug::fit
