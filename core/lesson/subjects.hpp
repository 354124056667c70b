// Every subject, a row each: what a lesson's file, its check and its door ask of one before it stands on a stage.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lesson/ask.hpp"
#include "lesson/subject.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

class Session;

struct SubjectRow {
  std::string_view name;                // its folder's: "pair"
  std::string_view table;               // of a lesson's file, without which there is none: "boxes"
  std::string_view step_word = "step";  // what the timeline counts
  /// The values of "volume" in a lesson's file that mean it.
  std::vector<std::string_view> (*volumes)() = nullptr;
  std::string_view chart = "";  // the value of "chart" that means it; empty for none
  std::span<const Method> (*methods)(std::string_view volume) = nullptr;
  std::vector<std::string_view> (*facts)() = nullptr;  // what a question's gate may name
  std::vector<AskingOf> (*askings)() = nullptr;        // beside "point" and "choice"
  std::string_view decided_by = "";  // in the place of time, where there is no clock; empty: it is not
  bool asks_of_steps = true;         // false: its questions stand before the first step, without a gate

  /// Reads its own tables of the file.
  void (*read)(TomlTable& table, Lesson& lesson, Complaints& complaints) = nullptr;
  void (*read_task)(TomlTable& table, Lesson& lesson, Complaints& complaints) = nullptr;
  /// What must hold before anything is run; null for nothing. own: as it opens.
  void (*check_first)(const Lesson& lesson, const Subject& own, Complaints& complaints) = nullptr;
  /// What must hold of the lesson beside its questions; null for nothing.
  void (*check)(const Lesson& lesson, const toml::table& toml, const Subject& own, Complaints& complaints) = nullptr;
  /// mesh: what the lesson names, where it names one. Errors: of points, boxes or bodies that cannot be made.
  tl::expected<std::unique_ptr<Subject>, InputError> (*open)(const Lesson& lesson, std::optional<io::PointFile> mesh,
                                                             Clock clock) = nullptr;
  /// Does the task's model answers in a session, one after the other, and returns the last one's grade. null: loads the
  /// task's model, points.
  tl::expected<Grade, InputError> (*play_task)(Session& session) = nullptr;
  /// What has to be done before questions can be answered; null for nothing.
  void (*before_play)(Session& session) = nullptr;
};

[[nodiscard]] std::span<const SubjectRow* const> subjects();
/// The subject that a lesson's file asks for; null where none has that. chart: empty where the file has none.
[[nodiscard]] const SubjectRow* find_subject(std::string_view volume, std::string_view chart);
/// Null where there is none of that name.
[[nodiscard]] const SubjectRow* subject_named(std::string_view name);

/// A lesson's method; null where its subject offers none of that name.
[[nodiscard]] const Method* find_method(const Lesson& lesson, std::string_view name);
[[nodiscard]] const Method* find_method(std::span<const Method> methods, std::string_view name);

}  // namespace snug::lesson
