// Welzl's algorithm as textbooks print it, in the points' own scalar: circumspheres and tests are rounded, and nothing
// is checked afterwards. welzl.hpp is the careful one beside it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "fit/sphere/naive_steps.hpp"
#include "fit/sphere/random_order.hpp"
#include "fit/sphere/rounded_circumsphere.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 10> kWelzlNaivePseudocode{
    "list ← the points in random order",
    "S ← solve(list, none fixed)",
    "return S",
    "solve(list, fixed):",
    "  S ← circumsphere of the fixed points",
    "  for each point p in the list",
    "    if |p − c|² > r · r",
    "      S ← solve(before p, fixed + p)",
    "      move p to the front of the list",
    "  return S",
};
inline constexpr std::array<std::string_view, 10> kWelzlEpsilonPseudocode = [] {
  auto lines = kWelzlNaivePseudocode;
  lines[6] = "    if |p − c| > r + 0.000001";
  return lines;
}();

/// Callers refuse more points: every test is a step that is shown.
inline constexpr Index kWelzlNaiveLimit = 1000;
/// The run is stopped after so many tests for each point, and as many more. Where arithmetic is exact, a few dozen are
/// expected; rounded tests promise nothing.
inline constexpr Index kMostTestsPerPoint = 100;

/// The test as it is usually printed.
struct NoEpsilon {
  template <class Scalar>
  static bool outside(Scalar square, Scalar radius) {
    return square > radius * radius;
  }
};
/// The usual remedy: an absolute epsilon, whatever the size of the points.
struct AbsoluteEpsilon {
  static constexpr double kEpsilon = 1e-6;  // scene units
  template <class Scalar>
  static bool outside(Scalar square, Scalar radius) {
    return std::sqrt(square) > radius + static_cast<Scalar>(kEpsilon);
  }
};

/// The state of one run. Test: NoEpsilon or AbsoluteEpsilon.
template <class Test, class Scalar, int Dim, class Observer>
class WelzlNaive {
 public:
  WelzlNaive(PointSpan<Scalar, Dim> points, Observer& observe)
      : points_(points), observe_(observe), left_(kMostTestsPerPoint * (points.size() + 1)) {}

  Fit<Sphere<Scalar, Dim>> run(std::uint64_t seed) {
    list_ = random_order(points_.size(), seed);
    solve(points_.size(), {});
    observe_(Step{2, true, ball_, Finished{support_.list()}});
    return {ball_, support_};
  }

 private:
  using Step = NaiveSphereStep<Scalar, Dim>;

  /// Leaves the ball of the first `end` points of the list that has the fixed ones on its boundary. The calls are at
  /// most Dim + 2 deep.
  void solve(Index end, const Support& fixed) {  // NOLINT(misc-no-recursion): the recursion is what this is about
    if (fixed.size() == Dim + 1) return;
    for (Index at = 0; at < end && !stopped_; ++at) {
      const Index point = list_[at];
      if (!outside(point, fixed) || stopped_) continue;
      Support with = fixed;
      with.add(point);
      if (!take(with)) continue;
      solve(at, with);
      if (!stopped_) move_to_front(at, fixed.size());
    }
  }

  [[nodiscard]] bool outside(Index i, const Support& fixed) {
    if (left_-- == 0) return stop();
    const Scalar square = has_ball_ ? (points_[i] - ball_.center).squaredNorm() : Scalar(0);
    const bool out = !has_ball_ || (!fixed.contains(i) && Test::outside(square, ball_.radius));
    observe_.count(Operation::kPointsTouched, 1);
    observe_.count(Operation::kDistanceTests, has_ball_ ? 1 : 0);
    if constexpr (kWatched<Observer>)
      observe_(Step{out ? 7 : 6, has_ball_, ball_,
                    PointExamined{i, std::sqrt(static_cast<double>(square)), out, fixed.size()}});
    return out;
  }

  bool stop() {
    stopped_ = true;
    observe_(Step{6, has_ball_, ball_, TestsExhausted{kMostTestsPerPoint * (points_.size() + 1)}});
    return false;
  }

  bool take(const Support& support) {
    observe_.count(Operation::kBallSolves, 1);
    const auto sphere = rounded_circumsphere(points_, support);
    if (!sphere) {
      observe_(Step{4, has_ball_, ball_, CircumsphereFailed{support}});
      return false;
    }
    ball_ = *sphere;
    support_ = support;
    has_ball_ = true;
    observe_(Step{4, true, ball_, BoundaryForced{support, support.size()}});
    return true;
  }

  void move_to_front(Index at, int depth) {
    const auto place = list_.begin() + at;
    const Index point = *place;
    std::rotate(list_.begin(), place, place + 1);
    observe_(Step{8, true, ball_, MovedToFront{point, depth}});
  }

  PointSpan<Scalar, Dim> points_;
  Observer& observe_;
  std::vector<Index> list_;
  Sphere<Scalar, Dim> ball_{Vector<Scalar, Dim>::Zero(), 0};
  Support support_;
  Index left_;  // tests
  bool has_ball_ = false, stopped_ = false;
};

/// A ball that would be the smallest, if numbers were not rounded: points may be left outside it.
/// points: 1 <= n <= kWelzlNaiveLimit finite points, scene units. At most kMostTestsPerPoint (n + 1) tests.
template <class Test, class Scalar, int Dim, StepObserver<NaiveSphereStep<Scalar, Dim>> Observer = Ignore>
Fit<Sphere<Scalar, Dim>> welzl_naive(PointSpan<Scalar, Dim> points, const Options& options, Observer&& observe = {}) {
  return WelzlNaive<Test, Scalar, Dim, std::remove_reference_t<Observer>>(points, observe).run(options.seed);
}

}  // namespace snug::fit
