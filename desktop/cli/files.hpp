// Files of the command line: whole ones in, whole ones out.
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

/// More bytes are refused before they are in memory; the command line's help says so.
inline constexpr std::size_t kMostFileBytes = std::size_t{512} << 20;

/// A file's bytes; "-" is standard input. Errors: there is none, it is a directory, it cannot be read, it has more than
/// kMostFileBytes, or no end.
[[nodiscard]] tl::expected<std::string, InputError> read_file(const std::string& path);

/// The same, but of a file that has more than so many bytes, a little more than these.
[[nodiscard]] tl::expected<std::string, InputError> read_start(const std::string& path, std::size_t most);

/// Whether the path means standard output: "-".
[[nodiscard]] inline bool is_standard_output(std::string_view path) { return path == "-"; }

/// Behind the last dot of the file's name, in small letters: "csv"; empty where there is none.
[[nodiscard]] std::string ending_of(const std::string& path);

/// The points of a file, as io::read_points reads them. Errors: of both.
[[nodiscard]] tl::expected<io::PointFile, InputError> read_point_file(const std::string& path);

/// A file that comes to be as a whole: what was there before stays until all of the new one is on the disk. A device or
/// pipe is written to as it is.
class NewFile {
 public:
  /// Errors: a directory, a folder that is not there, or whatever else keeps it from being written.
  [[nodiscard]] static tl::expected<NewFile, InputError> create(const std::string& path);
  NewFile(NewFile&&) noexcept = default;
  NewFile& operator=(NewFile&&) = delete;
  /// Nothing is left of a file that was not put in place.
  ~NewFile();

  /// What goes wrong is told by put_in_place.
  void write(std::string_view bytes);
  [[nodiscard]] tl::expected<void, InputError> put_in_place();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  NewFile(std::string path, std::filesystem::path target, std::filesystem::path part)
      : path_(std::move(path)), target_(std::move(target)), part_(std::move(part)) {}

  std::string path_;              // as the user says it
  std::filesystem::path target_;  // behind links
  std::filesystem::path part_;    // what is written to; target_ itself where that is a device
  std::unique_ptr<std::FILE, Close> file_;
  int error_ = 0;
};

/// A whole file at once; "-" is standard output. Errors: as of NewFile.
[[nodiscard]] tl::expected<void, InputError> write_file(const std::string& path, std::string_view bytes);

/// The folder that the program lies in: lessons/ and assets/ are beside it.
[[nodiscard]] std::filesystem::path program_folder();

}  // namespace snug::desktop
