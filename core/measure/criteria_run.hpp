// The five criteria of a bounding volume, measured for several volumes around the same points: the overlap test,
// looseness, computing it, updating it, memory. And how often each says "may overlap" wrongly.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "measure/cost_run.hpp"
#include "measure/false_positives.hpp"

namespace snug::cost {

struct CriteriaRow {
  CostRow costs;  // of the algorithm that fits the volume, as `snug cost` prints them
  Timing update;  // one update after a rotation: the catalogue's, or else every number of it is rotated
  FalsePositives passes;
};

/// Works piece by piece, as CostRun does, so that a page can draw in between.
class CriteriaRun {
 public:
  /// points: must outlive the run. algorithms: they must take points of this dimension. still: whether the body keeps
  /// its orientation.
  CriteriaRun(const AnyPointSet& points, std::vector<const fit::Algorithm*> algorithms, bool still,
              const CostOptions& options, Clock clock);
  CriteriaRun(const CriteriaRun&) = delete;  // the timed functions refer to it
  CriteriaRun& operator=(const CriteriaRun&) = delete;

  /// Does one indivisible piece of work.
  void step();
  [[nodiscard]] bool done() const { return piece_ == kPieces; }
  /// From 0 to 1; not proportional to time.
  [[nodiscard]] double progress() const;
  /// Ends the run. There are no rows then.
  void stop() { piece_ = kPieces; }
  /// A row for each algorithm, once all is measured; none before.
  [[nodiscard]] const std::vector<CriteriaRow>& rows() const { return rows_; }

 private:
  static constexpr int kPieces = 4;
  // The pieces, in order. Each returns whether it is finished; if not, it is called again.
  bool measure_costs();
  bool fit_volume();
  bool take_update();
  bool test_pair();

  const AnyPointSet& points_;
  std::vector<const fit::Algorithm*> algorithms_;
  bool still_;
  CostOptions options_;
  Clock clock_;
  CostRun costs_;
  int piece_ = 0;
  std::vector<fit::Volume3> volumes_;
  std::vector<Timing> updates_;
  std::optional<Stopwatch> watch_;
  std::optional<FalsePositiveRun> passes_;
  std::vector<CriteriaRow> rows_;
};

/// The same without a clock: counted operations instead of nanoseconds, and no repeats. An update counts what the
/// catalogue's counts, or else each number of the volume once; a test counts the numbers of both volumes once for each
/// axis or turn.
[[nodiscard]] std::vector<CriteriaRow> counted_criteria(const AnyPointSet& points,
                                                        const std::vector<const fit::Algorithm*>& algorithms,
                                                        bool still, const fit::Options& options);

}  // namespace snug::cost
