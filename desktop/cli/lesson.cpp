// snug lesson list, check and play.
#include <algorithm>
#include <filesystem>
#include <iterator>

#include "check/check_beside.hpp"
#include "check/check_lesson.hpp"
#include "check/play.hpp"
#include "desktop/cli/command.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/cli/json.hpp"
#include "desktop/cli/lesson_commands.hpp"
#include "desktop/cli/lesson_files.hpp"
#include "lesson/names.hpp"
#include "lesson/prose.hpp"
#include "lesson/subjects.hpp"

namespace snug::desktop {
namespace {

struct LessonOptions {
  std::string folder;
  std::string id;
  std::vector<std::string> files;
};

/// Adds what decides the lesson's answers without a clock.
void add_decided_by(Json& json, const lesson::Lesson& lesson) {
  const lesson::Experiment* const experiment = lesson.subject->experiment;
  if (experiment != nullptr && !experiment->decided_by.empty()) json["decided_by"] = experiment->decided_by;
}

// ---- list ------------------------------------------------------------------------------------------------------

CommandResult run_list(const LessonOptions& options) {
  const auto lessons = read_lessons(options.folder);
  if (!lessons) return bad_input(lessons.error());
  Printed printed;
  for (const auto& [path, lesson, chapter, slides, is_case, is_playground, sheet] : *lessons)
    printed.text += line_of({{"lesson", lesson.id},
                             {"group", chapter},
                             {"title", lesson.title},
                             {"summary", lesson.summary},
                             {"minutes", lesson.minutes},
                             {"algorithms", lesson.algorithms},
                             {"questions", lesson.questions.size()},
                             {"task", !lesson.tasks.empty()},
                             {"tasks", lesson.tasks.size()},
                             {"file", path}});
  return printed;
}

// ---- check -----------------------------------------------------------------------------------------------------

tl::expected<check::Played, InputError> play(const LessonFile& file) {
  auto played = open_lesson(file).and_then([](lesson::Session&& session) { return check::play(session); });
  if (!played && played.error().file.empty()) played.error().file = file.path;
  return played;
}

/// The result of checking a file: what is printed, or its mistakes; in either case its warnings.
struct CheckedFile {
  Json json;
  std::vector<InputError> mistakes, warnings;
};

CheckedFile check_course(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const auto course = read_course_of(folder.string());
  if (!course) return {.mistakes = {course.error()}};
  std::size_t lessons = 0;
  for (const lesson::Chapter& chapter : course->chapters) lessons += chapter.lessons.size();
  return {{{"chapters", course->chapters.size()}, {"lessons", lessons}, {"file", path.string()}}};
}

/// Plays a lab sheet as a lesson, with its model answers and models.
CheckedFile check_sheet(const std::string& path, const std::string& text) {
  CheckedFile checked;
  const lesson::SheetDraft draft = lesson::read_sheet(text, path);
  for (const lesson::FileError& mistake : draft.mistakes) checked.mistakes.push_back(with_column(mistake));
  if (!checked.mistakes.empty()) return checked;
  const lesson::Sheet& sheet = draft.sheet;
  const auto played = play({path, sheet.lesson, {}});
  if (!played) return {.mistakes = {played.error()}};
  if (!played->sound()) return {.mistakes = {InputError{.what = "a model answer or a model is wrong", .file = path}}};
  checked.json = {{"sheet", sheet.lesson.id},
                  {"measured", sheet.measured.size()},
                  {"written", sheet.written.size()},
                  {"built", sheet.lesson.tasks.size()},
                  {"file", path}};
  return checked;
}

CheckedFile check_lesson(const std::string& path) {
  const auto text = read_start(path, lesson::kMostLessonBytes);
  if (!text) return {.mistakes = {text.error()}};
  if (lesson::is_sheet(*text)) return check_sheet(path, *text);
  lesson::Draft draft = check::checked_draft(*text, path);
  std::optional<io::PointFile> mesh;
  if (draft.lesson) {
    auto read = mesh_of(*draft.lesson);
    if (!read) return {.mistakes = {read.error()}};
    mesh = *std::move(read);
  }
  if (mesh) draft = check::checked_draft(*text, path, &*mesh);
  check::check_names_beside(draft, path, beside(path));
  check::check_played(draft, path, std::move(mesh));
  CheckedFile checked;
  for (const lesson::FileError& mistake : draft.mistakes) checked.mistakes.push_back(with_column(mistake));
  for (const lesson::FileError& warning : draft.warnings) checked.warnings.push_back(with_column(warning));
  if (!checked.mistakes.empty() || !draft.lesson) return checked;
  checked.json = {{"lesson", draft.lesson->id}, {"questions", draft.lesson->questions.size()}, {"file", path}};
  if (!checked.warnings.empty()) checked.json["warnings"] = checked.warnings.size();
  add_decided_by(checked.json, *draft.lesson);
  return checked;
}

CommandResult run_check(const LessonOptions& options) {
  Printed printed;
  std::vector<InputError> mistakes;
  const auto check_one = [&](const std::string& path) {
    CheckedFile checked =
        std::filesystem::path(path).filename() == kCourseFile ? check_course(path) : check_lesson(path);
    std::move(checked.warnings.begin(), checked.warnings.end(), std::back_inserter(printed.warnings));
    if (checked.mistakes.empty()) printed.text += line_of(checked.json);
    std::move(checked.mistakes.begin(), checked.mistakes.end(), std::back_inserter(mistakes));
  };
  for (const std::string& path : options.files) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(path, ignored)) check_one(path);
    else if (const auto files = files_of(path)) std::for_each(files->begin(), files->end(), check_one);
    else mistakes.push_back(files.error());
  }
  if (mistakes.empty()) return printed;
  for (InputError& warning : printed.warnings)
    warning.what = kWarning + warning.what, mistakes.push_back(std::move(warning));
  return tl::unexpected(std::move(mistakes));
}

// ---- play ------------------------------------------------------------------------------------------------------

/// situations: whether the lesson has several.
Json json_of_played(const check::Played::Algorithm& algorithm, bool situations) {
  Json questions = Json::array();
  for (const lesson::Outcome& outcome : algorithm.outcomes)
    questions.push_back({{"question", outcome.question},
                         {"answer", outcome.predicted},
                         {"happened", outcome.happened},
                         {"right", outcome.right}});
  Json json{{"algorithm", algorithm.name}, {"steps", algorithm.steps}, {"questions", std::move(questions)}};
  if (situations) json["situation"] = algorithm.situation;
  return json;
}

CommandResult run_play(const LessonOptions& options) {
  const auto file = find_lesson(options.folder, options.id);
  if (!file) return bad_input(file.error());
  const auto played = play(*file);
  if (!played) return bad_input(played.error());
  Printed printed{"", played->sound() ? 0 : 1};
  for (const auto& algorithm : played->algorithms)
    printed.text += line_of(json_of_played(algorithm, !file->lesson.situations.empty()));
  Json tasks = Json::array();
  for (const lesson::Grade& grade : played->grades)
    tasks.push_back({{"done", grade.done}, {"excess", grade.excess}, {"says", grade.says}});
  Json false_keys = Json::array();
  for (const auto& [question, answer, is] : played->false_keys)
    false_keys.push_back({{"question", question}, {"answer", answer}, {"is", is}});
  Json last{{"lesson", file->lesson.id},
            {"not_asked", played->not_asked},
            {"false_keys", std::move(false_keys)},
            {"task", tasks.empty() ? Json() : tasks.front()},
            {"tasks", tasks},
            {"sound", played->sound()}};
  add_decided_by(last, file->lesson);
  printed.text += line_of(last);
  return printed;
}

}  // namespace

void add_lesson_options(CLI::App& command, std::string& folder, std::string& id) {
  add_lessons_folder(command, folder);
  command.add_option("LESSON", id, "The lesson's id, or its file, which ends in .toml")->required();
}

void add_lesson(Commands& commands) {
  CLI::App& group = *commands.app.add_subcommand("lesson", "List, begin, check or play lessons");
  group.require_subcommand(1);

  CLI::App& list = *group.add_subcommand("list", "List the lessons");
  list.footer(
      "In the order of the folder's course.toml, whose chapter is the group; by id where there is none. JSON Lines:\n"
      "{\"lesson\",\"group\",\"title\",\"summary\",\"minutes\",\"algorithms\",\"questions\",\"task\",\"tasks\","
      "\"file\"}.");
  add_lessons_folder(list, add_command<LessonOptions>(commands, list, run_list)->folder);

  CLI::App& check = *group.add_subcommand("check", "Check lesson files");
  check.footer(
      "Reads each file and plays it with its model answers. If all are sound, prints a line for each:\n"
      "{\"lesson\",\"questions\",\"file\"}. In a folder it checks every lesson and course.toml, whose line is\n"
      "{\"chapters\",\"lessons\",\"file\"}. Otherwise prints a line on standard error for each mistake, with file,\n"
      "line and column, and exits with status 2. What is allowed but probably not meant is a line on standard error\n"
      "as well, which begins with \"warning\"; \"warnings\" is then how many the file has, and the status stays 0.\n"
      "A lesson with the cost chart is checked by counted operations, never by time; its line has\n"
      "\"decided_by\":\"operations\" as well.");
  const auto checked = add_command<LessonOptions>(commands, check, run_check);
  check.add_option("FILE", checked->files, "Lesson files, course.toml, or folders of them")->required();

  add_lesson_facts(commands, group);
  add_lesson_coverage(commands, group);
  add_lesson_new(commands, group);
  add_lesson_table(commands, group);

  CLI::App& play = *group.add_subcommand("play", "Play a lesson to its end");
  play.footer(
      "Plays each of the lesson's algorithms to the last step and gives every exercise its model answer.\n"
      "JSON Lines: {\"algorithm\",\"steps\",\"questions\":[{\"question\",\"answer\",\"happened\",\"right\"}]} for "
      "each,\n"
      "with \"situation\" if the lesson has several, each of which is played; then\n"
      "{\"lesson\",\"not_asked\",\"false_keys\",\"task\",\"tasks\",\"sound\"}: the grades of the tasks' models, and\n"
      "the first of them. \"false_keys\" are the fixed answers of choices that the run contradicts:\n"
      "{\"question\",\"answer\",\"is\"}. Exit status 1 if there is one, if a model answer is wrong or a question is\n"
      "never asked.\n"
      "A lesson with the cost chart is played without a clock: which algorithm is fastest, and by how much, is "
      "decided\n"
      "by counted operations, and the last line has \"decided_by\":\"operations\". In the window and on the page it "
      "is\n"
      "decided by time.");
  const auto played = add_command<LessonOptions>(commands, play, run_play);
  add_lesson_options(play, played->folder, played->id);
}

}  // namespace snug::desktop
