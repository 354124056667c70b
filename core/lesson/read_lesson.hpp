// What reading a lesson's file, reading an exercise's, and checking a lesson (core/check) have in common.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/lesson.hpp"
#include "lesson/read_situations.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// The file's name without folders and .toml.
[[nodiscard]] std::string id_of(std::string_view name);

/// The hash of a file's text, by which a result says what it was done on.
[[nodiscard]] std::uint64_t hash_of_text(std::string_view text);

/// Reads the tables of a lesson as they are written, without running it. None if what stands on its stage could not be
/// read.
[[nodiscard]] std::optional<Lesson> read_as_written(const toml::table& toml, std::string_view name,
                                                    Complaints& complaints);

/// A lesson's file as it was read, with what has mistakes.
struct Reading {
  std::optional<toml::table> toml;  // none if it is not TOML
  Lesson lesson;
  std::optional<Stages> stages;  // none if what stands on the stage cannot be known
  std::vector<NameBeside> names_beside;
};
[[nodiscard]] Reading read_file(std::string_view text, std::string_view name, Complaints& complaints);

/// Checks that the steps named by a question's gate exist. fits: the names to suggest, those of its algorithm's run if
/// it is known.
[[nodiscard]] bool check_gate(const Gate& gate, const SubjectRow& subject, const std::vector<std::string_view>& fits,
                              Complaints& complaints);
/// Checks the questions as far as that is possible without a run, and removes those with mistakes.
void check_gates(Lesson& lesson, Complaints& complaints);
/// Removes sliders, tasks and questions that have mistakes.
void keep_sound(Lesson& lesson);

/// The draft of a file. draws: whether its lesson can be shown.
[[nodiscard]] Draft finished(Reading reading, bool draws, const Complaints& complaints);

}  // namespace snug::lesson
