// Reads exercises and their sets from the disk.
#pragma once

#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/input_error.hpp"
#include "lesson/exercise/exercise.hpp"
#include "lesson/exercise/sets.hpp"

namespace snug::desktop {

struct ExerciseFile {
  std::string path;
  std::shared_ptr<const lesson::Exercise> exercise;
};

/// The exercises of a lessons folder ("" is the program's own), by id. Errors: those of the folder, and of the
/// first bad file.
[[nodiscard]] tl::expected<std::vector<ExerciseFile>, InputError> read_exercises(const std::string& folder);
/// The exercise with an id, or of the file that a path leads to. Errors: those of its file; no such exercise.
[[nodiscard]] tl::expected<ExerciseFile, InputError> find_exercise(const std::string& folder, const std::string& id);
/// Which of these files has the exercise of that id. prefix: what its id has before the file's name. Errors: none has.
[[nodiscard]] tl::expected<std::string, InputError>
path_of_exercise(const std::vector<std::string>& paths, const std::string& id, std::string_view prefix = "");
/// The files of the exercises in which a function is written; none where a class's lessons have no such folder.
[[nodiscard]] tl::expected<std::vector<std::string>, InputError> written_paths(const std::string& folder);
/// The sets of a lessons folder. Errors: those of the folder and of the file.
[[nodiscard]] tl::expected<std::vector<lesson::ExerciseSet>, InputError> read_sets_of(const std::string& folder);

}  // namespace snug::desktop
