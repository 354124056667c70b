#include "desktop/cli/exercise_files.hpp"

#include <algorithm>
#include <filesystem>

#include "desktop/cli/did_you_mean.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/cli/lesson_files.hpp"
#include "desktop/cli/write_js.hpp"

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
  return exercise_paths(folder).and_then([](const auto& paths) { return read_each(paths, read_exercise_file); });
}

tl::expected<std::string, InputError> path_of_exercise(const std::vector<std::string>& paths, const std::string& id,
                                                       std::string_view prefix) {
  std::vector<std::string> known;
  for (const std::string& path : paths) {
    known.push_back(std::string(prefix) + id_of(path));
    if (known.back() == id) return path;
  }
  return tl::unexpected(InputError{.what = "there is no exercise \"" + id + "\"; `snug exercise list` lists them" +
                                           did_you_mean(id, known)});
}

tl::expected<ExerciseFile, InputError> find_exercise(const std::string& folder, const std::string& id) {
  if (is_path(id)) return read_exercise_file(id);
  if (is_written(id))
    return tl::unexpected(InputError{.what = "\"" + id + "\" is written on the page alone: it is at ?exercise=" + id});
  return exercise_paths(folder)
      .and_then([&](const auto& paths) { return path_of_exercise(paths, id); })
      .and_then(read_exercise_file);
}

tl::expected<std::vector<std::string>, InputError> written_paths(const std::string& folder) {
  std::error_code error;
  const fs::path where = folder_in_lessons(folder, "write");
  return fs::exists(where, error) ? lesson_paths(where.string()) : std::vector<std::string>();
}

tl::expected<std::vector<lesson::ExerciseSet>, InputError> read_sets_of(const std::string& folder) {
  const auto paths = exercise_paths(folder);
  if (!paths) return tl::unexpected(paths.error());
  const auto written = written_paths(folder);
  if (!written) return tl::unexpected(written.error());
  std::vector<std::string> ids;
  for (const std::string& path : *paths) ids.push_back(id_of(path));
  for (const std::string& path : *written) ids.push_back(std::string(kWritePrefix) + id_of(path));
  const fs::path path = exercises_folder(folder) / kSetsFile;
  std::error_code error;
  if (!fs::exists(path, error)) return std::vector<lesson::ExerciseSet>();
  return read_start(path.string(), lesson::kMostLessonBytes).and_then([&](const std::string& text) {
    return lesson::read_sets(text, path.string(), ids);
  });
}

}  // namespace snug::desktop
