// Welzl's smallest enclosing ball, as the recursion that it is printed as.
// Source: E. Welzl, "Smallest enclosing disks (balls and ellipsoids)", 1991, as lectures print it: two recursions, the
// first as deep as there are points. welzl.hpp has the same without a deep stack.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "fit/sphere/pivoting.hpp"
#include "fit/sphere/random_order.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 10> kWelzlRecursivePseudocode{
    "S ← solve(the points in random order, {})",
    "test all points, exactly",
    "return S",
    "solve(points, support):",
    "  if none is left, or support has d + 1",
    "    return smallest through support",
    "  u ← the last point; rest ← the others",
    "  S ← solve(rest, support)",
    "  if u lies inside S: return S",
    "  return solve(rest, support + u)",
};

/// The recursion is stopped at this depth, long before a stack is full: a call takes some 300 bytes of it (`snug cost
/// --claims` measures that), and a stack has several megabytes, on the page as well (cmake/options.cmake).
inline constexpr int kWelzlDepthLimit = 1024;

/// Callers refuse more points than this. From kWelzlDepthLimit points on, the recursion is stopped. Somewhat larger
/// sets are accepted so that this can be shown, but no much larger ones, whose time would say nothing about the
/// recursion.
inline constexpr Index kWelzlRecursiveLimit = 1500;

/// The state of one run.
template <class Scalar, int Dim, class Observer>
class WelzlRecursive {
 public:
  WelzlRecursive(PointSpan<Scalar, Dim> points, Observer& observe)
      : points_(points), observe_(observe), pivoting_(points, {.tested = 1, .let_in = 1}, observe) {}

  Fit<Sphere<Scalar, Dim>> run(std::uint64_t seed) {
    list_ = random_order(points_.size(), seed);
    solve(Call{.left = points_.size()});
    if (!has_ball_) take(Support{list_.front()});
    pivoting_.drop_idle_support(1);
    // After a stop most points have not been tested; otherwise only rounding can have left one outside.
    const Fit<Sphere<Scalar, Dim>> fit = pivoting_.finish();
    observe_(Step{2, true, fit.volume, Finished{fit.support.list()}});
    return fit;
  }

 private:
  using Step = SphereStep<Scalar, Dim>;

  /// What a call keeps while those that it makes run.
  struct Call {
    Index left = 0;  // how many points of the list are its own
    Support support;
    int depth = 1;
  };

  [[nodiscard]] static int bytes_of(int calls) { return calls * static_cast<int>(sizeof(Call)); }

  void take(const Support& support) {
    const auto ball = ball_through(points_, support);
    if (!ball) return;  // only rounding can leave a dependent point outside; the last test takes care of it
    pivoting_.take(*ball);
    has_ball_ = true;
  }

  /// Leaves the smallest ball of the call's points, with its support on the boundary, as the pivoting's current one.
  void solve(const Call& call) {  // NOLINT(misc-no-recursion): the recursion is what this is about
    if (stopped_) return;
    if (call.left == 0 || call.support.size() == Dim + 1) return end(call);
    if (call.depth == kWelzlDepthLimit) return stop(call);
    const Index u = list_[call.left - 1];
    observe_(Step{6, has_ball_, pivoting_.current(), entered(call, u)});
    solve({call.left - 1, call.support, call.depth + 1});
    if (stopped_ || !outside(call, u)) return;
    Support with = call.support;
    with.add(u);
    solve({call.left - 1, with, call.depth + 1});
  }

  void end(const Call& call) {
    if (call.support.size() > 0) take(call.support);
    observe_(Step{5, has_ball_, pivoting_.current(), entered(call, kNoIndex)});
  }

  void stop(const Call& call) {
    stopped_ = true;
    observe_(Step{7, has_ball_, pivoting_.current(), RecursionStopped{call.depth, call.left, bytes_of(call.depth)}});
  }

  [[nodiscard]] static CallEntered entered(const Call& call, Index u) {
    return {u, call.left, call.support, call.depth, bytes_of(call.depth)};
  }

  [[nodiscard]] bool outside(const Call& call, Index u) {
    const Scalar square = has_ball_ ? pivoting_.square_to(u) : 0;
    const bool out = !has_ball_ || (pivoting_.outside(square) && !call.support.contains(u));
    observe_.count(Operation::kPointsTouched, 1);
    observe_.count(Operation::kDistanceTests, has_ball_ ? 1 : 0);
    if constexpr (kWatched<Observer>)
      observe_(Step{out ? 9 : 8, has_ball_, pivoting_.current(),
                    CallDecided{u, std::sqrt(static_cast<double>(square)), out, call.support, call.depth}});
    return out;
  }

  PointSpan<Scalar, Dim> points_;
  Observer& observe_;
  std::vector<Index> list_;
  Pivoting<Scalar, Dim, Observer> pivoting_;
  bool has_ball_ = false;
  bool stopped_ = false;
};

/// The smallest enclosing ball, by Welzl's recursion as lectures print it, over the points in random order.
/// points: 1 <= n <= kWelzlRecursiveLimit finite points, scene units. Expected O(n) time, O(n) stack. Where points are
/// too many for its depth, and closer together than welzl can bear, the pivoting at the end finds the ball.
template <class Scalar, int Dim, StepObserver<SphereStep<Scalar, Dim>> Observer = Ignore>
Fit<Sphere<Scalar, Dim>> welzl_recursive(PointSpan<Scalar, Dim> points, const Options& options,
                                         Observer&& observe = {}) {
  return WelzlRecursive<Scalar, Dim, std::remove_reference_t<Observer>>(points, observe).run(options.seed);
}

}  // namespace snug::fit
