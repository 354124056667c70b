#include "measure/timing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace snug::cost {
namespace {

/// How often a clock is read before it counts as standing still.
constexpr int kMostReadings = 2'000'000;
constexpr int kSteps = 10;
constexpr int kLargestBatch = 1 << 20;
constexpr double kSurelyLongEnough = 1.1;  // times a batch's length: runs differ
constexpr double kStepsPerBatch = 100;
constexpr double kFarTooShort = 0.4;  // times a batch's length: shorter than clock and caches can explain
constexpr int kFewestRepeats = 3;

/// Interpolates between the two nearest values. sorted: at least one value.
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/// The next batch to try after one that was too short: as many runs as its time suggests, but at most twice as many.
int longer(int batch, double time, double wanted) {
  const double runs = time > 0 ? std::ceil(batch * kSurelyLongEnough * wanted / time) : kLargestBatch;
  return std::clamp(static_cast<int>(std::min<double>(runs, kLargestBatch)), batch + 1, 2 * batch);
}

}  // namespace

double resolution_of(const Clock& clock) {
  double smallest = 0;
  double last = clock();
  for (int readings = 0, steps = 0; readings < kMostReadings && steps < kSteps; ++readings) {
    const double now = clock();
    if (!(now > last)) continue;
    if (steps++ == 0 || now - last < smallest) smallest = now - last;
    last = now;
  }
  return smallest;
}

double batch_length(double resolution, double least, double most) {
  return std::clamp(kStepsPerBatch * resolution, least, most);
}

Timing timing_of(std::vector<double> times, int batch) {
  std::sort(times.begin(), times.end());
  Timing timing{
      .median = quantile(times, 0.5), .min = times.front(), .repeats = static_cast<int>(times.size()), .batch = batch};
  if (times.size() < 2) return timing;  // the spread is unknown
  const double between = quantile(times, 0.75) - quantile(times, 0.25);
  timing.spread = timing.median > 0 ? between / timing.median : 0;
  timing.trusted = timing.median > 0 && *timing.spread <= kMostSpread && timing.median <= (1 + kMostAbove) * timing.min;
  return timing;
}

void Stopwatch::step(const Clock& clock) {
  const double start = clock();
  for (int i = 0; i < batch_; ++i) run_();
  const double time = clock() - start;
  if (!warm_) {
    warm_ = time >= options_.batch || batch_ >= kLargestBatch;
    if (!warm_) batch_ = longer(batch_, time, options_.batch);
    return;
  }
  if (time < options_.batch * kFarTooShort && batch_ < kLargestBatch) {
    // The batch only seemed long enough: the first one was delayed by something else.
    warm_ = false;
    spent_ = 0;
    times_.clear();
    batch_ = longer(batch_, time, options_.batch);
    return;
  }
  times_.push_back(time / batch_);
  spent_ += time;
}

bool Stopwatch::done() const { return repeats() >= options_.repeats || spent_enough(); }

bool Stopwatch::spent_enough() const { return repeats() >= kFewestRepeats && spent_ >= options_.enough; }

Timing Stopwatch::timing() const { return times_.empty() ? Timing{} : timing_of(times_, batch_); }

Faster faster(const Timing& a, const Timing& b, double least_doubt) {
  if (std::abs(a.median - b.median) <= std::max(a.doubt(least_doubt), b.doubt(least_doubt))) return Faster::kTie;
  return a.median < b.median ? Faster::kFirst : Faster::kSecond;
}

std::size_t Rounds::add(std::function<void()> run) {
  watches_.emplace_back(std::move(run), options_);
  return watches_.size() - 1;
}

bool Rounds::start_last() {
  watches_.back().step(clock_);
  return watches_.back().repeats() > 0;
}

bool Rounds::wants_more(const Stopwatch& watch) const {
  const bool disagree = options_.repeats >= kFewestRepeats && watch.repeats() < kMostLonger * options_.repeats &&
                        !watch.spent_enough() && !watch.timing().trusted;
  return !watch.done() || disagree;
}

void Rounds::step() {
  const auto wants_more = [this](const Stopwatch& watch) { return this->wants_more(watch); };
  const auto is_next = [&](const Stopwatch& watch) { return watch.repeats() < round_ && wants_more(watch); };
  while (at_ < watches_.size() && !is_next(watches_[at_])) ++at_;
  if (at_ < watches_.size()) return watches_[at_].step(clock_);
  done_ = std::none_of(watches_.begin(), watches_.end(), wants_more);
  if (done_) return;
  ++round_;
  at_ = 0;
}

Timing Rounds::timing(std::size_t run, int parts) const {
  Timing timing = watches_[run].timing();
  timing.median /= parts;
  timing.min /= parts;
  return timing;
}

Timing time_of(const Clock& clock, std::function<void()> run, const TimingOptions& options) {
  Stopwatch watch(std::move(run), options);
  while (!watch.done()) watch.step(clock);
  return watch.timing();
}

}  // namespace snug::cost
