// A clock that goes on only when it is told to, or by itself if nothing else moves it.
#pragma once

#include <cmath>

#include "fit/catalogue.hpp"
#include "measure/timing.hpp"

namespace snug::test {

/// The false time, ns. One for all, for an algorithm of the catalogue is a function without a state.
inline double& false_now() {
  static double now = 0;
  return now;
}
inline cost::Clock false_clock() {
  return [] { return false_now(); };
}
inline void pass(double ns) { false_now() += ns; }
/// The same, but it ticks if it was looked at eight times in vain: what takes no false time is not repeated a thousand
/// times to fill a batch, and what takes false time is measured exactly.
inline cost::Clock ticking_clock() {
  return [last = false_now(), looks = 0]() mutable {
    looks = false_now() == last ? looks + 1 : 0;
    if (looks == 8) pass(1e5), looks = 0;
    return last = false_now();
  };
}

/// A true algorithm whose runs take false time: coefficient times n^power.
template <int kCoefficient, int kTwicePower>
fit::Result slow_fit(const AnyPointSet& points, const fit::Options& options) {
  pass(kCoefficient * std::pow(fit::count_of(points), kTwicePower / 2.0));
  return fit::find_algorithm("sphere", "ritter")->fit(points, options);
}
/// Watched it takes three times as long.
template <int kCoefficient, int kTwicePower>
fit::Watched slow_watch(const AnyPointSet& points, const fit::Options& options, const fit::SeeStep& see) {
  pass(3 * kCoefficient * std::pow(fit::count_of(points), kTwicePower / 2.0));
  return fit::find_algorithm("sphere", "ritter")->watch(points, options, see);
}
/// theory: of its time; none where nothing is said of it.
template <int kCoefficient, int kTwicePower>
fit::Algorithm slow_algorithm(std::string_view name, const fit::Theory& theory = {}) {
  fit::Algorithm algorithm = *fit::find_algorithm("sphere", "ritter");
  algorithm.name = name;
  algorithm.theory = theory;
  algorithm.fit = &slow_fit<kCoefficient, kTwicePower>;
  algorithm.watch = &slow_watch<kCoefficient, kTwicePower>;
  return algorithm;
}

}  // namespace snug::test
