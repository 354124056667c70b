// Reads and writes whole files for the command line.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "geometry/input_error.hpp"
#include "io/point_file.hpp"

namespace snug::desktop {

/// Larger files are refused before they are in memory, as the command line's help says.
inline constexpr std::size_t kMostFileBytes = std::size_t{512} << 20;

/// A file's bytes; "-" is standard input. Errors: it is missing, is a directory, cannot be read, or has more than
/// kMostFileBytes (or no end).
[[nodiscard]] tl::expected<std::string, InputError> read_file(const std::string& path);

/// The same, but of a longer file only a little more than `most` bytes.
[[nodiscard]] tl::expected<std::string, InputError> read_start(const std::string& path, std::size_t most);

/// Whether the path means standard output: "-".
[[nodiscard]] inline bool is_standard_output(std::string_view path) { return path == "-"; }

/// What follows the last dot of the file's name, in lower case: "csv"; empty if there is none.
[[nodiscard]] std::string ending_of(const std::string& path);

/// How a warning begins.
inline constexpr const char* kWarning = "warning: ";

/// What is wanted of a point file, and what becomes of the parts that are passed over.
struct Reading : io::Wanted {
  bool strict = false;
};

/// The points of a file, as io::read_points reads them. What is passed over is a warning on stderr. Errors: those of
/// both, and of a strict reading what would be passed over.
[[nodiscard]] tl::expected<io::PointFile, InputError> read_point_file(const std::string& path,
                                                                      const Reading& reading = {});

/// A file that is written as a whole: the old content stays until all of the new content is on the disk. A device or
/// pipe is written to directly.
class NewFile {
 public:
  /// Errors: a directory, a missing folder, or anything else that prevents writing.
  [[nodiscard]] static tl::expected<NewFile, InputError> create(const std::string& path);
  NewFile(NewFile&&) noexcept = default;
  NewFile& operator=(NewFile&&) = delete;
  /// Removes a file that was not put in place.
  ~NewFile();

  /// put_in_place reports its errors.
  void write(std::string_view bytes);
  [[nodiscard]] tl::expected<void, InputError> put_in_place();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  NewFile(std::string path, std::filesystem::path target, std::filesystem::path part)
      : path_(std::move(path)), target_(std::move(target)), part_(std::move(part)) {}

  std::string path_;              // as the user gave it
  std::filesystem::path target_;  // with links followed
  std::filesystem::path part_;    // the file that is written; target_ itself if that is a device
  std::unique_ptr<std::FILE, Close> file_;
  int error_ = 0;
};

/// Writes a whole file at once; "-" is standard output. Errors: those of NewFile.
[[nodiscard]] tl::expected<void, InputError> write_file(const std::string& path, std::string_view bytes);

}  // namespace snug::desktop
