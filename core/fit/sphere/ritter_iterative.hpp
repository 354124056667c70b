// Ritter's sphere, shrunk and grown again over the points in random orders; the smallest is kept.
// Source: C. Ericson, "Real-Time Collision Detection", 2005, section 4.3.5: iterative refinement of Ritter's sphere.
#pragma once

#include <array>
#include <numeric>
#include <string_view>
#include <vector>

#include "fit/sphere/ritter.hpp"
#include "geometry/random.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 8> kRitterIterativePseudocode{
    "best ← S ← Ritter's result",
    "repeat 8 times",
    "  shrink S by 5 %, shuffle the points",
    "  for each point p",
    "    if p lies outside S: grow S to p",
    "  if S is smaller than best: best ← S",
    "test all points, exactly",
    "return best",
};

inline constexpr int kRitterPasses = 8;

/// Ritter's sphere, shrunk and grown again over the points in random orders; the smallest is kept.
/// points: n >= 1 finite points, scene units. O(n) time, with a larger constant; 4 n bytes.
template <class Scalar, int Dim, StepObserver<SphereStep<Scalar, Dim>> Observer = Ignore>
Fit<Sphere<Scalar, Dim>> ritter_iterative(PointSpan<Scalar, Dim> points, const Options& options,
                                          Observer&& observe = {}) {
  using Step = SphereStep<Scalar, Dim>;
  Ignore unwatched;  // the first ball is another algorithm's result, whose steps are not shown here
  Fit<Sphere<Scalar, Dim>> best = ritter(points, unwatched);
  observe.count(Operation::kPointsTouched, 3 * std::int64_t{points.size()});
  observe.count(Operation::kDistanceTests, 2 * std::int64_t{points.size()});
  observe.count(Operation::kComparisons, 2 * Dim * std::int64_t{points.size()});
  observe(Step{0, true, best.volume, Finished{best.support.list()}});

  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  Random random(options.seed);
  Sphere<Scalar, Dim> ball = best.volume;
  for (int pass = 1; pass <= kRitterPasses; ++pass) {
    const Sphere<Scalar, Dim> before = ball;
    ball.radius *= static_cast<Scalar>(0.95);
    observe(Step{2, true, ball, BallShrunk<Scalar, Dim>{pass, before}});
    Support support;
    for (std::size_t i = 0; i < order.size(); ++i) {
      std::swap(order[i], order[i + random.below(static_cast<std::uint32_t>(order.size() - i))]);
      if (grow_to_hold(ball, points[order[i]], order[i], 3, observe)) support = {order[i]};
    }
    const bool better = ball.radius < best.volume.radius;
    if (better) best = {ball, support};
    observe(Step{5, true, ball, PassJudged<Scalar, Dim>{pass, better, best.volume}});
  }
  return finish_grown(best.volume, best.support, points, 6, observe);
}

}  // namespace snug::fit
