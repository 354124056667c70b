// snug lab new and snug lab check: a student's C++.
#include <filesystem>

#include "desktop/cli/command.hpp"
#include "desktop/cli/data_folder.hpp"
#include "desktop/cli/json.hpp"
#include "desktop/cli/lab_check.hpp"
#include "desktop/cli/result_file.hpp"
#include "desktop/cli/words.hpp"
#include "lesson/names.hpp"
#include "number/fnv.hpp"
#include "write/shape.hpp"
#include "write/stage.hpp"

namespace snug::desktop {
namespace {

namespace fs = std::filesystem;

struct LabOptions {
  std::string name, folder, student;
  std::uint64_t seed = 1;
  bool show = false;
};

// ---- new -------------------------------------------------------------------------------------------------------

CommandResult new_lab(const LabOptions& options) {
  const Lab* lab = find_lab(options.name);
  if (lab == nullptr) {
    std::vector<std::string_view> names;
    for (const Lab& one : labs()) names.push_back(one.name);
    return bad_input("the lab " + lesson::none_of_text(options.name, names));
  }
  std::error_code error;
  if (fs::exists(options.folder, error) && !fs::is_empty(options.folder, error))
    return bad_input({.what = "is there already, and not empty", .file = options.folder});
  fs::create_directories(options.folder, error);
  if (error) return bad_input({.what = error.message(), .file = options.folder});
  const fs::path from = data_folder() / "lab", to = options.folder;
  const std::string name(lab->name);
  for (const auto& [file, as] :
       {std::pair{name + '/' + name + ".hpp", name + ".hpp"}, std::pair{name + '/' + name + ".cpp", name + ".cpp"},
        std::pair{name + "/tests.cpp", std::string("tests.cpp")},
        std::pair{std::string("lab.cmake"), std::string("CMakeLists.txt")},
        std::pair{std::string("README.md.in"), std::string("README.md")}}) {
    auto text = read_file((from / file).string());
    if (!text) return bad_input(text.error());
    for (const auto& [what, by] :
         {std::pair{"@NAME@", lab->name}, std::pair{"@TITLE@", lab->title}, std::pair{"@WORDS@", lab->words}})
      *text = replaced(*std::move(text), what, by);
    if (const auto done = write_file((to / as).string(), *text); !done) return bad_input(done.error());
  }
  return Printed{(to / (name + ".cpp")).lexically_normal().string() + '\n'};
}

// ---- check -----------------------------------------------------------------------------------------------------

/// Finds the lab that a folder was made for, by the names of its files.
tl::expected<const Lab*, InputError> lab_in(const std::string& folder) {
  std::error_code error;
  for (const Lab& lab : labs())
    if (const fs::path own = fs::path(folder) / std::string(lab.name);
        fs::exists(own.string() + ".cpp", error) && fs::exists(own.string() + ".hpp", error))
      return &lab;
  return tl::unexpected(InputError{.what = "is no folder that snug lab new has made", .file = folder});
}

std::string told(const write::Function& function, const CounterExample& found, std::string_view how) {
  const std::string right = write::json_of(function.gives, function.right(found.input));
  const std::string given = found.answer && write::fits(function.gives, *found.answer)
                                ? write::json_of(function.gives, *found.answer)
                            : found.answer ? "something else"
                                           : found.answer.error();
  return std::string(how) + '\n' + "  given  " + write::json_of(function.takes, found.input) + '\n' + "  right  " +
         right + '\n' + "  yours  " + given + '\n';
}

std::string report(const write::Function& function, const LabChecked& checked) {
  std::string text;
  for (const auto& [kind, passed, of] : checked.judged.kinds)
    text += (passed == of ? "  ok    " : "  FAILS ") + std::string(kind->name) + ": " + std::to_string(passed) +
            " of " + std::to_string(of) + '\n';
  text += write::says(checked.judged) + '\n';
  if (checked.first) text += told(function, *checked.first, "The first that differs (" + checked.first->kind + "):");
  if (checked.shortest) text += told(function, *checked.shortest, "The shortest input found on which it fails:");
  if (!checked.ended.empty()) text += "It did not come to its end: " + checked.ended + ".\n";
  return text + "Mark " + std::to_string(checked.judged.mark()) + " of " + std::to_string(checked.judged.of()) + ".\n";
}

/// The result file, which has the source: it can be built and tried again, and proves no more than that.
tl::expected<void, InputError> write_result(const LabOptions& options, const Lab& lab, const LabChecked& checked,
                                            const std::string& source) {
  const auto code = read_file(source);
  if (!code) return tl::unexpected(code.error());
  const write::Function& function = *write::find_function(lab.function);
  const Json attempt{{"exercise", std::string(kLabPrefix) + std::string(lab.name)},
                     {"hash", hex_of(write::hash_of(function))},
                     {"seed", options.seed},
                     {"decisions", Json::array({kCodeMark + *code})},
                     {"hints", 0},
                     {"mark", checked.judged.mark()},
                     {"of", checked.judged.of()},
                     {"seconds", 0}};
  return write_file((fs::path(options.folder) / "result.json").string(), result_text(options.student, {attempt}));
}

CommandResult check(const LabOptions& options, const OpenWindow& open_window) {
  const auto lab = lab_in(options.folder);
  if (!lab) return bad_input(lab.error());
  const std::string source = (fs::path(options.folder) / (std::string((*lab)->name) + ".cpp")).string();
  const auto checked = check_lab(**lab, source, options.seed, true);
  if (!checked) return bad_input(checked.error());
  if (const auto done = write_result(options, **lab, *checked, source); !done) return bad_input(done.error());
  const write::Function& function = *write::find_function((*lab)->function);
  const int status = checked->judged.first ? 1 : 0;
  const std::string text = report(function, *checked);
  if (!options.show || !checked->first) return Printed{text, status};
  const CounterExample& shown = checked->shortest ? *checked->shortest : *checked->first;
  const std::string lesson = write::lesson_of(function, shown.input, shown.answer, told(function, shown, ""));
  const std::string path = (fs::path(options.folder) / "counter-example.toml").string();
  if (const auto done = write_file(path, lesson); !done) return bad_input(done.error());
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
  WindowOptions window;
  window.lesson = path;
  const int opened = open_window(window);
  return Printed{"", opened != 0 ? opened : status};
}

}  // namespace

void add_lab(Commands& commands) {
  CLI::App& group = *commands.app.add_subcommand("lab", "Write C++ that is tried on random and on hard cases");
  group.footer("`snug lab new` writes a folder to begin with, `snug lab check` builds and tries what you wrote there.");
  group.require_subcommand(1);

  CLI::App& start = *group.add_subcommand("new", "Write a folder to begin with");
  std::string names;
  for (const Lab& lab : labs()) names += (names.empty() ? "" : ", ") + std::string(lab.name);
  start.footer(
      "Writes a stub, its header, three tests, a CMakeLists.txt and a README.md, and prints the stub's path. A\n"
      "folder that is not empty is left alone. The labs: " +
      names + '.');
  const auto started = add_command<LabOptions>(commands, start, new_lab);
  start.add_option("NAME", started->name, "The lab")->required();
  start.add_option("DIR", started->folder, "The folder")->required();

  CLI::App& checked = *group.add_subcommand("check", "Build and try what you wrote");
  checked.footer(
      "Builds the function with this machine's compiler, with warnings and with the address and undefined-behaviour\n"
      "sanitizers, and runs it in a process of its own: ten seconds, 512 MiB, no network, no other programs, no "
      "changes\n"
      "to files. Prints a line for each kind of cases, the first case that differs, the shortest that was found, and\n"
      "where it crashed; writes result.json, which has the source, for snug grade. Exit status 1 if a case differs.");
  const auto options =
      add_command<LabOptions>(commands, checked, [open_window = commands.open_window](const LabOptions& given) {
        return check(given, open_window);
      });
  checked.add_option("DIR", options->folder, "The folder that snug lab new has made")->required();
  checked.add_option("--student", options->student, "Your name, for the result file");
  checked.add_option("--seed", options->seed, "Of the random cases; 1 unless told")->transform(seed_of_page());
  checked.add_flag("--show", options->show, "Open the case in the window, as a lesson that is written beside it");
}

}  // namespace snug::desktop
