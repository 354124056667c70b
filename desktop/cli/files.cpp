#include "desktop/cli/files.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <random>

namespace snug::desktop {
namespace {

namespace fs = std::filesystem;

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

tl::unexpected<InputError> cannot(const std::string& path, const char* what, int error) {
  return tl::unexpected(InputError{.what = std::string(what) + ": " + std::strerror(error), .file = path});
}

tl::expected<std::string, InputError> read_all(std::FILE* file, const std::string& path) {
  std::string bytes;
  std::array<char, 1 << 16> buffer;
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), file))
    bytes.append(buffer.data(), n);
  if (std::ferror(file) != 0) return cannot(path, "cannot be read", errno);
  return bytes;
}

tl::expected<void, InputError> write_all(const std::string& path, const fs::path& to, const char* mode,
                                         std::string_view bytes) {
  File file(std::fopen(to.c_str(), mode));
  if (!file) return cannot(path, "cannot be written", errno);
  if (std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size() || std::fflush(file.get()) != 0)
    return cannot(path, "cannot be written", errno);
  if (std::fclose(file.release()) != 0) return cannot(path, "cannot be written", errno);
  return {};
}

}  // namespace

tl::expected<std::string, InputError> read_file(const std::string& path) {
  if (path == "-") return read_all(stdin, path);
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return tl::unexpected(InputError{.what = "is a directory", .file = path});
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) return cannot(path, "cannot be opened", errno);
  return read_all(file.get(), path);
}

tl::expected<io::PointFile, InputError> read_point_file(const std::string& path) {
  return read_file(path).and_then([&](const std::string& bytes) { return io::read_points(bytes, path); });
}

tl::expected<void, InputError> write_file(const std::string& path, std::string_view bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) return tl::unexpected(InputError{.what = "is a directory", .file = path});
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_all(path, path, "wb", bytes);
  // Through a link to what it leads to, so that the link stays one.
  const fs::path target = fs::exists(status) ? fs::canonical(path, error) : fs::path(path);
  fs::path part = target;
  part += "." + std::to_string(std::random_device{}()) + ".part";
  auto written = write_all(path, part, "wbx", bytes);
  if (written) {
    if (fs::exists(status)) fs::permissions(part, status.permissions(), error);
    fs::rename(part, target, error);
    if (!error) return written;
    written = cannot(path, "cannot be written", error.value());
  }
  fs::remove(part, error);
  return written;
}

fs::path program_folder() {
  std::error_code error;
  const fs::path program = fs::canonical("/proc/self/exe", error);
  return error ? fs::current_path(error) : program.parent_path();
}

}  // namespace snug::desktop
