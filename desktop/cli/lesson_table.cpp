// snug lesson table: what lessons/README.md lists of the subjects, made from the code.
#include <filesystem>
#include <string>

#include "desktop/cli/lesson_commands.hpp"
#include "desktop/cli/lesson_files.hpp"
#include "lesson/ask.hpp"
#include "lesson/names.hpp"
#include "lesson/play.hpp"
#include "lesson/subjects.hpp"

namespace snug::desktop {
namespace {

struct TableOptions {};

/// "`pair`, `frustum`"; a dash for none.
std::string in_code(const auto& names) {
  std::string text;
  for (const auto& name : names) ((text += text.empty() ? "`" : ", `") += name) += '`';
  return text.empty() ? "–" : text;
}

std::string step_rows(const lesson::SubjectRow& row) {
  std::string text;
  for (const std::string_view fact : row.facts()) {
    std::vector<std::string_view> own;
    for (const auto& [of, asking] : row.askings())
      if (of == fact) own.push_back(asking->name);
    text += "| `" + std::string(row.name) + "` | `" + std::string(fact) + "` | " + in_code(own) + " |\n";
  }
  return text;
}

/// The figures of the results in the subject's example, by their keys.
tl::expected<std::vector<std::string>, InputError> figures_of(const lesson::SubjectRow& row) {
  const std::filesystem::path example = program_folder() / "lessons" / "examples" / (std::string(row.name) + ".toml");
  std::vector<std::string> keys;
  std::error_code error;
  if (!std::filesystem::exists(example, error)) return keys;
  return read_lesson_file(example.string(), lesson::Checked::kAsWritten)
      .and_then([](const LessonFile& file) { return open_lesson(file); })
      .map([&](const lesson::Session& session) {
        for (const std::string& name : lesson::playable(session))
          for (const lesson::Figure& figure :
               session.subject().results(*lesson::find_method(session.lesson(), name), session.view()))
            if (!lesson::is_among(keys, figure.key)) keys.push_back(figure.key);
        return keys;
      });
}

CommandResult run_table(const TableOptions&) {
  Printed printed{"| subject | asked of every step | asked without a step | figures of a result | goals "
                  "|\n|---|---|---|---|---|\n"};
  for (const lesson::SubjectRow* row : lesson::subjects()) {
    const auto figures = figures_of(*row);
    if (!figures) return bad_input(figures.error());
    std::vector<std::string_view> alone;
    for (const auto& [of, asking] : row->askings())
      if (of.empty()) alone.push_back(asking->name);
    printed.text += "| `" + std::string(row->name) + "` | " + in_code(lesson::general_askings(*row)) + " | " +
                    in_code(alone) + " | " + in_code(*figures) + " | " + in_code(row->goals) + " |\n";
  }
  printed.text += "\n| subject | step | what it can be asked besides |\n|---|---|---|\n";
  for (const lesson::SubjectRow* row : lesson::subjects()) printed.text += step_rows(*row);
  return printed;
}

}  // namespace

void add_lesson_table(Commands& commands, CLI::App& group) {
  CLI::App& table = *group.add_subcommand("table", "Print what lessons can ask and require");
  table.footer(
      "Two tables in Markdown, as lessons/README.md has them: for each subject what can be asked of every step, the\n"
      "figures that its results have and the goals that a task may name; and for each step what else it can be asked.");
  add_command<TableOptions>(commands, table, run_table);
}

}  // namespace snug::desktop
