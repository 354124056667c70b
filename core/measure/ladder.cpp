#include "measure/ladder.hpp"

#include <algorithm>
#include <cmath>

namespace snug::cost {
namespace {

constexpr Index kFirst = 16;
constexpr double kLeastPower = 1, kMostPower = 4;
/// A run shorter than this is done again, and the shorter time counts, ns: the first of a kind finds the caches empty.
constexpr double kShort = 2e6;

}  // namespace

double foreseen(double n1, double t1, double n2, double t2, double n) {
  const bool known = n1 > 0 && t1 > 0 && t2 > 0;
  const double power = known ? std::clamp(std::log(t2 / t1) / std::log(n2 / n1), kLeastPower, kMostPower) : kMostPower;
  return t2 * std::pow(n / n2, power);
}

Ladder::Ladder(const fit::Algorithm& algorithm, Index size)
    : algorithm_(algorithm), most_(std::min(size, algorithm.max_points)), next_(std::min(kFirst, most_)) {}

double Ladder::foreseen_at(Index n) const {
  return foreseen(before_.points, before_.time, last_.points, last_.time, n);
}

bool Ladder::affordable(Index n, const Limits& limits) const {
  return foreseen_at(n) <= limits.longest &&
         foreseen(before_.points, before_.watched, last_.points, last_.watched, n) <= limits.longest_watched;
}

void Ladder::choose(const Limits& limits) {
  for (const Index factor : {4, 2}) {
    next_ = reached_ > most_ / factor ? most_ : reached_ * factor;
    if (affordable(next_, limits)) return;
  }
  done_ = true;
}

void Ladder::step(const Clock& clock, const PointsOfSize& points, const fit::Options& options, const Limits& limits) {
  const AnyPointSet& set = points(next_);
  const double start = clock();
  if (!timed_) {
    (void)algorithm_.fit(set, options);
    const double first = clock() - start;
    if (first < kShort) (void)algorithm_.fit(set, options);
    now_ = {static_cast<double>(next_), first < kShort ? std::min(first, clock() - start - first) : first, 0};
    timed_ = true;
    if (algorithm_.watch != nullptr) return;
  } else {
    (void)algorithm_.watch(set, options, {});
    now_.watched = clock() - start;
  }
  timed_ = false;
  before_ = last_, last_ = now_;
  reached_ = next_;
  done_ = reached_ == most_;
  if (!done_) choose(limits);
}

}  // namespace snug::cost
