// The load that a lesson about costs states: how it is read, and which of its numbers sliders change.
#pragma once

#include <memory>

#include "lesson/lesson.hpp"
#include "lesson/toml_table.hpp"
#include "measure/load.hpp"

namespace snug::lesson {

using cost::Load, cost::TotalCost;

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
