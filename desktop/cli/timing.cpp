#include "desktop/cli/timing.hpp"

#include <ctime>

#include <chrono>
#include <fstream>
#include <utility>

#include "desktop/cli/progress.hpp"

namespace snug::desktop {
namespace {

constexpr double kLeastBatch = 1e6, kMostBatch = 1e8;

/// The system's name for the processor; empty if it gives none.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return {};
}

}  // namespace

double native_now() {
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double processor_now() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

cost::Clock native_clock() { return processor_now; }

cost::TimingOptions native_timing(int repeats) {
  return {.repeats = repeats,
          .batch = cost::batch_length(cost::resolution_of(native_clock()), kLeastBatch, kMostBatch)};
}

cost::Timing time_of(std::function<void()> run, int repeats) {
  const cost::Clock clock = native_clock();
  cost::Stopwatch watch(std::move(run), native_timing(repeats));
  Progress progress("timing", repeats);
  for (int timed = 0; !watch.done();) {
    watch.step(clock);
    if (watch.timing().repeats > timed) ++timed, progress.advance();
  }
  return watch.timing();
}

cost::Provenance native_provenance() {
  return {.version = SNUG_VERSION,
          .build = SNUG_BUILD,
          .platform = "native",
          .processor = processor(),
          .clock_resolution_ns = cost::resolution_of(native_clock())};
}

}  // namespace snug::desktop
