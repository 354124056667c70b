#include "desktop/cli/cli.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>
#include <vector>

#include "desktop/cli/command.hpp"
#include "desktop/cli/defaults.hpp"
#include "desktop/cli/definitions.hpp"
#include "desktop/cli/did_you_mean.hpp"
#include "desktop/cli/human.hpp"
#include "desktop/cli/terminal.hpp"
#include "desktop/cli/words.hpp"

namespace snug::desktop {
namespace {

constexpr const char* kDescription =
    "Snug teaches bounding volumes: how they are fitted, how tight they are, and what that costs.\n"
    "Without a subcommand it opens its window: on its own lessons or, with --lessons FOLDER, on those of a folder, "
    "each\n"
    "reloaded when its file is saved.";

constexpr const char* kFooter =
    "Data goes to standard output, messages to standard error; - as a file name is standard input or output. A file\n"
    "may have up to 512 MiB. Exit status: 0 done, 1 a check failed, 2 bad input or usage: one line on standard\n"
    "error, \"snug: FILE:LINE: what is wrong\", and nothing on standard output.\n"
    "JSON Lines are printed as tables in a terminal, in colour unless NO_COLOR is set; in a pipe, and with --json, as\n"
    "they are.\n"
    "`snug help COMMAND` describes a command in full.";

/// Prints a message as one line. It may quote what a file says.
void complain(const std::string& what) { std::fprintf(stderr, "snug: %s\n", without_controls(what).c_str()); }

/// What is printed: JSON Lines as a table, where people read it.
std::string for_reader(const std::string& text, bool json) {
  return json || !is_terminal() || !text.starts_with('{') ? text : human_text(text, terminal_width(), has_color());
}

int print(const Printed& printed, bool json) {
  for (InputError warning : printed.warnings) {
    warning.what = kWarning + warning.what;
    complain(warning.message());
  }
  const std::string text = for_reader(printed.text, json);
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (written && std::fflush(stdout) == 0) return printed.status;
  complain(std::string("standard output: ") + std::strerror(errno));
  return 2;
}

int run_chosen(const Commands& commands) {
  const CommandResult result =
      read_defaults().map_error([](InputError&& error) { return std::vector{std::move(error)}; }).and_then([&] {
        return commands.chosen();
      });
  if (result) return print(*result, commands.json || commands.app.get_subcommands().empty());
  for (const InputError& error : result.error()) complain(error.message());
  return 2;
}

bool is_number(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0';
}

/// Turns "--axis 0 0 1 FILE" into "--axis=0,0,1 FILE", because the parser would take FILE for another number. The
/// arguments are returned last first, as the parser needs them.
std::vector<std::string> joined_numbers(int argc, const char* const* argv) {
  std::vector<std::string> joined;
  bool is_list = false;
  for (int i = 1; i < argc; ++i) {
    const std::string text = argv[i];
    if (is_list && is_number(text)) {
      joined.back() += (joined.back().back() == '=' ? "" : ",") + text;
      continue;
    }
    is_list = (text == "--axis" || text == "--move") && i + 1 < argc && is_number(argv[i + 1]);
    joined.push_back(is_list ? text + "=" : text);
  }
  std::reverse(joined.begin(), joined.end());
  return joined;
}

/// Adds --json to the commands that print JSON Lines. Those that print text otherwise have one of their own.
/// before: the call so far, with a blank at its end.
void add_json(CLI::App& above, bool& json, const std::string& before = "") {
  constexpr std::array<std::string_view, 19> kPrintJson{
      "fit",           "algorithms",  "cases",         "overlap",       "update",          "cull",
      "scene",         "lesson list", "lesson check",  "lesson play",   "lesson coverage", "lesson facts",
      "demo list",     "demo check",  "exercise list", "exercise make", "exercise answer", "exercise print",
      "exercise check"};
  for (CLI::App* const command : above.get_subcommands([](const CLI::App*) { return true; })) {
    const std::string call = before + command->get_name();
    add_json(*command, json, call + ' ');
    if (CLI::Option* const own = command->get_option_no_throw("--json"); own != nullptr)
      own->each([&json](const std::string&) { json = true; });
    else if (std::find(kPrintJson.begin(), kPrintJson.end(), call) != kPrintJson.end())
      command->add_flag("--json", json, "JSON Lines, in a terminal as well");
  }
}

/// The subcommand read so far: "snug lesson check".
Defined chosen_of(const CLI::App& app) {
  Defined chosen{app.get_name(), &app};
  for (auto below = app.get_subcommands(); !below.empty(); below = chosen.app->get_subcommands())
    chosen = {chosen.call + ' ' + below.front()->get_name(), below.front()};
  return chosen;
}

/// What follows the parser's message: the option or the command that may have been meant.
std::string meant(const Defined& chosen, const std::vector<std::string>& unexpected) {
  for (const std::string& word : unexpected) {
    std::vector<std::string> known;
    if (word.starts_with('-'))
      for (const CLI::Option* option : options_of(*chosen.app))
        for (std::string& name : names_of(*option)) known.push_back(std::move(name));
    else
      for (const CLI::App* command : subcommands_of(*chosen.app)) known.push_back(command->get_name());
    if (std::string says = did_you_mean(word.substr(0, word.find('=')), known); !says.empty()) return says;
  }
  return {};
}

/// The parser's message, but of an option that is given too often in words that say so: the parser's are
/// "--volume: At Most 1 required but received 2".
std::string said_of(const CLI::ParseError& error) {
  const std::string what = error.what(), too_often = ": At Most 1 required but received ";
  const std::size_t at = what.find(too_often);
  if (at == std::string::npos) return what;
  const std::string times = what.substr(at + too_often.size());
  return what.substr(0, at) + " is given " + (times == "2" ? "twice" : times + " times");
}

/// What was wrong with the arguments, in one line.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const Defined chosen = chosen_of(app);
  // The parser took a mistyped command for a lesson, and its options for the window's.
  const auto& lesson = app.get_option("LESSON")->results();
  if (chosen.app == &app && !lesson.empty())
    if (auto wrong = neither_command_nor_lesson(app, lesson.front())) return *std::move(wrong);
  return said_of(error) + meant(chosen, app.remaining(true)) + " (see `" + chosen.call + " --help`)";
}

int run(int argc, const char* const* argv, OpenWindow open_window) {
  CLI::App app(kDescription, "snug");
  app.footer(kFooter);
  app.set_version_flag("-V,--version", SNUG_VERSION);
  app.require_subcommand(0, 1);
  Commands commands{app, open_window, {}};
  for (const auto add : {add_window,     add_fit,
                         add_algorithms, add_cases,
                         add_update,     add_overlap,
                         add_cull,       add_cost,
                         add_which,      add_chart,
                         add_scene,      add_lesson,
                         add_exercise,   add_demo,
                         add_grade,      add_lab,
                         add_package,    add_trace_hash,
                         add_render,     add_help,
                         add_ids,        add_made_of_definitions})
    add(commands);
  add_json(app, commands.json);
  try {
    app.parse(joined_numbers(argc, argv));
  } catch (const CLI::Success& success) {  // --help and --version
    const int status = app.exit(success);
    if (std::cout.flush()) return status;
    complain(std::string("standard output: ") + std::strerror(errno));
    return 2;
  } catch (const CLI::ParseError& error) {
    complain(usage_error(app, error));
    return 2;
  }
  return run_chosen(commands);
}

}  // namespace

int run_command(int argc, const char* const* argv, OpenWindow open_window) {
  try {
    return run(argc, argv, open_window);
  } catch (const std::bad_alloc&) {
    complain("there is not enough memory for that");
  } catch (const std::exception& error) {
    complain(error.what());
  }
  return 2;
}

}  // namespace snug::desktop
