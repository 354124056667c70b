// The file of --steps.
#pragma once

#include <optional>
#include <string>

#include "desktop/cli/command.hpp"
#include "desktop/cli/files.hpp"

namespace snug::desktop {

using TraceFile = std::optional<NewFile>;

/// Creates the trace file; none if no path is given. input: the file that is read; "-" is standard input, and "" is
/// none. Errors: those of NewFile; standard output, where the answers go; the input, which it would replace.
[[nodiscard]] tl::expected<TraceFile, InputError> trace_file(const std::string& path, const std::string& input);

/// Puts the trace in place and returns the command's answers. A failed command leaves no trace.
[[nodiscard]] CommandResult with_trace(CommandResult printed, TraceFile& trace);

}  // namespace snug::desktop
