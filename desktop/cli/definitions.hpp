// The command line's own definitions, of which its help, manual and completions are made.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace snug::desktop {

/// A command and what calls it: "snug lesson check".
struct Defined {
  std::string call;
  const CLI::App* app;
};

/// The subcommands of a command that its help lists.
[[nodiscard]] std::vector<const CLI::App*> subcommands_of(const CLI::App& app);

/// `snug` and all commands below it, each before its own.
[[nodiscard]] std::vector<Defined> all_commands(const CLI::App& snug);

/// The options of a command, without what stands in a place.
[[nodiscard]] std::vector<const CLI::Option*> options_of(const CLI::App& app);

/// An option's names as they are typed: "-o", "--output".
[[nodiscard]] std::vector<std::string> names_of(const CLI::Option& option);

/// Whether something follows the option.
[[nodiscard]] bool takes_value(const CLI::Option& option);

/// What may follow the option, where it is one of a few words; else nothing.
[[nodiscard]] std::vector<std::string> values_of(const CLI::Option& option);

/// The help of a command.
[[nodiscard]] std::string help_of(const Defined& command);

}  // namespace snug::desktop
