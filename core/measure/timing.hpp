// Measures how long something takes, with a clock that is passed in, because core has none.
//
// This room's namespace is cost, because snug::measure is the size of a volume.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace snug::cost {

/// Nanoseconds since some moment; never goes back.
using Clock = std::function<double()>;

/// The smallest step of the clock, ns, found by reading it over and over; 0 if it stands still.
[[nodiscard]] double resolution_of(const Clock& clock);

/// How long a batch must be to be timed within one per cent, ns: a hundred steps of the clock, clamped to [least,
/// most].
[[nodiscard]] double batch_length(double resolution, double least, double most);

/// Times of one run, ns.
struct Timing {
  double median = 0;
  double min = 0;
  std::optional<double> spread;  // between the quartiles, over the median; none for a single batch
  int repeats = 0;               // the number of timed batches; 0: nothing was timed
  int batch = 0;                 // runs in each
  bool trusted = false;          // whether there is a spread, of at most kMostSpread
  static void fields(auto& own, auto&& see) {
    see("median", own.median), see("min", own.min), see("spread", own.spread), see("repeats", own.repeats);
    see("batch", own.batch), see("trusted", own.trusted);
  }
};

/// Times whose spread is wider than this over their median are not trusted, and marked as unreliable.
inline constexpr double kMostSpread = 1.0 / 3;

/// times: each that of one run; at least one.
[[nodiscard]] Timing timing_of(std::vector<double> times, int batch);

struct TimingOptions {
  int repeats = 9;     // at least 1
  double batch = 1e6;  // ns that a batch fills at least
  /// Three repeats are enough once they have taken this long, ns.
  double enough = std::numeric_limits<double>::infinity();
};

/// Times a run, one batch at a time, so that other work can be done in between. The size of a batch is found by trying,
/// which also warms the caches, and is hardly larger than it must be.
class Stopwatch {
 public:
  Stopwatch(std::function<void()> run, TimingOptions options) : run_(std::move(run)), options_(options) {}

  /// Does one more batch.
  void step(const Clock& clock);
  [[nodiscard]] bool done() const;
  /// Counts as done after that many batches; it can go on later with a larger number.
  void pause_after(int repeats) { options_.repeats = repeats; }
  /// The timing so far; empty if nothing has been timed.
  [[nodiscard]] Timing timing() const;

 private:
  std::function<void()> run_;
  TimingOptions options_;
  int batch_ = 1;
  bool warm_ = false;  // whether the batch is long enough
  double spent_ = 0;   // ns, in the batches that count
  std::vector<double> times_;
};

/// Does the whole timing at once.
[[nodiscard]] Timing time_of(const Clock& clock, std::function<void()> run, const TimingOptions& options);

}  // namespace snug::cost
