// snug lesson list, check and play.
#include <algorithm>
#include <filesystem>

#include "desktop/cli/command.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/cli/json.hpp"
#include "desktop/cli/lesson_files.hpp"
#include "lesson/play.hpp"
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
  if (!lesson.subject->decided_by.empty()) json["decided_by"] = lesson.subject->decided_by;
}

// ---- list ------------------------------------------------------------------------------------------------------

CommandResult run_list(const LessonOptions& options) {
  const auto lessons = read_lessons(options.folder);
  if (!lessons) return bad_input(lessons.error());
  Printed printed;
  for (const auto& [path, lesson, chapter] : *lessons)
    printed.text += line_of({{"lesson", lesson.id},
                             {"group", chapter},
                             {"title", lesson.title},
                             {"summary", lesson.summary},
                             {"minutes", lesson.minutes},
                             {"algorithms", lesson.algorithms},
                             {"questions", lesson.questions.size()},
                             {"task", lesson.task.has_value()},
                             {"file", path}});
  return printed;
}

// ---- check -----------------------------------------------------------------------------------------------------

tl::expected<lesson::Played, InputError> play(const LessonFile& file) {
  auto played = open_lesson(file).and_then([](lesson::Session&& session) { return lesson::play(session); });
  if (!played && played.error().file.empty()) played.error().file = file.path;
  return played;
}

/// The first error that only playing can find: on a mesh's points, questions are known only from playing.
std::optional<InputError> fault_of(const LessonFile& file, const lesson::Played& played) {
  for (const lesson::Question& question : file.lesson.questions)
    for (const std::string& id : played.not_asked)
      if (question.id == id)
        return InputError{"the question \"" + id + "\" is never asked: its step does not come", file.path,
                          InputError::Unit::kLine, question.line};
  if (played.sound()) return std::nullopt;
  return InputError{.what = "a model answer is graded as wrong", .file = file.path};
}

/// The line of a file that has some words, counted from 1; `otherwise` if none has.
int line_with(const std::string& path, const std::string& words, int otherwise) {
  const auto text = read_file(path);
  const std::size_t at = text ? text->find(words) : std::string::npos;
  if (at == std::string::npos) return otherwise;
  return 1 + static_cast<int>(std::count(text->begin(), text->begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

bool is_beside(const std::string& path, const std::string& lesson) {
  std::error_code ignored;
  return std::filesystem::exists(std::filesystem::path(path).parent_path() / (lesson + ".toml"), ignored);
}

/// The error of a link to a lesson that is not in the lesson's folder; none if all are.
std::optional<InputError> lost_link(const LessonFile& file) {
  for (const lesson::Section& section : file.lesson.sections)
    for (const lesson::Paragraph& paragraph : section.paragraphs)
      for (const lesson::Stretch& stretch : paragraph) {
        if (!stretch.link || stretch.link->kind != lesson::Link::Kind::kLesson) continue;
        const std::string& target = stretch.link->target;
        if (!is_beside(file.path, target))
          return InputError{"\"text\" links to a lesson that is not there: " + target, file.path,
                            InputError::Unit::kLine, line_with(file.path, "(lesson:" + target + ")", section.line)};
      }
  return std::nullopt;
}

tl::expected<Json, InputError> check_course(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const auto course = read_course_of(folder.string());
  if (!course) return tl::unexpected(course.error());
  std::size_t lessons = 0;
  for (const lesson::Chapter& chapter : course->chapters) lessons += chapter.lessons.size();
  return Json{{"chapters", course->chapters.size()}, {"lessons", lessons}, {"file", path.string()}};
}

tl::expected<Json, InputError> check(const std::string& path) {
  if (std::filesystem::path(path).filename() == kCourseFile) return check_course(path);
  const auto file = read_lesson_file(path);
  if (!file) return tl::unexpected(file.error());
  if (auto lost = lost_link(*file)) return tl::unexpected(std::move(*lost));
  const auto played = play(*file);
  if (!played) return tl::unexpected(played.error());
  if (auto fault = fault_of(*file, *played)) return tl::unexpected(std::move(*fault));
  Json json{{"lesson", file->lesson.id}, {"questions", file->lesson.questions.size()}, {"file", path}};
  add_decided_by(json, file->lesson);
  return json;
}

CommandResult run_check(const LessonOptions& options) {
  Printed printed;
  std::vector<InputError> errors;
  const auto check_one = [&](const std::string& path) {
    if (const auto checked = check(path)) printed.text += line_of(*checked);
    else errors.push_back(checked.error());
  };
  for (const std::string& path : options.files) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(path, ignored)) check_one(path);
    else if (const auto files = files_of(path)) std::for_each(files->begin(), files->end(), check_one);
    else errors.push_back(files.error());
  }
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return printed;
}

// ---- play ------------------------------------------------------------------------------------------------------

Json json_of_played(const lesson::Played::Algorithm& algorithm) {
  Json questions = Json::array();
  for (const lesson::Outcome& outcome : algorithm.outcomes)
    questions.push_back({{"question", outcome.question},
                         {"answer", outcome.predicted},
                         {"happened", outcome.happened},
                         {"right", outcome.right}});
  return {{"algorithm", algorithm.name}, {"steps", algorithm.steps}, {"questions", std::move(questions)}};
}

CommandResult run_play(const LessonOptions& options) {
  const auto file = find_lesson(options.folder, options.id);
  if (!file) return bad_input(file.error());
  const auto played = play(*file);
  if (!played) return bad_input(played.error());
  Printed printed{"", played->sound() ? 0 : 1};
  for (const auto& algorithm : played->algorithms) printed.text += line_of(json_of_played(algorithm));
  Json task;
  if (played->grade)
    task = {{"done", played->grade->done}, {"excess", played->grade->excess}, {"says", played->grade->says}};
  Json last{{"lesson", file->lesson.id},
            {"not_asked", played->not_asked},
            {"task", std::move(task)},
            {"sound", played->sound()}};
  add_decided_by(last, file->lesson);
  printed.text += line_of(last);
  return printed;
}

void add_folder(CLI::App& command, LessonOptions& options) {
  command.add_option("--lessons", options.folder, "Folder of the lesson files; by default the one beside the program");
}

}  // namespace

void add_lesson(Commands& commands) {
  CLI::App& group = *commands.app.add_subcommand("lesson", "List, check or play lessons");
  group.require_subcommand(1);

  CLI::App& list = *group.add_subcommand("list", "List the lessons");
  list.footer(
      "In the order of the folder's course.toml, whose chapter is the group; by id where there is none. JSON Lines:\n"
      "{\"lesson\",\"group\",\"title\",\"summary\",\"minutes\",\"algorithms\",\"questions\",\"task\",\"file\"}.");
  add_folder(list, *add_command<LessonOptions>(commands, list, run_list));

  CLI::App& check = *group.add_subcommand("check", "Check lesson files");
  check.footer(
      "Reads each file and plays it with its model answers. If all are sound, prints a line for each:\n"
      "{\"lesson\",\"questions\",\"file\"}. Of a folder it checks every lesson and course.toml, whose line is\n"
      "{\"chapters\",\"lessons\",\"file\"}. Otherwise prints a line on standard error for each that is not, with\n"
      "file and line, and exits with status 2.\n"
      "A lesson with the cost chart is decided by counted operations, never by time; its line has\n"
      "\"decided_by\":\"operations\" as well.");
  const auto checked = add_command<LessonOptions>(commands, check, run_check);
  check.add_option("FILE", checked->files, "Lesson files, course.toml, or folders of them")->required();

  CLI::App& play = *group.add_subcommand("play", "Play a lesson to its end");
  play.footer(
      "Plays each of the lesson's algorithms to the last step and gives every exercise its model answer.\n"
      "JSON Lines: {\"algorithm\",\"steps\",\"questions\":[{\"question\",\"answer\",\"happened\",\"right\"}]} for "
      "each, then\n"
      "{\"lesson\",\"not_asked\",\"task\",\"sound\"}. Exit status 1 if an answer is wrong or was never asked for.\n"
      "A lesson with the cost chart is played without a clock: which algorithm is fastest, and by how much, is "
      "decided\n"
      "by counted operations, and the last line has \"decided_by\":\"operations\". In the window and on the page it "
      "is\n"
      "decided by time.");
  const auto played = add_command<LessonOptions>(commands, play, run_play);
  add_folder(play, *played);
  play.add_option("ID", played->id, "The lesson's id")->required();
}

}  // namespace snug::desktop
