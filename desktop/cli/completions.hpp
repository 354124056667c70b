// What a shell offers when Tab is pressed in a snug command.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace snug::desktop {

/// A script for the shell: "bash", "zsh" or "fish".
[[nodiscard]] std::string completions_of(const CLI::App& snug, const std::string& shell);

}  // namespace snug::desktop
