// What accuracy costs: a row for each algorithm on one set of points, measured piece by piece, so that a page can draw
// in between and stop at any time; the rows that are ready stay.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

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

/// Works on a run until the budget, ns, is used up or there is no more to do, and at least one step: the last may go
/// beyond.
template <class Run>
void advance(Run& run, const Clock& clock, double budget) {
  const double end = clock() + budget;
  do {
    if (run.done()) return;
    run.step();
  } while (clock() < end);
}

/// Takes the time of the catalogue's own fit, with the observer that ignores; counts in a second, watched run. What
/// would take too long on all points (Limits) is measured on fewer of them, and its row says so: they are the same for
/// all algorithms that get so many, and each row's tightness is against the smallest volume of the row's own points.
class CostRun {
 public:
  /// points: outlive the run. algorithms: that take points of this dimension.
  CostRun(const AnyPointSet& points, std::vector<const fit::Algorithm*> algorithms, const CostOptions& options,
          Clock clock);

  CostRun(const CostRun&) = delete;  // what it times points into it
  CostRun& operator=(const CostRun&) = delete;

  /// A piece that cannot be cut: a batch, or a run within the limits.
  void step();
  [[nodiscard]] bool done() const { return at_ == algorithms_.size(); }
  /// From 0 to 1; no measure of time.
  [[nodiscard]] double progress() const;
  /// What is ready stays; there is nothing more to do.
  void stop() { at_ = algorithms_.size(); }
  [[nodiscard]] const std::vector<CostRow>& rows() const { return rows_; }

 private:
  // The pieces of a row in their order: each returns whether it is finished, else it is called again.
  bool climb();
  [[nodiscard]] double whole_time(const Ladder& ladder) const;
  bool take_time();
  bool count();
  bool compare_with_hull();
  bool compare_with_smallest();
  bool test_overlap();
  bool take_update();

  [[nodiscard]] const AnyPointSet& points_of(Index n);
  [[nodiscard]] Ladder& ladder_of(const fit::Algorithm& algorithm);
  /// One step up; whether it is as far as it goes.
  bool step_up(Ladder& ladder);
  /// The volume that this algorithm, which can afford them, fits to the row's points; fitted once.
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
  Rounding rounding_;  // of the row's points
  fit::Volume3 volume_;
  std::optional<Stopwatch> watch_;
  int tests_ = 1;  // in one run of it
  std::vector<CostRow> rows_;
  std::map<Index, std::unique_ptr<AnyPointSet>> samples_;
  std::map<const fit::Algorithm*, Ladder> ladders_;
  std::map<std::pair<const fit::Algorithm*, Index>, fit::Volume3> fitted_;
};

/// The places of the rows that no other row undercuts in time and measure, by time. Of all points alone: what was
/// measured on fewer is no rival. Measures that differ by rounding alone are equal.
[[nodiscard]] std::vector<std::size_t> pareto_front(std::span<const CostRow> rows);

void mark_front(std::span<CostRow> rows);

/// A full turn in so many poses, about an axis that lies askew to all others.
[[nodiscard]] std::vector<Pose<double, 3>> full_turn(int dim, int poses);

}  // namespace snug::cost
