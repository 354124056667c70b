// What the subcommands share: how one registers itself, and what it gives back.
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <functional>
#include <limits>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "desktop/window.hpp"
#include "geometry/input_error.hpp"

namespace snug::desktop {

/// What goes to stdout in the end: a command that fails half way has printed nothing.
struct Printed {
  std::string text;
  int status = 0;  // 1 where a check says no
};

/// Each error is a line on stderr, and the status is 2.
using CommandResult = tl::expected<Printed, std::vector<InputError>>;

[[nodiscard]] inline tl::unexpected<std::vector<InputError>> bad_input(InputError error) {
  return tl::unexpected(std::vector<InputError>{std::move(error)});
}
[[nodiscard]] inline tl::unexpected<std::vector<InputError>> bad_input(std::string what) {
  return bad_input(InputError{.what = std::move(what)});
}

/// The program as it is put together: each group of subcommands adds itself, and says what to run when it is chosen.
struct Commands {
  CLI::App& app;
  int (*open_window)(const WindowOptions&);
  std::function<CommandResult()> chosen;
};

/// The parser's own reading of numbers wraps -1 around, takes 010 for 8 and lets what is too large pass. To be had with
/// transform, which hands it the number as it is meant.
inline CLI::Validator whole_number(std::uint64_t least = 0,
                                   std::uint64_t most = std::numeric_limits<std::uint64_t>::max()) {
  const auto read = [least, most](std::string& text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value < least || value > most)
      return "\"" + text + "\" is not a whole number from " + std::to_string(least) + " to " + std::to_string(most);
    text = std::to_string(value);
    return std::string();
  };
  return CLI::Validator(read, "");
}

void add_window(Commands& commands);
void add_fit(Commands& commands);
void add_algorithms(Commands& commands);
void add_overlap(Commands& commands);
void add_update(Commands& commands);
void add_cull(Commands& commands);
void add_cost(Commands& commands);
void add_chart(Commands& commands);
void add_scene(Commands& commands);
void add_lesson(Commands& commands);
void add_trace_hash(Commands& commands);
void add_render(Commands& commands);

/// A subcommand with options of its own, which live as long as the parser may write to them.
template <class Options, class Run>
std::shared_ptr<Options> add_command(Commands& commands, CLI::App& command, Run run) {
  auto options = std::make_shared<Options>();
  command.callback([&commands, options, run] { commands.chosen = [options, run] { return run(*options); }; });
  return options;
}

}  // namespace snug::desktop
