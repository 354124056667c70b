// A clock that goes on only when it is told to, or by a little at each reading.
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
/// The same, but each look at it takes 5 µs: what takes no false time is not repeated until a batch is full.
inline cost::Clock ticking_clock() {
  return [] {
    pass(5000);
    return false_now();
  };
}

/// A true algorithm whose runs take false time: coefficient times n^power.
template <int kCoefficient, int kTwicePower>
fit::Result slow_fit(const AnyPointSet& points, const fit::Options& options) {
  pass(kCoefficient * std::pow(fit::size_of(points), kTwicePower / 2.0));
  return fit::find_algorithm("sphere", "ritter")->fit(points, options);
}
/// Watched it takes three times as long.
template <int kCoefficient, int kTwicePower>
fit::Watched slow_watch(const AnyPointSet& points, const fit::Options& options, const fit::SeeStep& see) {
  pass(3 * kCoefficient * std::pow(fit::size_of(points), kTwicePower / 2.0));
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
