// snug lesson coverage: which lessons teach each idea of the course.
#include <algorithm>

#include "desktop/cli/json.hpp"
#include "desktop/cli/lesson_commands.hpp"
#include "desktop/cli/lesson_files.hpp"
#include "lesson/names.hpp"

namespace snug::desktop {
namespace {

struct CoverageOptions {
  std::string folder;
};

/// A warning for each id that a lesson covers and the course does not list.
std::vector<InputError> unlisted_in(const std::vector<LessonFile>& lessons, const lesson::Course& course) {
  std::vector<InputError> unlisted;
  for (const LessonFile& file : lessons)
    for (const std::string& id : file.lesson.covers)
      if (std::none_of(course.ideas.begin(), course.ideas.end(), [&](const auto& idea) { return idea.id == id; }))
        unlisted.push_back({"\"covers\" names an idea that the course does not list: " + id, file.path});
  return unlisted;
}

CommandResult run_coverage(const CoverageOptions& options) {
  const auto course = read_course_of(options.folder);
  if (!course) return bad_input(course.error());
  const auto lessons = read_lessons(options.folder);
  if (!lessons) return bad_input(lessons.error());
  if (course->ideas.empty()) return bad_input("the course lists no [[idea]]");
  Printed printed{.text = {}, .warnings = unlisted_in(*lessons, *course)};
  if (!printed.warnings.empty()) printed.status = 1;
  for (const lesson::Idea& idea : course->ideas) {
    Json ids = Json::array();
    for (const LessonFile& file : *lessons)
      if (lesson::is_among(file.lesson.covers, idea.id)) ids.push_back(file.lesson.id);
    if (ids.empty()) printed.status = 1;
    printed.text += line_of({{"id", idea.id}, {"slide", idea.slide}, {"lessons", std::move(ids)}});
  }
  return printed;
}

}  // namespace

void add_lesson_coverage(Commands& commands, CLI::App& group) {
  CLI::App& coverage = *group.add_subcommand("coverage", "List which lessons teach each idea");
  coverage.footer(
      "A line for each idea that the course lists, in its order: {\"id\",\"slide\",\"lessons\"}. Exit status 1 while\n"
      "an idea has no lesson, or a lesson covers what the course does not list.");
  const auto options = add_command<CoverageOptions>(commands, coverage, run_coverage);
  add_lessons_folder(coverage, options->folder);
}

}  // namespace snug::desktop
