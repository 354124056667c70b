// Measures how long something takes, with a clock that is passed in, because core has none.
//
// This room's namespace is cost, because snug::measure is the size of a volume.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "trace/fields.hpp"

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
  bool trusted = false;          // whether the rounds agree: kMostSpread, kMostAbove
  /// Times that differ by no more cannot be told apart: the spread, but at least this share of the median. What was
  /// counted, not timed, is exact.
  [[nodiscard]] double doubt(double least) const {
    return repeats == 0 ? 0 : median * std::max(least, spread.value_or(1));
  }
  void fields(auto&& see) { SNUG_SEE(see, median, min, spread, repeats, batch, trusted); }
};

/// Times are not trusted, and marked as unreliable, if their spread is wider than this over their median, or the median
/// is farther above the shortest time than that share of it: on a busy machine all rounds but a few may be equally
/// slow.
inline constexpr double kMostSpread = 1.0 / 3, kMostAbove = 0.2;

/// The least doubt of two times of one run, and of times of two runs: between these the machine itself changes.
inline constexpr double kDoubtInRun = 0.05, kDoubtBetweenRuns = 0.25;

enum class Faster : std::uint8_t { kFirst, kSecond, kTie };
/// Which of two times is the shorter; a tie if they differ by no more than the larger doubt.
[[nodiscard]] Faster faster(const Timing& a, const Timing& b, double least_doubt);

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
  [[nodiscard]] int repeats() const { return static_cast<int>(times_.size()); }
  /// Whether the repeats took as long as is enough, though they may disagree.
  [[nodiscard]] bool spent_enough() const;

 private:
  std::function<void()> run_;
  TimingOptions options_;
  int batch_ = 1;
  bool warm_ = false;  // whether the batch is long enough
  double spent_ = 0;   // ns, in the batches that count
  std::vector<double> times_;
};

/// Times several runs in rounds, a batch of each after the other. So a second in which the machine is busy falls on all
/// of them alike, and shows as rounds that disagree. Runs that are not trusted after all rounds get more of them.
class Rounds {
 public:
  Rounds(const TimingOptions& options, Clock clock) : options_(options), clock_(std::move(clock)) {}

  /// Adds a run, and returns its number.
  std::size_t add(std::function<void()> run);
  /// Does a batch of the run that was added last. Returns whether its first time is known.
  bool start_last();
  /// Does the next batch of the round, or goes on to the next round.
  void step();
  [[nodiscard]] bool done() const { return done_ || watches_.empty(); }
  /// The round at hand, from 1.
  [[nodiscard]] int round() const { return round_; }
  /// From 0 to 1, as if no more rounds were wanted than are asked for.
  [[nodiscard]] double progress() const {
    return done() ? 1 : std::min(1.0, static_cast<double>(round_ - 1) / options_.repeats);
  }
  /// The timing so far, of one of the parts of a run.
  [[nodiscard]] Timing timing(std::size_t run, int parts = 1) const;

 private:
  /// How many times as many rounds there are at most, while times disagree.
  static constexpr int kMostLonger = 3;
  [[nodiscard]] bool wants_more(const Stopwatch& watch) const;

  TimingOptions options_;
  Clock clock_;
  std::vector<Stopwatch> watches_;
  std::size_t at_ = 0;  // the run whose turn it is
  int round_ = 1;
  bool done_ = false;
};

/// Does the whole timing at once.
[[nodiscard]] Timing time_of(const Clock& clock, std::function<void()> run, const TimingOptions& options);

}  // namespace snug::cost
