// Files of the command line: whole ones in, whole ones out.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "geometry/input_error.hpp"
#include "io/point_file.hpp"

namespace snug::desktop {

/// A file's bytes; "-" is standard input. Errors: there is none, it is a directory, it cannot be read.
[[nodiscard]] tl::expected<std::string, InputError> read_file(const std::string& path);

/// The points of a file, as io::read_points reads them. Errors: of both.
[[nodiscard]] tl::expected<io::PointFile, InputError> read_point_file(const std::string& path);

/// Writes a file as a whole: what was there before stays until all of the new one is on the disk. A device or pipe is
/// written to as it is.
[[nodiscard]] tl::expected<void, InputError> write_file(const std::string& path, std::string_view bytes);

/// The folder that the program lies in: lessons/ and assets/ are beside it.
[[nodiscard]] std::filesystem::path program_folder();

}  // namespace snug::desktop
