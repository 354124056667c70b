// The model of which volume is worth its cost: what a program does with its bodies, and what that costs in all.
#pragma once

#include <memory>

#include "lesson/lesson.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

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

/// What one volume costs, ns each, or operations.
struct UnitCosts {
  double build = 0, update = 0, test = 0;
  double false_positives = 0;  // the share of the pairs that are apart, which it does not reject
  double exact = 0;            // of the exact test of a pair that it does not reject
};

/// Where the cost of a load goes, ns or operations.
struct TotalCost {
  double build = 0, updates = 0, tests = 0, false_positives = 0;
  [[nodiscard]] double sum() const { return build + updates + tests + false_positives; }
};

/// T = bodies C_b + frames (updates C_u + pairs C_v + pairs (1 - hit rate) f C_x)
[[nodiscard]] constexpr TotalCost total_of(const UnitCosts& costs, const Load& load) {
  const double tests = load.frames * load.pairs;
  return {load.bodies * costs.build, load.frames * load.updates * (load.deforms ? costs.build : costs.update),
          tests * costs.test, tests * (1 - load.hit_rate) * costs.false_positives * costs.exact};
}

struct LoadTables final : Tables {
  Load load;
};

/// The lesson's load, as its [load] says.
[[nodiscard]] const Load& load_of(const Lesson& lesson);

/// Reads [load] of a lesson or of a situation.
[[nodiscard]] std::shared_ptr<const LoadTables> read_load(TomlTable& table, Complaints& complaints);

/// The numbers of a load that sliders and addresses change: frames, pairs, hit rate, updates.
[[nodiscard]] std::vector<double> row_of(const Load& load);
inline constexpr std::size_t kLoadRow = 4;
/// The load with these numbers. Errors: one of them is out of range.
[[nodiscard]] tl::expected<Load, InputError> with_row(const Load& load, const std::vector<double>& row);

}  // namespace snug::lesson
