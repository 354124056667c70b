// What reading a lesson's file and an exercise's have in common.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lesson/lesson.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// The file's name without folders and .toml.
[[nodiscard]] std::string id_of(std::string_view name);

/// Reads the tables of a lesson as they are written, without running it. None if what stands on its stage could not be
/// read.
[[nodiscard]] std::optional<Lesson> read_as_written(const toml::table& toml, std::string_view name,
                                                    Complaints& complaints);

}  // namespace snug::lesson
