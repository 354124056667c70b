// snug lesson coverage: which lessons teach each idea of the course.
#include "desktop/cli/json.hpp"
#include "desktop/cli/lesson_commands.hpp"
#include "desktop/cli/lesson_files.hpp"
#include "lesson/names.hpp"

namespace snug::desktop {
namespace {

struct CoverageOptions {
  std::string folder;
};

CommandResult run_coverage(const CoverageOptions& options) {
  const auto course = read_course_of(options.folder);
  if (!course) return bad_input(course.error());
  const auto lessons = read_lessons(options.folder);
  if (!lessons) return bad_input(lessons.error());
  if (course->ideas.empty()) return bad_input("the course lists no [[idea]]");
  Printed printed;
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
      "an idea has no lesson.");
  const auto options = add_command<CoverageOptions>(commands, coverage, run_coverage);
  coverage.add_option("--lessons", options->folder, "Folder of the lessons; by default the one beside the program");
}

}  // namespace snug::desktop
