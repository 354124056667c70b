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
constexpr std::size_t kFewestRepeats = 3;

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
  timing.trusted = timing.median > 0 && *timing.spread <= kMostSpread;
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
    warm_ = false, spent_ = 0;
    times_.clear();
    batch_ = longer(batch_, time, options_.batch);
    return;
  }
  times_.push_back(time / batch_);
  spent_ += time;
}

bool Stopwatch::done() const {
  return times_.size() >= static_cast<std::size_t>(options_.repeats) ||
         (times_.size() >= kFewestRepeats && spent_ >= options_.enough);
}

Timing Stopwatch::timing() const { return times_.empty() ? Timing{} : timing_of(times_, batch_); }

Timing time_of(const Clock& clock, std::function<void()> run, const TimingOptions& options) {
  Stopwatch watch(std::move(run), options);
  while (!watch.done()) watch.step(clock);
  return watch.timing();
}

}  // namespace snug::cost
