// Measures what accuracy costs: a row for each algorithm on one set of points. It works piece by piece, so that a page
// can draw in between and stop at any time; the finished rows stay.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "fit/update/updates.hpp"
#include "geometry/pose.hpp"
#include "measure/ladder.hpp"
#include "measure/rounding.hpp"
#include "measure/rows.hpp"
#include "measure/volume_cost.hpp"

namespace snug::cost {

struct CostOptions {
  fit::Options fit;
  TimingOptions timing;
  Limits limits;
};

/// Works on a run until the budget, ns, is used up or the run is finished. It does at least one step, and the last step
/// may exceed the budget.
template <class Run>
void advance(Run& run, const Clock& clock, double budget) {
  const double end = clock() + budget;
  do {
    if (run.done()) return;
    run.step();
  } while (clock() < end);
}

/// Times the catalogue's own fit, with the observer that ignores, and counts operations in a second run. An algorithm
/// that would take too long on all points (Limits) is measured on fewer, and its row says so; equal numbers are the
/// same points. Each row's tightness is relative to the smallest volume around the row's own points. A row is ready
/// when each of its times is measured once; then all times are measured in rounds (Rounds), and the rows follow.
class CostRun {
 public:
  /// points: must outlive the run. algorithms: they must take points of this dimension.
  CostRun(const AnyPointSet& points, std::vector<const fit::Algorithm*> algorithms, const CostOptions& options,
          Clock clock);

  CostRun(const CostRun&) = delete;  // the timed functions refer to it
  CostRun& operator=(const CostRun&) = delete;

  /// Does one indivisible piece of work: a batch, or a run within the limits.
  void step();
  [[nodiscard]] bool done() const { return at_ == algorithms_.size() && (stopped_ || rounds_.done()); }
  /// From 0 to 1; not proportional to time.
  [[nodiscard]] double progress() const;
  /// Ends the run; the finished rows stay.
  void stop() {
    at_ = algorithms_.size();
    stopped_ = true;
  }
  [[nodiscard]] const std::vector<CostRow>& rows() const { return rows_; }
  /// Goes up whenever there is a new row, or a round of times is complete.
  [[nodiscard]] int revision() const { return static_cast<int>(rows_.size()) + rounds_.round(); }

 private:
  // The pieces of a row, in order. Each returns whether it is finished; if not, it is called again.
  bool climb();
  [[nodiscard]] double whole_time(const Ladder& ladder) const;
  bool count();
  bool compare_with_hull();
  bool compare_with_smallest();
  bool time_fit();
  bool time_near();
  bool time_in_scene();
  bool time_update();
  bool time_copies(Copies where, Timing CostRow::*timing);
  /// Begins to time a run. parts: of a run; the row has the time of one.
  void start(Timing CostRow::*timing, std::function<void()> run, int parts);
  /// Goes on timing it for the first time; returns whether that is done.
  bool go_on();
  void next_batch();

  [[nodiscard]] const AnyPointSet& points_of(Index n);
  [[nodiscard]] Ladder& ladder_of(const fit::Algorithm& algorithm);
  /// Climbs one step. Returns whether the ladder's end is reached.
  bool step_up(Ladder& ladder);
  /// The volume that this algorithm, if fast enough for that many, fits to the row's points; computed once.
  [[nodiscard]] const fit::Volume3& fitted(const fit::Algorithm& algorithm);
  [[nodiscard]] const fit::Algorithm& algorithm() const { return *algorithms_[at_]; }

  const AnyPointSet& points_;
  std::vector<const fit::Algorithm*> algorithms_;
  CostOptions options_;
  Clock clock_;
  int dim_;
  bool single_;
  std::size_t at_ = 0;     // of algorithms_
  std::size_t piece_ = 0;  // of the row
  CostRow row_;
  Rounding rounding_;  // that of the row's points
  fit::Volume3 volume_;
  bool started_ = false;  // whether the time at hand was begun
  bool stopped_ = false;
  std::vector<CostRow> rows_;
  Rounds rounds_;
  /// What is timed in each of the rounds, and the rows that it is a time of.
  struct Timed {
    Timing CostRow::*timing;
    int parts;
    std::vector<std::size_t> rows;
  };
  std::vector<Timed> timed_;
  std::map<std::pair<const fit::UpdateStrategy*, Index>, std::size_t> updates_;  // one for all rows that share it
  std::map<Index, std::unique_ptr<AnyPointSet>> samples_;
  std::map<const fit::Algorithm*, Ladder> ladders_;
  std::map<std::pair<const fit::Algorithm*, Index>, fit::Volume3> fitted_;
};

/// Changes whenever a run's rows have changed.
[[nodiscard]] int revision_of(const auto& run) {
  if constexpr (requires { run.revision(); }) return run.revision();
  else return static_cast<int>(run.rows().size());
}

/// The tight update of a fitted volume, which is timed; null if there is none.
[[nodiscard]] const fit::UpdateStrategy* update_of(const fit::Algorithm& algorithm);

/// The indices of the rows that no other row beats in both time and measure, by time. Only rows measured on all points
/// count. Measures that differ only by rounding are equal.
[[nodiscard]] std::vector<std::size_t> pareto_front(std::span<const CostRow> rows);

void mark_front(std::span<CostRow> rows);

/// Whether another row of the front can be told apart from this one neither by time nor by measure.
[[nodiscard]] bool is_tied(std::span<const CostRow> rows, const CostRow& row);

/// A full turn in that many poses, about an axis that is not aligned with any coordinate axis.
[[nodiscard]] std::vector<Pose<double, 3>> full_turn(int dim, int poses);

}  // namespace snug::cost
