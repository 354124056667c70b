#include "measure/ladder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace snug::cost {
namespace {

constexpr Index kFirst = 8;
/// How far the prediction from one run may exceed the limit: it assumes the steepest growth, although part of the time
/// is constant.
constexpr double kBold = 4;
constexpr int kTriesBeforeStop = 2;
constexpr double kLeastPower = 1, kMostPower = 4;
/// In ns. The first run of a kind counts only if it takes kLong or more: with cold caches, and in a browser with code
/// that is not compiled yet, it can take ten times as long as the next. A shorter one is measured again over runs of
/// kShort in all, because a browser's clock has steps of 0.1 ms; below kTwice, twice, and the shorter counts.
constexpr double kLong = 1e7, kShort = 5e5, kTwice = 2e6;
constexpr int kMostAgain = 1000;

double time_of_one(const Clock& clock, const std::function<void()>& run) {
  const double start = clock();
  run();
  const double first = clock() - start;
  if (first >= kLong) return first;
  double shortest = std::numeric_limits<double>::infinity();
  for (int tries = first < kTwice ? 2 : 1; tries > 0; --tries) {
    const double begin = clock();
    int runs = 0;
    do run();
    while (++runs < kMostAgain && clock() - begin < kShort);
    shortest = std::min(shortest, (clock() - begin) / runs);
  }
  return shortest;
}

}  // namespace

double foreseen(double n1, double t1, double n2, double t2, double n) {
  const bool known = n1 > 0 && t1 > 0 && t2 > 0;
  const double power = known ? std::clamp(std::log(t2 / t1) / std::log(n2 / n1), kLeastPower, kMostPower) : kMostPower;
  return t2 * std::pow(n / n2, power);
}

Ladder::Ladder(const fit::Algorithm& algorithm, Index size)
    : algorithm_(algorithm), most_(std::min(size, algorithm.most_finished)), next_(std::min(kFirst, most_)) {}

double Ladder::foreseen_at(Index n) const {
  return foreseen(before_.points, before_.time, last_.points, last_.time, n);
}

bool Ladder::affordable(Index n, const Limits& limits) const {
  const double bold = before_.points > 0 ? 1 : kBold;
  return foreseen_at(n) <= bold * limits.longest &&
         foreseen(before_.points, before_.watched, last_.points, last_.watched, n) <= bold * limits.longest_watched;
}

void Ladder::choose(const Limits& limits) {
  for (const Index factor : {4, 2}) {
    next_ = reached_ > most_ / factor ? most_ : reached_ * factor;
    if (!affordable(next_, limits)) continue;
    again_ = 0;
    return;
  }
  // One delayed run is no reason to stop: the least of a few times counts.
  if (again_++ < kTriesBeforeStop) next_ = reached_;
  else done_ = true;
}

void Ladder::step(const Clock& clock, const PointsOfSize& points, const fit::Options& options, const Limits& limits) {
  const AnyPointSet& set = points(next_);
  if (!timed_) {
    now_ = {static_cast<double>(next_), time_of_one(clock, [&] { (void)algorithm_.fit(set, options); }), 0};
    timed_ = true;
    if (algorithm_.watch != nullptr) return;
  } else {
    now_.watched = time_of_one(clock, [&] { (void)algorithm_.watch(set, options, {}); });
  }
  timed_ = false;
  if (next_ == reached_) {
    last_.time = std::min(last_.time, now_.time);
    last_.watched = std::min(last_.watched, now_.watched);
  } else {
    before_ = last_;
    last_ = now_;
    reached_ = next_;
  }
  done_ = reached_ == most_;
  if (!done_) choose(limits);
}

}  // namespace snug::cost
