// [[beside]] of a lesson's file: what stands on its stage beside what the stage is about, such as two answers to a
// question about it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lesson/held_volume.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// A point is a sphere of radius 0.
struct Beside {
  enum class Is : std::uint8_t { kRight, kYours, kGiven } is = Is::kGiven;  // the right answer, a wrong one, or neither
  std::string name;
  HeldVolume volume;
};

/// Reads a volume: a table with its kind, whose fields are named as in `snug overlap`. But an oriented box has "turn",
/// in degrees, instead of its axes. name: of the table, for errors.
[[nodiscard]] HeldVolume read_held_volume(const toml::table& toml, std::string name, int dim, Complaints& complaints);

/// Null if the lesson has none.
[[nodiscard]] std::shared_ptr<const std::vector<Beside>> read_beside(TomlTable& lesson, int dim,
                                                                     Complaints& complaints);

}  // namespace snug::lesson
