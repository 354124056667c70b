#include "desktop/cli/exercise_files.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "desktop/cli/files.hpp"
#include "desktop/cli/lesson_files.hpp"
#include "number/fnv.hpp"

namespace snug::desktop {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSetsFile = "sets.toml";
constexpr double kMostSeed = 0x1p53;  // what a page's numbers can hold

fs::path exercises_folder(const std::string& folder) {
  return (folder.empty() ? program_folder() / "lessons" : fs::path(folder)) / "exercises";
}

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

const Json* find(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found == json.end() ? nullptr : &*found;
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
  return tl::unexpected(InputError{.what = "there is no exercise \"" + id + "\"; `snug exercise list` lists them"});
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

tl::expected<Claimed, std::string> attempt_of(const Json& json) {
  Claimed claimed;
  if (!json.is_object()) return tl::unexpected<std::string>("an attempt is no object");
  const Json* exercise = find(json, "exercise");
  const Json* hash = find(json, "hash");
  const Json* seed = find(json, "seed");
  const Json* decisions = find(json, "decisions");
  if (exercise == nullptr || !exercise->is_string()) return tl::unexpected<std::string>("\"exercise\" is no text");
  claimed.attempt.exercise = exercise->get<std::string>();
  const std::string digits = hash != nullptr && hash->is_string() ? hash->get<std::string>() : "";
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), claimed.attempt.hash, 16);
  if (digits.size() != 16 || error != std::errc() || end != digits.data() + digits.size())
    return tl::unexpected<std::string>("\"hash\" is not 16 hexadecimal digits");
  if (seed == nullptr || !seed->is_number_integer() || seed->get<double>() < 0 || seed->get<double>() > kMostSeed)
    return tl::unexpected<std::string>("\"seed\" is no whole number from 0 to 2^53");
  claimed.attempt.seed = seed->get<std::uint64_t>();
  if (decisions == nullptr || !decisions->is_array()) return tl::unexpected<std::string>("\"decisions\" is no list");
  for (const Json& one : *decisions) {
    if (!one.is_string()) return tl::unexpected<std::string>("a decision is no text");
    auto made = lesson::made_of(one.get<std::string>());
    if (!made) return tl::unexpected(made.error().what);
    claimed.attempt.made.push_back(*std::move(made));
  }
  if (const Json* mark = find(json, "mark"); mark != nullptr && mark->is_number()) claimed.mark = mark->get<double>();
  return claimed;
}

tl::expected<ResultFile, NoResult> read_result(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return tl::unexpected(NoResult{false, "is not JSON"});
  const Json* format = json.is_object() ? find(json, "snug_result") : nullptr;
  if (format == nullptr || !format->is_number_integer()) return tl::unexpected(NoResult{true, "is no result file"});
  ResultFile file;
  file.format = format->get<int>();
  if (const Json* version = find(json, "version"); version != nullptr && version->is_string())
    file.version = version->get<std::string>();
  if (const Json* student = find(json, "student"); student != nullptr && student->is_string())
    file.student = student->get<std::string>();
  const Json* attempts = find(json, "attempts");
  if (attempts == nullptr || !attempts->is_array()) return tl::unexpected(NoResult{false, "\"attempts\" is no list"});
  for (const Json& one : *attempts) file.attempts.push_back(attempt_of(one));
  return file;
}

Json json_of(const lesson::Attempt& attempt, double mark, int of) {
  Json decisions = Json::array();
  int hints = 0;
  double seconds = 0;
  for (const lesson::Made& made : attempt.made) {
    decisions.push_back(text_of(made));
    hints += made.hints;
    seconds = std::max(seconds, made.seconds);
  }
  return {{"exercise", attempt.exercise},
          {"hash", hex_of(attempt.hash)},
          {"seed", attempt.seed},
          {"decisions", std::move(decisions)},
          {"hints", hints},
          {"mark", mark},
          {"of", of},
          {"seconds", seconds}};
}

std::string result_text(const std::string& student, const std::vector<Json>& attempts) {
  return line_of(
      {{"snug_result", kResultFormat}, {"version", SNUG_VERSION}, {"student", student}, {"attempts", attempts}});
}

}  // namespace snug::desktop
