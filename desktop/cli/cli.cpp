#include "desktop/cli/cli.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>

#include "desktop/cli/command.hpp"

namespace snug::desktop {
namespace {

constexpr const char* kDescription =
    "Snug teaches bounding volumes: how they are fitted, how tight they are, and what that costs.\n"
    "With no subcommand it opens its window.";

constexpr const char* kFooter =
    "Data goes to stdout, messages to stderr. Exit status: 0 done, 1 an answer of \"no\" from a check,\n"
    "2 bad input or usage: one line on stderr, \"snug: FILE:LINE: what is wrong\", and nothing on stdout.\n"
    "`snug COMMAND --help` says all of a command.";

/// One line, whatever the message was.
void complain(std::string what) {
  std::replace(what.begin(), what.end(), '\n', ' ');
  std::fprintf(stderr, "snug: %s\n", what.c_str());
}

int print(const Printed& printed) {
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

int run(int argc, const char* const* argv, int (*open_window)(const WindowOptions&)) {
  CLI::App app(kDescription, "snug");
  app.footer(kFooter);
  app.set_version_flag("--version", SNUG_VERSION);
  app.require_subcommand(0, 1);
  Commands commands{app, open_window, {}};
  for (const auto add : {add_window, add_fit, add_algorithms, add_update, add_overlap, add_cull, add_cost, add_chart,
                         add_scene, add_lesson, add_trace_hash, add_render})
    add(commands);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help and --version
    const int status = app.exit(success);
    if (std::cout.flush()) return status;
    complain(std::string("standard output: ") + std::strerror(errno));
    return 2;
  } catch (const CLI::ParseError& error) {
    complain(std::string(error.what()) + " (snug --help says what there is)");
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
