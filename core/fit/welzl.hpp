// Source: E. Welzl, "Smallest enclosing disks (balls and ellipsoids)", 1991, with his move-to-front heuristic; the
// check of the rest by farthest points after B. Gärtner, "Fast and robust smallest enclosing balls", 1999.
#pragma once

#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>
#include <vector>

#include "fit/sphere_steps.hpp"
#include "fit/support_ball.hpp"
#include "geometry/random.hpp"
#include "geometry/tolerance.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 10> kWelzlPseudocode{
    "ball ← solve(list, no support)",
    "while a point lies outside: let it in",
    "return ball",
    "solve(list, support):",
    "  ball ← ball through the support",
    "  for each point p in the list",
    "    if p outside ball",
    "      ball ← solve(before p, support + p)",
    "      move p to the front",
    "  return ball",
};

/// Lists up to this length are solved by the recursion whole; of longer ones a random sample is, and the rest let in. A
/// larger sample costs more balls than it saves passes over the points.
inline constexpr Index kWelzlList = 256, kWelzlSample = 8;

/// The state of one run: Welzl's recursion with a stack of Dim + 2 frames, however many points there are.
template <class Scalar, int Dim, class Observer>
class Welzl {
 public:
  Welzl(PointSpan<Scalar, Dim> points, Observer& observe) : points_(points), observe_(observe) {}

  Fit<Sphere<Scalar, Dim>> run(std::uint64_t seed) {
    sample(seed);
    recursion();
    drop_idle_support();
    FarthestPoints<Scalar> far = check_all();
    while (let_in_outsiders(far)) far = check_all();
    Sphere<Scalar, Dim> result = current_;
    result.radius = enclosing_radius(result.center, points_, far);
    observe_(Step{2, true, result, Finished{ball_.support.list()}});
    return {result, ball_.support};
  }

 private:
  using Step = SphereStep<Scalar, Dim>;

  void sample(std::uint64_t seed) {
    const bool whole = points_.size() <= kWelzlList;
    list_.resize(whole ? points_.size() : kWelzlSample);
    std::iota(list_.begin(), list_.end(), Index{0});
    if (whole) return;
    Random random(seed);
    for (Index& i : list_) i = static_cast<Index>(random.below(static_cast<std::uint32_t>(points_.size())));
  }

  void take(const SupportBall<Dim>& ball) {
    ball_ = ball;
    current_ = {ball_.center.template cast<Scalar>(), static_cast<Scalar>(ball_.radius)};
    limit_ = current_.radius * current_.radius * (1 + tolerance::kSquaredDistance<Scalar>);
    observe_.count(Operation::kBallSolves, 1);
  }

  [[nodiscard]] bool outside(Index i, int depth) {
    const Scalar square = (points_[i] - current_.center).squaredNorm();
    const bool out = !has_ball_ || square > limit_;
    observe_.count(Operation::kPointsTouched, 1);
    observe_.count(Operation::kDistanceTests, has_ball_ ? 1 : 0);
    if constexpr (kWatched<Observer>)
      observe_(Step{out ? 6 : 5, has_ball_, current_,
                    PointExamined{i, has_ball_ ? std::sqrt(static_cast<double>(square)) : 0, out, depth}});
    return out;
  }

  // One frame per point forced onto the boundary. A frame's list is the part of the list before the point that its
  // caller holds, so that the frames need no lists of their own.
  void recursion() {
    struct Frame {
      std::size_t end;
      std::size_t next;
    };
    std::array<Frame, Dim + 2> frames;
    std::array<Index, Dim + 1> boundary{};
    frames[0] = {list_.size(), 0};
    int depth = 0;
    for (;;) {
      Frame& frame = frames[depth];
      if (frame.next == frame.end || depth == Dim + 1) {
        if (depth == 0) return;
        --depth;
        move_to_front(frames[depth].next++, depth);
        continue;
      }
      const Index point = list_[frame.next];
      if (!outside(point, depth)) {
        ++frame.next;
        continue;
      }
      boundary[depth] = point;
      Support support;
      for (int i = 0; i <= depth; ++i) support.add(boundary[i]);
      const auto through = ball_through(points_, support);
      if (!through) {  // only rounding can leave a dependent point outside; the last check takes care of it
        ++frame.next;
        continue;
      }
      take(*through);
      has_ball_ = true;
      observe_(Step{4, true, current_, BoundaryForced{support, depth + 1}});
      ++depth;
      frames[depth] = {frame.next, 0};
    }
  }

  void move_to_front(std::size_t at, int depth) {
    const auto place = list_.begin() + static_cast<std::ptrdiff_t>(at);
    const Index point = *place;
    std::rotate(list_.begin(), place, place + 1);
    observe_(Step{8, true, current_, MovedToFront{point, depth}});
  }

  // In exact arithmetic the recursion ends with its centre in the support's hull. Where rounding took it out, the
  // smallest ball of these few points is a sound start for what follows.
  void drop_idle_support() {
    if (ball_.center_in_hull()) return;
    SupportBall<Dim> best = *ball_through(points_, Support{ball_.support[0]});
    for (const Index i : ball_.support) {
      const SupportBall<Dim> ball = smallest_ball_with(points_, i, ball_.support);
      if (smaller(best, ball)) best = ball;
    }
    const Support before = ball_.support;
    take(best);
    observe_(Step{1, true, current_, SupportReplaced{kNoIndex, before, ball_.support}});
  }

  /// Holds every point against the ball.
  [[nodiscard]] FarthestPoints<Scalar> check_all() {
    observe_.count(Operation::kPointsTouched, points_.size());
    observe_.count(Operation::kDistanceTests, points_.size());
    return farthest_points(current_.center, points_);
  }

  // Lets in the farthest outside point of each block, the farthest of them first. Each entry makes the ball strictly
  // larger, so that this ends whatever the rounding. Returns whether the ball has changed.
  bool let_in_outsiders(const FarthestPoints<Scalar>& far) {
    std::vector<Index> outsiders;
    for (const auto& block : far.of_block)
      if (block.square > limit_) outsiders.push_back(block.point);
    observe_(Step{1, true, current_, AllChecked{static_cast<Index>(outsiders.size())}});
    for (bool grew = false;; grew = true) {
      const Index farthest = farthest_outside(outsiders);
      if (farthest == kNoIndex || ball_.support.contains(farthest)) return grew;
      const SupportBall<Dim> next = smallest_ball_with(points_, farthest, ball_.support);
      if (!smaller(ball_, next)) return grew;
      const Support before = ball_.support;
      take(next);
      observe_(Step{1, true, current_, SupportReplaced{farthest, before, ball_.support}});
    }
  }

  [[nodiscard]] Index farthest_outside(const std::vector<Index>& candidates) {
    Index farthest = kNoIndex;
    Scalar most = limit_;
    for (const Index i : candidates) {
      const Scalar square = (points_[i] - current_.center).squaredNorm();
      if (square > most) {
        most = square;
        farthest = i;
      }
    }
    observe_.count(Operation::kDistanceTests, static_cast<std::int64_t>(candidates.size()));
    return farthest;
  }

  PointSpan<Scalar, Dim> points_;
  Observer& observe_;
  std::vector<Index> list_;
  SupportBall<Dim> ball_;
  Sphere<Scalar, Dim> current_;
  Scalar limit_ = 0;  // squared distances above it are outside
  bool has_ball_ = false;
};

/// The smallest enclosing ball.
/// points: n >= 1 finite points, scene units. Expected O(n) time; 1 kB, whatever n.
/// Of points closer together than about 1e-154 (in float 1e-19) the squared distances underflow: the ball then holds
/// them all, but need not be the smallest, and the certificate says so.
template <class Scalar, int Dim, StepObserver<SphereStep<Scalar, Dim>> Observer = Ignore>
Fit<Sphere<Scalar, Dim>> welzl(PointSpan<Scalar, Dim> points, const Options& options, Observer&& observe = {}) {
  return Welzl<Scalar, Dim, std::remove_reference_t<Observer>>(points, observe).run(options.seed);
}

}  // namespace snug::fit
