// The smallest enclosing ball by pivoting: the point farthest outside enters the support set, again and again.
// Source: B. Gärtner, "Fast and robust smallest enclosing balls", 1999: farthest-point pivoting. Here a pass finds the
// farthest point of each block, because it costs more than a few changes of the support set.
#pragma once

#include <array>
#include <numeric>
#include <string_view>
#include <vector>

#include "fit/sphere/pivoting.hpp"
#include "geometry/random.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 7> kPivotPseudocode{
    "S ← smallest of a few random points",
    "repeat",
    "  test all points: the farthest of each block",
    "  while one of these lies outside",
    "    S ← smallest of its support and the farthest",
    "until no point lies outside",
    "return S",
};

/// A larger sample would cost more in balls than it saves in passes over the points.
inline constexpr Index kPivotSample = 8;

/// A random sample of the points, by index; all points, if there are fewer than kPivotSample.
inline std::vector<Index> random_sample(Index points, std::uint64_t seed) {
  std::vector<Index> sample(std::min(points, kPivotSample));
  std::iota(sample.begin(), sample.end(), Index{0});
  if (points <= kPivotSample) return sample;
  Random random(seed);
  for (Index& i : sample) i = static_cast<Index>(random.below(static_cast<std::uint32_t>(points)));
  return sample;
}

/// The smallest enclosing ball, by farthest-point pivoting. Other algorithms' excess is computed against it. points: n
/// >= 1 finite points, scene units. O(n) time for each pass. There are few passes, but no bound on their number is
/// proven. O(sqrt n) memory.
/// Where points are closer together than about 1e-154 (in float 1e-19), squared distances underflow: the sphere then
/// contains them all but need not be the smallest. The catalogue's rows enlarge such points first (tiny.hpp).
template <class Scalar, int Dim, StepObserver<SphereStep<Scalar, Dim>> Observer = Ignore>
Fit<Sphere<Scalar, Dim>> pivot(PointSpan<Scalar, Dim> points, const Options& options, Observer&& observe = {}) {
  using Step = SphereStep<Scalar, Dim>;
  Pivoting<Scalar, Dim, std::remove_reference_t<Observer>> pivoting(points, {.tested = 2, .let_in = 4}, observe);
  const std::vector<Index> sample = random_sample(points.size(), options.seed);
  pivoting.replace(*ball_through(points, Support{sample.front()}), sample.front(), 0);
  pivoting.let_in(sample, 0);
  const Fit<Sphere<Scalar, Dim>> fit = pivoting.finish();
  observe(Step{6, true, fit.volume, Finished{fit.support.list()}});
  return fit;
}

}  // namespace snug::fit
