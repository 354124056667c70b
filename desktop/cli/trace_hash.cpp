#include "lesson/trace_hash.hpp"

#include "desktop/cli/command.hpp"
#include "desktop/cli/lesson_files.hpp"

namespace snug::desktop {
namespace {

struct TraceHashOptions {
  std::string folder;
};

CommandResult run_trace_hash(const TraceHashOptions& options) {
  const auto lessons = read_lessons(options.folder);
  if (!lessons) return bad_input(lessons.error());
  Printed printed;
  for (const LessonFile& file : *lessons) {
    const auto hash = open_lesson(file).and_then([](lesson::Session&& session) { return lesson::trace_hash(session); });
    if (!hash) return bad_input(hash.error());
    printed.text += lesson::line_of(*hash) + '\n';
  }
  return printed;
}

}  // namespace

void add_trace_hash(Commands& commands) {
  CLI::App& command = *commands.app.add_subcommand("trace-hash", "Print a hash of each lesson's trace");
  command.footer(
      "One line per lesson: its id, the number of steps that its algorithms take together, and a 64-bit hash of those\n"
      "steps in hexadecimal. The WebAssembly build prints the same.");
  const auto options = add_command<TraceHashOptions>(commands, command, run_trace_hash);
  add_lessons_folder(command, options->folder);
}

}  // namespace snug::desktop
