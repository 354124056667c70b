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

/// A file's bytes; "-" is standard input. most: of a file that is longer, or has no end, only a little more is read.
/// Errors: there is none, it is a directory, it cannot be read.
[[nodiscard]] tl::expected<std::string, InputError> read_file(const std::string& path,
                                                              std::size_t most = std::string::npos);

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

/// A whole file at once. Errors: as of NewFile.
[[nodiscard]] tl::expected<void, InputError> write_file(const std::string& path, std::string_view bytes);

/// The folder that the program lies in: lessons/ and assets/ are beside it.
[[nodiscard]] std::filesystem::path program_folder();

}  // namespace snug::desktop
