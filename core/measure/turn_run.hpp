// Measures how loose each update's volume is over a full turn of its body, and how long one update takes.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "fit/update/updates.hpp"
#include "measure/cost_run.hpp"
#include "measure/rows.hpp"

namespace snug::cost {

/// The range over the rows whose looseness is known.
struct SlackRange {
  double least = 0, mean = 0, most = 0;
};
/// None if it is not known for any row.
[[nodiscard]] std::optional<SlackRange> slack_range(std::span<const TurnRow> rows);

/// Runs one frame after the other, and tests each volume against the points; then times the bare updates in rounds.
class TurnRun {
 public:
  /// points: must outlive the run. strategies: for points of this dimension. frames: in the full turn, at least 1.
  TurnRun(const AnyPointSet& points, std::vector<const fit::UpdateStrategy*> strategies, int frames,
          const TimingOptions& timing, Clock clock);

  /// Does one indivisible piece of work: a start, a frame or a batch.
  void step();
  [[nodiscard]] bool done() const { return at_ == strategies_.size() && (stopped_ || rounds_.done()); }
  [[nodiscard]] double progress() const;
  void stop() {
    at_ = strategies_.size();
    stopped_ = true;
  }
  [[nodiscard]] const std::vector<TurnRow>& rows() const { return rows_; }

 private:
  void add_frame();
  void finish_turn();
  void take_times();

  const AnyPointSet& points_;
  std::vector<const fit::UpdateStrategy*> strategies_;
  std::vector<Pose<double, 3>> poses_;
  Rounds rounds_;
  bool stopped_ = false;
  double noise_ = 0;       // a measure no larger than this is only rounding
  std::size_t at_ = 0;     // of strategies_
  std::size_t frame_ = 0;  // of poses_
  std::function<fit::UpdatedFrame(const Pose<double, 3>& pose)> body_;
  std::vector<TurnRow> rows_;
};

}  // namespace snug::cost
