// The command line's own definitions, of which its help, manual and completions are made.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
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

/// Whether the option is followed by algorithms of the volume that the command's --volume names.
[[nodiscard]] bool is_of_volume(const Defined& command, const CLI::Option& option);
/// The algorithms of each volume, by its name, and at the end those of all, by "*".
[[nodiscard]] std::vector<std::pair<std::string, std::vector<std::string>>> algorithms_by_volume();

/// What has ids, which `snug ids` prints by these names.
enum class IdKind : std::uint8_t { kLessons, kCases, kExercises, kSets, kDemos, kPackages, kLabs, kClaims };
inline constexpr std::array<std::string_view, 8> kIdKinds{"lessons", "cases",    "exercises", "sets",
                                                          "demos",   "packages", "labs",      "claims"};

/// What may stand where the option's value stands, by its id: the names of kinds, with a blank between them; empty
/// where no ids stand.
[[nodiscard]] std::string ids_of(const Defined& command, const CLI::Option& option);
/// The same for what stands in a place.
[[nodiscard]] std::string ids_in_place(const Defined& command);

/// The help of a command.
[[nodiscard]] std::string help_of(const Defined& command);

}  // namespace snug::desktop
