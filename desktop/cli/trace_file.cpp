#include "desktop/cli/trace_file.hpp"

#include <filesystem>

namespace snug::desktop {

tl::expected<TraceFile, InputError> trace_file(const std::string& path, const std::string& input) {
  if (path.empty()) return std::nullopt;
  const auto taken = [&](const char* what) { return tl::unexpected(InputError{.what = what, .file = path}); };
  const auto is_same = [&](const std::string& other) {
    std::error_code none;
    return std::filesystem::is_regular_file(path, none) && std::filesystem::equivalent(path, other, none);
  };
  if (is_standard_output(path) || is_same("/dev/stdout")) return taken("is where the result goes");
  if (is_same(input == "-" ? "/dev/stdin" : input)) return taken("is the file that is read");
  return NewFile::create(path).map([](NewFile&& file) { return TraceFile(std::move(file)); });
}

CommandResult with_trace(CommandResult printed, TraceFile& trace) {
  if (!printed || !trace) return printed;
  if (auto placed = trace->put_in_place(); !placed) return bad_input(std::move(placed.error()));
  return printed;
}

}  // namespace snug::desktop
