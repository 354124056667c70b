// snug help; and snug man and snug completions, which the build calls.
#include "desktop/cli/command.hpp"
#include "desktop/cli/completions.hpp"
#include "desktop/cli/definitions.hpp"
#include "desktop/cli/did_you_mean.hpp"
#include "desktop/cli/manual.hpp"

namespace snug::desktop {
namespace {

struct HelpOptions {
  std::vector<std::string> command;
};

CommandResult run_help(const CLI::App& snug, const HelpOptions& options) {
  Defined found{snug.get_name(), &snug};
  for (const std::string& word : options.command) {
    std::vector<std::string> known;
    const CLI::App* next = nullptr;
    for (const CLI::App* sub : subcommands_of(*found.app)) {
      known.push_back(sub->get_name());
      if (sub->get_name() == word) next = sub;
    }
    if (next == nullptr)
      return bad_input('"' + word + "\" is not a command of " + found.call + did_you_mean(word, known));
    found = {found.call + ' ' + word, next};
  }
  return Printed{help_of(found)};
}

struct ShellOptions {
  std::string shell;
};

}  // namespace

void add_help(Commands& commands) {
  CLI::App& command = *commands.app.add_subcommand("help", "Describe a command in full, as its --help does");
  const auto options = add_command<HelpOptions>(
      commands, command, [&snug = commands.app](const HelpOptions& given) { return run_help(snug, given); });
  command.add_option("COMMAND", options->command, "The command, such as fit or lesson check; by default snug itself");
}

void add_made_of_definitions(Commands& commands) {
  constexpr const char* kHidden = "";
  CLI::App& manual = *commands.app.add_subcommand("man", "Print the manual page")->group(kHidden);
  add_command<ShellOptions>(commands, manual,
                            [&snug = commands.app](const ShellOptions&) { return Printed{manual_of(snug)}; });
  CLI::App& command = *commands.app.add_subcommand("completions", "Print a shell's completions")->group(kHidden);
  const auto options = add_command<ShellOptions>(commands, command, [&snug = commands.app](const ShellOptions& given) {
    return Printed{completions_of(snug, given.shell)};
  });
  command.add_option("SHELL", options->shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
}

}  // namespace snug::desktop
