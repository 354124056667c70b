// How many points an algorithm can be run on before one run takes too long: a run cannot be cut, so it is foreseen from
// smaller ones.
#pragma once

#include <functional>
#include <optional>

#include "fit/catalogue.hpp"
#include "measure/timing.hpp"

namespace snug::cost {

/// The set, or fewer of its points, so many.
using PointsOfSize = std::function<const AnyPointSet&(Index n)>;

/// How long one run may take, ns.
struct Limits {
  double longest = 1e9;           // unwatched
  double longest_watched = 1e10;  // watched, and its result proven
};

/// What a run of n points takes when one of n1 took t1 and one of n2 > n1 took t2: by the power of n between the two,
/// which is taken for at least 1, and at most 4.
[[nodiscard]] double foreseen(double n1, double t1, double n2, double t2, double n);

/// Goes up from few points by factors of four, of two where four is too much, until all are reached or the next run
/// would take too long, by the least of three times of the last.
class Ladder {
 public:
  /// algorithm: its watch may be null, and then counts for nothing. size: of the whole set.
  Ladder(const fit::Algorithm& algorithm, Index size);

  /// One more run.
  void step(const Clock& clock, const PointsOfSize& points, const fit::Options& options, const Limits& limits);
  [[nodiscard]] bool done() const { return done_; }
  /// Points; at least a few.
  [[nodiscard]] Index reached() const { return reached_; }
  /// The time of one run on as many points as were reached, ns.
  [[nodiscard]] double time() const { return last_.time; }
  /// What a run on so many points would take by what is known, ns.
  [[nodiscard]] double foreseen_at(Index n) const;

 private:
  struct Rung {
    double points = 0, time = 0, watched = 0;
  };
  void choose(const Limits& limits);
  [[nodiscard]] bool affordable(Index n, const Limits& limits) const;

  const fit::Algorithm& algorithm_;
  Index most_;  // that it takes of the set
  Index reached_ = 0;
  Index next_;
  bool timed_ = false;  // whether the unwatched run of next_ is done, and the watched one is to come
  int again_ = 0;       // how often the last size was taken once more, before the next is too long
  bool done_ = false;
  Rung before_, last_, now_;
};

}  // namespace snug::cost
