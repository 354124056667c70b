#include "desktop/cli/exercise_files.hpp"

#include <algorithm>
#include <filesystem>

#include "desktop/cli/did_you_mean.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/cli/lesson_files.hpp"

namespace snug::desktop {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSetsFile = "sets.toml";

fs::path exercises_folder(const std::string& folder) { return folder_in_lessons(folder, "exercises"); }

tl::expected<std::vector<std::string>, InputError> exercise_paths(const std::string& folder) {
  auto paths = lesson_paths(exercises_folder(folder).string());
  if (paths) std::erase_if(*paths, [](const std::string& path) { return path.ends_with(kSetsFile); });
  return paths;
}

tl::expected<ExerciseFile, InputError> read_exercise_file(const std::string& path) {
  const auto text = read_start(path, lesson::kMostLessonBytes);
  if (!text) return tl::unexpected(text.error());
  lesson::ExerciseDraft draft = lesson::read_exercise(*text, path);
  if (!draft.mistakes.empty()) return tl::unexpected(draft.mistakes.front().error());
  return ExerciseFile{path, std::make_shared<const lesson::Exercise>(std::move(draft.exercise))};
}

}  // namespace

tl::expected<std::vector<ExerciseFile>, InputError> read_exercises(const std::string& folder) {
  const auto paths = exercise_paths(folder);
  if (!paths) return tl::unexpected(paths.error());
  std::vector<ExerciseFile> files;
  for (const std::string& path : *paths) {
    auto file = read_exercise_file(path);
    if (!file) return tl::unexpected(std::move(file.error()));
    files.push_back(*std::move(file));
  }
  return files;
}

tl::expected<ExerciseFile, InputError> find_exercise(const std::string& folder, const std::string& id) {
  if (is_path(id)) return read_exercise_file(id);
  const auto paths = exercise_paths(folder);
  if (!paths) return tl::unexpected(paths.error());
  for (const std::string& path : *paths)
    if (id_of(path) == id) return read_exercise_file(path);
  std::vector<std::string> known;
  for (const std::string& path : *paths) known.push_back(id_of(path));
  return tl::unexpected(InputError{.what = "there is no exercise \"" + id + "\"; `snug exercise list` lists them" +
                                           did_you_mean(id, known)});
}

tl::expected<std::vector<lesson::ExerciseSet>, InputError> read_sets_of(const std::string& folder) {
  const auto paths = exercise_paths(folder);
  if (!paths) return tl::unexpected(paths.error());
  std::vector<std::string> ids;
  for (const std::string& path : *paths) ids.push_back(id_of(path));
  const fs::path path = exercises_folder(folder) / kSetsFile;
  std::error_code error;
  if (!fs::exists(path, error)) return std::vector<lesson::ExerciseSet>();
  return read_start(path.string(), lesson::kMostLessonBytes).and_then([&](const std::string& text) {
    return lesson::read_sets(text, path.string(), ids);
  });
}

}  // namespace snug::desktop
