// The manual page, snug(1), in roff's man macros.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace snug::desktop {

[[nodiscard]] std::string manual_of(const CLI::App& snug);

}  // namespace snug::desktop
