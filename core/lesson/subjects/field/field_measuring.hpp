// What a way to cull costs on a field, measured in parts, so that no frame waits for all of it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "lesson/subjects/field/field_stage.hpp"

namespace snug::lesson {

/// What a way costs on what stands on the stage.
struct FieldMeasured {
  hierarchy::FieldCost cost;
  std::optional<double> ns;  // the median of a few runs; none without a clock. It is no figure, because figures are the
                             // same everywhere
};

class FieldMeasuring {
 public:
  /// clock: null for none; then a single run is made.
  FieldMeasuring(std::shared_ptr<const hierarchy::Field> field, const FieldStage& stage, hierarchy::FieldWay way,
                 Clock clock);
  /// Goes on for about so long, ns, and for one part at least. A way that takes the boxes one by one has parts of a few
  /// thousand boxes; others are done in one, for they are fast.
  void work(double budget);
  [[nodiscard]] bool done() const;
  [[nodiscard]] FieldMeasured result() const;

 private:
  [[nodiscard]] std::size_t boxes() const { return field_->boxes.size(); }
  double part();
  void end_run();

  std::shared_ptr<const hierarchy::Field> field_;
  hierarchy::FieldWay way_;
  Clock clock_;
  Frustum<double, 3> now_, before_;
  std::vector<query::Culling> verdicts_;
  std::vector<std::int8_t> remembered_, last_;  // the planes of the frame before; and those that a run overwrites
  bool prepared_;                               // whether the frame before is culled, if that is needed
  std::size_t at_ = 0;                          // the first box that this run has not taken
  double run_ = 0, spent_ = 0;                  // ns, of this run, and of all before
  hierarchy::FieldCost cost_, last_cost_;       // of this run, and of the one before
  std::vector<double> times_;
};

}  // namespace snug::lesson
