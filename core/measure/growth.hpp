// Time against the number of points, and the power of n that the times follow, compared with the theory's.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/catalogue.hpp"
#include "measure/point_stock.hpp"
#include "measure/rows.hpp"

namespace snug::cost {

/// Work that can be done on any number of points.
struct Workload {
  std::string volume, algorithm;
  Index most = 0;                      // the most points that it takes, or goes through
  std::string ends;                    // why there are no more, where there are; empty otherwise
  std::string theory;                  // as text; empty if there is none
  double (*work)(double n) = nullptr;  // the theory's, up to a factor; null if it does not depend on n alone
  bool tight = false;
  /// Does a piece of the preparation, and returns whether all of it is done. Empty if nothing needs preparing.
  std::function<bool(Index n)> make_ready;
  /// Returns the function that is timed on n points.
  std::function<std::function<void()>(Index n)> prepare;
};

/// An algorithm of the catalogue, on points from a stock. most: how many points there are.
[[nodiscard]] Workload workload_of(const fit::Algorithm& algorithm, int dim, Index most,
                                   std::shared_ptr<PointStock> points, const fit::Options& options);

/// The sizes from ten to most by half decades, and most itself; if most is small, five sizes in a geometric
/// sequence.
[[nodiscard]] std::vector<Index> growth_sizes(Index most);

struct SizedTime {
  double points = 0, time = 0;
};
/// The power: the slope of the line of least squares through the logarithms. None if there are fewer than three, or if
/// a time is 0.
[[nodiscard]] std::optional<double> power_of(std::span<const SizedTime> times);

/// Shown instead of the power if none can be fitted: there are too few points, or the sizes are too close together.
inline constexpr std::string_view kTooFewToTell = "too few points to tell";

/// Whether a line ends there because a run on more points is stopped by its own limit.
[[nodiscard]] bool ends_at_own_limit(const GrowthRow& row);

/// Sizes down to this fraction of the largest count for the power; below that, constant parts of the time show.
inline constexpr double kTail = 32;

/// Times each workload on more and more points, until all are reached or one run would take longer than allowed, and
/// then once more on the way back, with half of the batches each way. So a second in which the machine is busy affects
/// no size both times, and does not bend the line.
class GrowthRun {
 public:
  /// longest: the longest that one run may take, ns.
  GrowthRun(std::vector<Workload> workloads, const TimingOptions& timing, double longest, Clock clock)
      : workloads_(std::move(workloads)), timing_(timing), longest_(longest), clock_(std::move(clock)) {}

  /// Does one indivisible piece of work.
  void step();
  [[nodiscard]] bool done() const { return at_ == workloads_.size(); }
  [[nodiscard]] double progress() const;
  /// Ends the run; finished times stay, and the powers of unfinished workloads are fitted through what there is.
  void stop();
  [[nodiscard]] const std::vector<GrowthRow>& rows() const { return rows_; }

 private:
  [[nodiscard]] std::span<GrowthRow> own_rows() { return std::span(rows_).subspan(first_); }
  void step_up();
  void step_back();
  /// Starts the way back. stopped: why there are no more points.
  void turn(std::string stopped);
  /// Fits the power, and goes on to the next workload.
  void finish();

  std::vector<Workload> workloads_;
  TimingOptions timing_;
  double longest_;
  Clock clock_;
  std::size_t at_ = 0;  // of workloads_
  std::vector<Index> sizes_;
  std::size_t size_ = 0;   // index into sizes_: on the way up the next size, on the way back the last one timed
  std::size_t first_ = 0;  // index of the workload's first row in rows_
  std::vector<Stopwatch> watches_;      // one for each of sizes_
  std::optional<std::string> stopped_;  // why there are no more points; none while on the way up
  std::vector<GrowthRow> rows_;
};

}  // namespace snug::cost
