// The file of --steps.
#pragma once

#include <optional>
#include <string>

#include "desktop/cli/command.hpp"
#include "desktop/cli/files.hpp"

namespace snug::desktop {

using TraceFile = std::optional<NewFile>;

/// None where no path is given. Errors: as of NewFile; that the answers go there.
[[nodiscard]] tl::expected<TraceFile, InputError> trace_file(const std::string& path);

/// What a command answers, once its trace is in place. Of a command that failed nothing is left.
[[nodiscard]] CommandResult with_trace(CommandResult printed, TraceFile& trace);

}  // namespace snug::desktop
