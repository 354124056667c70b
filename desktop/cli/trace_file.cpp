#include "desktop/cli/trace_file.hpp"

#include <filesystem>

namespace snug::desktop {

tl::expected<TraceFile, InputError> trace_file(const std::string& path) {
  if (path.empty()) return std::nullopt;
  const tl::unexpected taken(InputError{.what = "is where the result goes", .file = path});
  if (is_standard_output(path)) return taken;
  std::error_code none;
  if (std::filesystem::is_regular_file(path, none) && std::filesystem::equivalent(path, "/dev/stdout", none))
    return taken;
  return NewFile::create(path).map([](NewFile&& file) { return TraceFile(std::move(file)); });
}

CommandResult with_trace(CommandResult printed, TraceFile& trace) {
  if (!printed || !trace) return printed;
  if (auto placed = trace->put_in_place(); !placed) return bad_input(std::move(placed.error()));
  return printed;
}

}  // namespace snug::desktop
