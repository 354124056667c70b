// Time against the number of points, and the power of it that the times follow, beside theory's.
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

/// Something that can be done to so many points.
struct Workload {
  std::string volume, algorithm;
  Index most = 0;                      // points that it takes
  std::string theory;                  // as it is said; empty where there is none
  double (*work)(double n) = nullptr;  // theory's, up to a factor; null where points alone do not say
  bool tight = false;
  /// A piece of what comes before; whether all of it is done. None where nothing does.
  std::function<bool(Index n)> make_ready;
  /// What is timed on n points.
  std::function<std::function<void()>(Index n)> prepare;
};

/// An algorithm of the catalogue on points that come in any number. most: there are.
[[nodiscard]] Workload workload_of(const fit::Algorithm& algorithm, int dim, Index most,
                                   std::shared_ptr<PointStock> points, const fit::Options& options);

/// The numbers from ten to most by half decades, and most itself; where that is few, five numbers in equal steps of a
/// factor.
[[nodiscard]] std::vector<Index> growth_sizes(Index most);

struct SizedTime {
  double points = 0, time = 0;
};
/// The power: the slope of the line of least squares through the logarithms. None of fewer than three, or where a time
/// is 0.
[[nodiscard]] std::optional<double> power_of(std::span<const SizedTime> times);

/// What is said in a power's place where none can be told: the points are too few, or their numbers too close together.
inline constexpr std::string_view kTooFewToTell = "too few points to tell";

/// So far below the largest number of points a time still counts for the power: what does not grow is felt below.
inline constexpr double kTail = 32;

/// Times each workload on more and more points, until all are reached or one run would take longer than is allowed, and
/// once more on the way back, half of the batches each way: a second in which the machine does other things as well
/// meets no number of points both times, and does not bend the line.
class GrowthRun {
 public:
  /// longest: one run, ns.
  GrowthRun(std::vector<Workload> workloads, const TimingOptions& timing, double longest, Clock clock)
      : workloads_(std::move(workloads)), timing_(timing), longest_(longest), clock_(std::move(clock)) {}

  /// A piece that cannot be cut.
  void step();
  [[nodiscard]] bool done() const { return at_ == workloads_.size(); }
  [[nodiscard]] double progress() const;
  /// What is ready stays, the powers of unfinished workloads are fitted through what there is.
  void stop();
  [[nodiscard]] const std::vector<GrowthRow>& rows() const { return rows_; }

 private:
  [[nodiscard]] std::span<GrowthRow> own_rows() { return std::span(rows_).subspan(first_); }
  void step_up();
  void step_back();
  /// The search goes back from here. stopped: why there are no more points.
  void turn(std::string stopped);
  /// Fits the power, and goes on to the next workload.
  void finish();

  std::vector<Workload> workloads_;
  TimingOptions timing_;
  double longest_;
  Clock clock_;
  std::size_t at_ = 0;  // of workloads_
  std::vector<Index> sizes_;
  std::size_t size_ = 0;   // of sizes_: on the way up the one to come, on the way back the one that was left last
  std::size_t first_ = 0;  // of rows_, that is the workload's
  std::vector<Stopwatch> watches_;      // of sizes_
  std::optional<std::string> stopped_;  // why there are no more points; none on the way up
  std::vector<GrowthRow> rows_;
};

}  // namespace snug::cost
