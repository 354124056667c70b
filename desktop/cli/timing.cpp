#include "desktop/cli/timing.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

#include "desktop/cli/progress.hpp"

namespace snug::desktop {
namespace {

using Clock = std::chrono::steady_clock;
using Nanoseconds = std::chrono::duration<double, std::nano>;

/// A millisecond: ten thousand times what reading the clock costs.
constexpr double kBatch = 1e6;
constexpr int kLargestBatch = 1'000'000;

double time_of_batch(const std::function<void()>& run, int batch) {
  const Clock::time_point start = Clock::now();
  for (int i = 0; i < batch; ++i)
    run();
  return Nanoseconds(Clock::now() - start).count();
}

/// The smallest power of two of runs that fills a batch, found by doing it, which also warms the caches.
int batch_for(const std::function<void()>& run) {
  int batch = 1;
  while (time_of_batch(run, batch) < kBatch && batch < kLargestBatch)
    batch *= 2;
  return batch;
}

double median_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

}  // namespace

Timing time_of(const std::function<void()>& run, int repeats) {
  const int batch = batch_for(run);
  std::vector<double> times;
  Progress progress("timing", repeats);
  for (int i = 0; i < repeats; ++i) {
    times.push_back(time_of_batch(run, batch) / batch);
    progress.advance();
  }
  return {median_of(times), *std::min_element(times.begin(), times.end()), repeats};
}

}  // namespace snug::desktop
