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
/// that would take too long on all points (Limits) is measured on fewer, and its row says so: the same ones for equal
/// numbers. Each row's tightness is relative to the smallest volume around the row's own points.
class CostRun {
 public:
  /// points: must outlive the run. algorithms: they must take points of this dimension.
  CostRun(const AnyPointSet& points, std::vector<const fit::Algorithm*> algorithms, const CostOptions& options,
          Clock clock);

  CostRun(const CostRun&) = delete;  // the timed functions refer to it
  CostRun& operator=(const CostRun&) = delete;

  /// Does one indivisible piece of work: a batch, or a run within the limits.
  void step();
  [[nodiscard]] bool done() const { return at_ == algorithms_.size(); }
  /// From 0 to 1; not proportional to time.
  [[nodiscard]] double progress() const;
  /// Ends the run; the finished rows stay.
  void stop() { at_ = algorithms_.size(); }
  [[nodiscard]] const std::vector<CostRow>& rows() const { return rows_; }

 private:
  // The pieces of a row, in order. Each returns whether it is finished; if not, it is called again.
  bool climb();
  [[nodiscard]] double whole_time(const Ladder& ladder) const;
  bool take_time();
  bool count();
  bool compare_with_hull();
  bool compare_with_smallest();
  bool test_near();
  bool test_in_scene();
  bool take_update();
  /// One batch of the test against copies; returns whether it is finished.
  bool test_copies(Copies where, Timing& timing);

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
  std::optional<Stopwatch> watch_;
  int tests_ = 1;  // the number of tests in one run
  std::vector<CostRow> rows_;
  std::map<Index, std::unique_ptr<AnyPointSet>> samples_;
  std::map<const fit::Algorithm*, Ladder> ladders_;
  std::map<std::pair<const fit::Algorithm*, Index>, fit::Volume3> fitted_;
};

/// The tight update of a fitted volume, which is timed; null if there is none.
[[nodiscard]] const fit::UpdateStrategy* update_of(const fit::Algorithm& algorithm);

/// The indices of the rows that no other row beats in both time and measure, by time. Only rows measured on all points
/// count. Measures that differ only by rounding are equal.
[[nodiscard]] std::vector<std::size_t> pareto_front(std::span<const CostRow> rows);

void mark_front(std::span<CostRow> rows);

/// A full turn in that many poses, about an axis that is not aligned with any coordinate axis.
[[nodiscard]] std::vector<Pose<double, 3>> full_turn(int dim, int poses);

}  // namespace snug::cost
