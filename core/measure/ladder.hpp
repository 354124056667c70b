// Finds how many points an algorithm can be run on before one run takes too long. A run cannot be interrupted, so its
// time is predicted from smaller runs.
#pragma once

#include <functional>
#include <optional>

#include "fit/catalogue.hpp"
#include "measure/timing.hpp"

namespace snug::cost {

/// Returns the set, or n of its points.
using PointsOfSize = std::function<const AnyPointSet&(Index n)>;

/// How long one run may take, ns.
struct Limits {
  double longest = 1e9;           // without an observer
  double longest_watched = 1e10;  // with an observer, and with the proof of its result
};

/// Predicts the time of a run on n points, if one on n1 took t1 and one on n2 > n1 took t2: by the power of n between
/// the two, clamped to 1 … 4.
[[nodiscard]] double foreseen(double n1, double t1, double n2, double t2, double n);

/// Goes up from few points by factors of four (or two, if four is too much), until all points are reached or the next
/// run would take too long, judged by the least of three times of the last.
class Ladder {
 public:
  /// algorithm: its watch may be null, and is then ignored. size: that of the whole set.
  Ladder(const fit::Algorithm& algorithm, Index size);

  /// Does one more run.
  void step(const Clock& clock, const PointsOfSize& points, const fit::Options& options, const Limits& limits);
  [[nodiscard]] bool done() const { return done_; }
  /// The number of points reached; at least a few.
  [[nodiscard]] Index reached() const { return reached_; }
  /// The time of one run on as many points as were reached, ns.
  [[nodiscard]] double time() const { return last_.time; }
  /// The predicted time of a run on n points, ns.
  [[nodiscard]] double foreseen_at(Index n) const;

 private:
  struct Rung {
    double points = 0, time = 0, watched = 0;
  };
  void choose(const Limits& limits);
  [[nodiscard]] bool affordable(Index n, const Limits& limits) const;

  const fit::Algorithm& algorithm_;
  Index most_;  // the most of the set's points that it goes through
  Index reached_ = 0;
  Index next_;
  bool timed_ = false;  // whether the run of next_ without an observer is done
  int again_ = 0;       // how often the last size was repeated
  bool done_ = false;
  Rung before_, last_, now_;
};

}  // namespace snug::cost
