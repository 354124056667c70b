// What the subcommands share: how one registers itself, and what it returns.
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "desktop/cli/files.hpp"
#include "desktop/window.hpp"
#include "geometry/input_error.hpp"

namespace snug::desktop {

/// The output for stdout. It is printed at the end, so that a command that fails half way prints nothing.
struct Printed {
  std::string text;
  int status = 0;                         // 1 if a check says no
  std::vector<InputError> warnings = {};  // each is a line on stderr
};

/// The output, or errors: each is a line on stderr, and the status is 2.
using CommandResult = tl::expected<Printed, std::vector<InputError>>;

[[nodiscard]] inline tl::unexpected<std::vector<InputError>> bad_input(InputError error) {
  return tl::unexpected(std::vector<InputError>{std::move(error)});
}
[[nodiscard]] inline tl::unexpected<std::vector<InputError>> bad_input(std::string what) {
  return bad_input(InputError{.what = std::move(what)});
}

/// The program under construction: each group of subcommands adds itself, and sets what to run when it is chosen.
struct Commands {
  CLI::App& app;
  OpenWindow open_window;
  std::function<CommandResult()> chosen;
  bool json = false;  // whether results are printed as JSON in a terminal as well
};

/// Checks a whole number, because the parser's own reading wraps -1 around, takes 010 for 8 and accepts numbers that
/// are too large. Use it with transform, which passes the checked number on.
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

/// Seeds that a page can hold, in its numbers and its address: it refuses larger ones.
inline CLI::Validator seed_of_page() { return whole_number(0, std::uint64_t{1} << 53); }

/// A number of a range. The parser's own takes what is not a number for one of every range.
inline CLI::Validator number_in(double least, double most) {
  const auto is_number = [](const std::string& text) {
    return std::isnan(std::atof(text.c_str())) ? "\"" + text + "\" is not a number" : std::string();
  };
  return CLI::Range(least, most) & CLI::Validator(is_number, "");
}

/// The options of every command that reads points from a file, and no faces.
inline void add_reading(CLI::App& command, Reading& reading) {
  reading.faces = false;
  command.add_flag("--strict", reading.strict, "Refuse a point file of which something would be passed over");
  command.add_flag("--skip-nan", reading.skip_nan, "Pass over points with a coordinate that is not a finite number");
}

/// How commands that read a file take a named case in its place.
inline constexpr const char* kCaseHelp = "A named case in place of FILE; `snug cases` lists them";

/// Adds --lessons.
inline void add_lessons_folder(CLI::App& command, std::string& folder) {
  command.add_option("--lessons", folder, "Folder of the lesson files; by default the program's own");
}

/// Adds --size: WxH in pixels.
void add_size(CLI::App& command, WindowOptions& options);

void add_window(Commands& commands);
void add_fit(Commands& commands);
void add_algorithms(Commands& commands);
void add_cases(Commands& commands);
void add_overlap(Commands& commands);
void add_update(Commands& commands);
void add_cull(Commands& commands);
void add_cost(Commands& commands);
void add_which(Commands& commands);
void add_chart(Commands& commands);
void add_scene(Commands& commands);
void add_lesson(Commands& commands);
void add_exercise(Commands& commands);
void add_demo(Commands& commands);
void add_grade(Commands& commands);
void add_lab(Commands& commands);
void add_trace_hash(Commands& commands);
void add_render(Commands& commands);
void add_package(Commands& commands);
void add_help(Commands& commands);
void add_ids(Commands& commands);
void add_made_of_definitions(Commands& commands);

/// Why a word is no use where a command or a lesson could stand; none if it is a lesson, or may be a file.
[[nodiscard]] std::optional<std::string> neither_command_nor_lesson(const CLI::App& snug, const std::string& word);

/// Adds a subcommand with its options, which live as long as the parser may write to them.
template <class Options, class Run>
std::shared_ptr<Options> add_command(Commands& commands, CLI::App& command, Run run) {
  auto options = std::make_shared<Options>();
  command.callback([&commands, options, run] { commands.chosen = [options, run] { return run(*options); }; });
  return options;
}

}  // namespace snug::desktop
