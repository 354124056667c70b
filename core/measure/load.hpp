// The model of which volume is worth its cost: what a program does with its bodies, and what that costs in all.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "measure/criteria_run.hpp"
#include "measure/rows.hpp"

namespace snug::cost {

/// What a program asks of its bounding volumes.
struct Load {
  double bodies = 1;      // as many volumes are computed, once
  double frames = 1000;   // and then in each frame:
  double updates = 1;     // so many volumes are updated
  double pairs = 1000;    // and so many pairs of volumes are tested
  double hit_rate = 0.1;  // the share of these whose bodies do overlap
  bool deforms = false;   // whether bodies change their shape, so that an update is a new fit
  friend bool operator==(const Load&, const Load&) = default;
  /// Whether bodies keep their orientation.
  [[nodiscard]] bool still() const { return updates == 0; }
};

/// Where the cost of a load goes, ns or operations.
struct TotalCost {
  double build = 0, updates = 0, tests = 0, false_positives = 0;
  [[nodiscard]] double sum() const { return build + updates + tests + false_positives; }
};

/// T = bodies C_b + frames (updates C_u + pairs C_v + pairs (1 - hit rate) f C_x): for one of the rows. C_x, the cost
/// of the exact test, is the test of the hull's row. None if there is no such row, or none for a hull.
[[nodiscard]] std::optional<TotalCost> total_of(std::span<const CriteriaRow> rows, std::size_t row, const Load& load);

/// The rows as a table, with the load and where its cost goes.
[[nodiscard]] std::vector<WhichRow> which_rows(std::span<const CriteriaRow> rows, const Load& load);

}  // namespace snug::cost
