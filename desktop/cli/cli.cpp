#include "desktop/cli/cli.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>
#include <vector>

#include "desktop/cli/command.hpp"

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
    "`snug COMMAND --help` describes a command in full.";

/// Prints a message as one line.
void complain(std::string what) {
  std::replace(what.begin(), what.end(), '\n', ' ');
  std::fprintf(stderr, "snug: %s\n", what.c_str());
}

int print(const Printed& printed) {
  for (InputError warning : printed.warnings) {
    warning.what = kWarning + warning.what;
    complain(warning.message());
  }
  const bool written = std::fwrite(printed.text.data(), 1, printed.text.size(), stdout) == printed.text.size();
  if (written && std::fflush(stdout) == 0) return printed.status;
  complain(std::string("standard output: ") + std::strerror(errno));
  return 2;
}

int run_chosen(const Commands& commands) {
  const CommandResult result = commands.chosen();
  if (result) return print(*result);
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

/// The subcommands read so far: "snug lesson check".
std::string command_line_of(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return app.get_name() + (chosen.empty() ? "" : " " + command_line_of(*chosen.front()));
}

int run(int argc, const char* const* argv, int (*open_window)(const WindowOptions&)) {
  CLI::App app(kDescription, "snug");
  app.footer(kFooter);
  app.set_version_flag("--version", SNUG_VERSION);
  app.require_subcommand(0, 1);
  Commands commands{app, open_window, {}};
  for (const auto add :
       {add_window, add_fit, add_algorithms, add_cases, add_update, add_overlap, add_cull, add_cost, add_which,
        add_chart, add_scene, add_lesson, add_exercise, add_grade, add_trace_hash, add_render})
    add(commands);
  try {
    app.parse(joined_numbers(argc, argv));
  } catch (const CLI::Success& success) {  // --help and --version
    const int status = app.exit(success);
    if (std::cout.flush()) return status;
    complain(std::string("standard output: ") + std::strerror(errno));
    return 2;
  } catch (const CLI::ParseError& error) {
    complain(std::string(error.what()) + " (see `" + command_line_of(app) + " --help`)");
    return 2;
  }
  return run_chosen(commands);
}

}  // namespace

int run_command(int argc, const char* const* argv, int (*open_window)(const WindowOptions&)) {
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
