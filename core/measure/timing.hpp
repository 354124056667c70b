// How long something takes, by a clock that is passed in: core owns none.
//
// This room's namespace is cost: snug::measure is how large a volume is, for longer than there has been this room.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace snug::cost {

/// Nanoseconds since some moment; it only goes forward.
using Clock = std::function<double()>;

/// The smallest step by which the clock goes on, ns, seen by reading it over and over; 0 where it stands still.
[[nodiscard]] double resolution_of(const Clock& clock);

/// How long a batch must be for the clock to tell it within a per cent, ns: a hundred of its steps, and within [least,
/// most].
[[nodiscard]] double batch_length(double resolution, double least, double most);

/// Times of one run, ns.
struct Timing {
  double median = 0;
  double min = 0;
  std::optional<double> spread;  // between the quartiles, over the median; none of a single batch
  int repeats = 0;               // batches that were timed; 0: nothing was
  int batch = 0;                 // runs in each
  bool trusted = false;          // whether there is a spread, of at most kMostSpread
  static void fields(auto& own, auto&& see) {
    see("median", own.median), see("min", own.min), see("spread", own.spread), see("repeats", own.repeats);
    see("batch", own.batch), see("trusted", own.trusted);
  }
};

/// What this machine cannot measure well is said: times that spread wider than this over their median are not trusted.
inline constexpr double kMostSpread = 1.0 / 3;

/// times: of one run each, at least one.
[[nodiscard]] Timing timing_of(std::vector<double> times, int batch);

struct TimingOptions {
  int repeats = 9;     // at least 1
  double batch = 1e6;  // ns that a batch fills at least
  /// Three repeats are enough when so much time has gone into them, ns.
  double enough = std::numeric_limits<double>::infinity();
};

/// Takes the time of a run, a batch at a time, so that what else there is to do can be done in between. The batch is
/// hardly longer than it must be, found by doing it, which also warms the caches.
class Stopwatch {
 public:
  Stopwatch(std::function<void()> run, TimingOptions options) : run_(std::move(run)), options_(options) {}

  /// One more batch.
  void step(const Clock& clock);
  [[nodiscard]] bool done() const;
  /// Done after so many batches; it may go on later, when there are to be more.
  void pause_after(int repeats) { options_.repeats = repeats; }
  /// The timing so far; empty where nothing has been timed.
  [[nodiscard]] Timing timing() const;

 private:
  std::function<void()> run_;
  TimingOptions options_;
  int batch_ = 1;
  bool warm_ = false;  // whether the batch is long enough
  double spent_ = 0;   // ns, by the batches that count
  std::vector<double> times_;
};

/// All of it at once.
[[nodiscard]] Timing time_of(const Clock& clock, std::function<void()> run, const TimingOptions& options);

}  // namespace snug::cost
