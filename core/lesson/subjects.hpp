// A row for every subject: what reading, checking and opening a lesson need before the subject is on a stage.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lesson/ask.hpp"
#include "lesson/stage_sample.hpp"
#include "lesson/subject.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

class Session;

/// What is measured of what stands on the stage: costs, criteria, claims. Questions about it are predictions, which are
/// asked before the first step, when somebody wants to measure.
struct Experiment {
  std::string_view chart;            // the value of "chart" in a lesson's file that selects it
  std::string_view decided_by = "";  // what replaces time if there is no clock; empty for nothing
  /// Does it at once, for a lesson that is played without a screen.
  void (*perform)(Session& session);
};

struct SubjectRow {
  std::string_view name;                // that of its folder: "pair"
  std::string_view table;               // the table that it needs in a lesson's file: "boxes"
  std::string_view step_word = "step";  // what the timeline counts
  /// The values of "volume" in a lesson's file that select it.
  std::vector<std::string_view> (*volumes)() = nullptr;
  const Experiment* experiment = nullptr;  // null: its questions are about steps
  std::span<const Method> (*methods)(std::string_view volume) = nullptr;
  std::vector<std::string_view> (*facts)() = nullptr;           // what a question's gate may name
  std::vector<FactQuestionKind> (*question_kinds)() = nullptr;  // besides those of any step (general_question_kinds)
  bool compares = false;  // whether its methods' results are compared with a reference

  /// Reads its own tables from the file.
  void (*read)(TomlTable& table, Lesson& lesson, Complaints& complaints) = nullptr;
  /// Reads a task's "model" as rows (see Subject::rows).
  Rows (*read_model)(TomlTable& task, const Lesson& lesson, Complaints& complaints) = nullptr;
  /// What a requirement may name as its goal.
  std::span<const std::string_view> goals = {};
  /// The figures that it may name, if they are not those of results.
  std::span<const std::string_view> task_figures = {};
  /// Checks what must hold before anything is run; null for nothing. own: the subject as it opens.
  void (*check_first)(const Lesson& lesson, const Subject& own, Complaints& complaints) = nullptr;
  /// Checks a task; null: its beginning must not solve it, and its model must.
  void (*check_task)(const Lesson& lesson, const Task& task, const Subject& own, Complaints& complaints) = nullptr;
  /// Opens the subject. mesh: the lesson's, if it names one. Errors: points, boxes or bodies that cannot be made.
  tl::expected<std::unique_ptr<Subject>, InputError> (*open)(const Lesson& lesson, std::optional<io::PointFile> mesh,
                                                             Clock clock) = nullptr;
  /// All that keeps it from being opened, where `open` tells the first of it; null if that is all.
  std::vector<InputError> (*faults)(const Lesson& lesson, const std::optional<io::PointFile>& mesh) = nullptr;
  /// Plays a task's model in a session where the task was started, and grades it; null: the model's rows are set.
  tl::expected<Grade, InputError> (*play_task)(Session& session, const Task& task) = nullptr;
  /// A stage of each of its kinds of lesson, for `snug lesson table`; none if it has the figures of another subject.
  std::span<const StageSample> samples = {};
};

[[nodiscard]] std::span<const SubjectRow* const> subjects();
/// The subject that a lesson's file selects; null if there is none. chart: empty if the file has none.
[[nodiscard]] const SubjectRow* find_subject(std::string_view volume, std::string_view chart);
/// Null where there is none of that name.
[[nodiscard]] const SubjectRow* subject_named(std::string_view name);

/// A lesson's method by the lesson's name of it; null if its subject has none of that name.
[[nodiscard]] const Method* find_method(const Lesson& lesson, std::string_view name);
/// The lesson's name of a method: "k8", or "kdop/k8" if it is of another volume than the lesson's.
[[nodiscard]] std::string name_in(const Lesson& lesson, const Method& method);
/// The lesson's name of an algorithm that it offers, by either of its names; empty if it does not offer it.
[[nodiscard]] std::string offered(const Lesson& lesson, std::string_view name);
/// Whether its methods are of several volumes.
[[nodiscard]] bool is_mixed(const Lesson& lesson);
[[nodiscard]] const Method* find_method(std::span<const Method> methods, std::string_view name);

}  // namespace snug::lesson
