#include "desktop/cli/written_files.hpp"

#include <algorithm>
#include <filesystem>

#include "desktop/cli/exercise_files.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/cli/lesson_files.hpp"
#include "desktop/cli/result_file.hpp"
#include "desktop/cli/words.hpp"
#include "desktop/cli/write_js.hpp"
#include "lesson/lesson.hpp"
#include "lesson/toml_file.hpp"
#include "lesson/toml_table.hpp"
#include "number/fnv.hpp"

namespace snug::desktop {
namespace {

namespace fs = std::filesystem;

/// Code as it stands, with the spaces at its ends.
std::string code_in(lesson::TomlTable& table, const toml::table& toml, std::string_view key) {
  if (table.text(key).empty()) return {};  // it complains
  return toml[key].value_or(std::string());
}

UsualMistake read_mistake(const toml::table& toml, const WrittenExercise& exercise, lesson::Complaints& complaints) {
  lesson::TomlTable table(toml, "[[mistake]]", complaints);
  UsualMistake mistake;
  mistake.says = table.text("says");
  mistake.fails = table.text("fails");
  mistake.from = code_in(table, toml, "from");
  table.allow("to");  // it may be empty
  mistake.to = toml["to"].value_or(std::string());
  if (exercise.model.find(mistake.from) == std::string::npos) table.wrong("from", "is not in the model");
  const auto kinds = exercise.function->kinds;
  if (std::none_of(kinds.begin(), kinds.end(), [&](const write::Kind& kind) { return kind.name == mistake.fails; }))
    table.wrong("fails", "is not a kind of the function's cases");
  table.refuse_others();
  return mistake;
}

tl::expected<WrittenExercise, InputError> read_one(const std::string& path) {
  const auto text = read_start(path, lesson::kMostLessonBytes);
  if (!text) return tl::unexpected(text.error());
  lesson::Complaints complaints(path);
  WrittenExercise exercise{.id = std::string(kWritePrefix) + id_of(path), .path = path};
  exercise.function = write::find_function(id_of(path));
  if (exercise.function == nullptr)
    return tl::unexpected(InputError{.what = "there is no such function to write", .file = path});
  if (const auto toml = lesson::parse_file(*text, "the exercise", complaints)) {
    lesson::TomlTable table(*toml, "the exercise", complaints);
    if (table.integer("version", 1, 1) != 1) table.wrong("version", "must be 1");
    exercise.title = table.text("title");
    exercise.lesson = table.text("lesson");
    exercise.minutes = static_cast<int>(table.integer("minutes", 1, 60));
    for (const std::string_view key : {"summary", "contract", "reasons"}) (void)table.text(key);
    exercise.model = code_in(table, *toml, "model"), exercise.stub = code_in(table, *toml, "stub");
    for (const toml::table* one : table.tables("method")) {
      lesson::TomlTable own(*one, "[[method]]", complaints);
      exercise.methods.push_back({own.text("title"), code_in(own, *one, "code"), own.flag_or("exact", false)});
      own.refuse_others();
    }
    for (const toml::table* one : table.tables("mistake"))
      exercise.mistakes.push_back(read_mistake(*one, exercise, complaints));
    table.refuse_others();
  }
  if (const lesson::FileError* first = complaints.first()) return tl::unexpected(first->error());
  return exercise;
}

std::string with_mistake(const WrittenExercise& exercise, const UsualMistake& mistake) {
  std::string code = exercise.model;
  return code.replace(code.find(mistake.from), mistake.from.size(), mistake.to);
}

tl::expected<std::vector<JudgedJs>, InputError> judged(const WrittenExercise& exercise,
                                                       const std::vector<std::string>& codes, std::uint64_t seed) {
  auto all = judge_js(*exercise.function, codes, seed);
  if (!all) return tl::unexpected(InputError{.what = all.error()});
  return *std::move(all);
}

bool is_full(const JudgedJs& own) { return own.judged.mark() == own.judged.of(); }

/// "The model, seed 2: It fails on …"
std::string fault_in(const std::string& what, const JudgedJs& own) {
  return what + ": " + write::says(own.judged) + (own.error.empty() ? "" : ' ' + own.error);
}

bool passes(const write::Judged& judged, std::string_view kind) {
  return std::any_of(judged.kinds.begin(), judged.kinds.end(),
                     [&](const write::KindPassed& one) { return one.kind->name == kind && one.passed == one.of; });
}

}  // namespace

tl::expected<std::vector<WrittenExercise>, InputError> read_written(const std::string& folder) {
  return written_paths(folder).and_then([](const auto& paths) { return read_each(paths, read_one); });
}

tl::expected<WrittenExercise, InputError> find_written(const std::string& folder, const std::string& id) {
  return written_paths(folder)
      .and_then([&](const auto& paths) { return path_of_exercise(paths, id, kWritePrefix); })
      .and_then(read_one);
}

Json listed(const WrittenExercise& exercise, Json sets) {
  sets.push_back("write");
  return {{"exercise", exercise.id},     {"kind", "write"},       {"title", exercise.title},
          {"minutes", exercise.minutes}, {"set", sets.front()},   {"sets", sets},
          {"lesson", exercise.lesson},   {"file", exercise.path}, {"levels", 1}};
}

Json instance_of(const WrittenExercise& exercise, std::uint64_t seed) {
  const write::Function& function = *exercise.function;
  Json kinds = Json::array();
  for (const write::Kind& kind : function.kinds) kinds.push_back(kind.name);
  return {{"exercise", exercise.id},
          {"hash", hex_of(write::hash_of(function))},
          {"seed", seed},
          {"instance",
           {{"function", function.name},
            {"takes", function.takes},
            {"gives", function.gives},
            {"kinds", std::move(kinds)},
            {"cases", write::cases_of(function, seed).size()}}},
          {"decisions", 1},
          {"of", function.kinds.size()}};
}

tl::expected<Json, InputError> checked(const WrittenExercise& exercise, int seeds) {
  std::vector<std::string> faults;
  for (int seed = 2; seed <= seeds; ++seed) {
    const auto own = judged(exercise, {exercise.model}, static_cast<std::uint64_t>(seed));
    if (!own) return tl::unexpected(own.error());
    if (!is_full(own->front())) faults.push_back(fault_in("the model, seed " + std::to_string(seed), own->front()));
  }
  std::vector<std::string> codes{exercise.model, exercise.stub};
  for (const OtherMethod& method : exercise.methods) codes.push_back(method.code);
  for (const UsualMistake& mistake : exercise.mistakes) codes.push_back(with_mistake(exercise, mistake));
  const auto all = judged(exercise, codes, 1);
  if (!all) return tl::unexpected(all.error());
  auto own = all->begin();
  if (!is_full(*own)) faults.push_back(fault_in("the model", *own));
  if (is_full(*++own)) faults.emplace_back("the stub earns every mark");
  for (const OtherMethod& method : exercise.methods)
    if (++own; is_full(*own) != method.exact || !own->error.empty()) faults.push_back(fault_in(method.title, *own));
  for (const UsualMistake& mistake : exercise.mistakes)
    if (passes((++own)->judged, mistake.fails))
      faults.push_back(mistake.says + ": no case of \"" + mistake.fails + "\" shows it");
  return Json{{"exercise", exercise.id},
              {"seeds", seeds},
              {"kept", faults.empty()},
              {"methods", exercise.methods.size()},
              {"mistakes", exercise.mistakes.size()},
              {"faults", faults}};
}

tl::expected<Json, InputError> answered(const WrittenExercise& exercise, std::uint64_t seed, int wrong) {
  if (wrong > static_cast<int>(exercise.mistakes.size()))
    return tl::unexpected(InputError{.what = "--wrong takes the number of a usual mistake of " + exercise.id +
                                             ", up to " + std::to_string(exercise.mistakes.size())});
  const std::string code = wrong > 0 ? with_mistake(exercise, exercise.mistakes[wrong - 1]) : exercise.model;
  const auto all = judged(exercise, {code}, seed);
  if (!all) return tl::unexpected(all.error());
  const write::Judged& own = all->front().judged;
  return Json{{"exercise", exercise.id},
              {"hash", hex_of(write::hash_of(*exercise.function))},
              {"seed", seed},
              {"decisions", Json::array({kCodeMark + code})},
              {"hints", 0},
              {"mark", own.mark()},
              {"of", own.of()},
              {"seconds", 0}};
}

}  // namespace snug::desktop
