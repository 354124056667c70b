#include "desktop/cli/files.hpp"

#include <array>
#include <cctype>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>
#include <random>
#include <unistd.h>

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

tl::expected<std::string, InputError> read_all(std::FILE* file, const std::string& path, std::size_t most) {
  std::string bytes;
  std::array<char, 1 << 16> buffer;
  while (bytes.size() <= most) {
    const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), file);
    if (n == 0) break;
    bytes.append(buffer.data(), n);
  }
  if (std::ferror(file) != 0) return cannot(path, "cannot be read", errno);
  return bytes;
}

/// The name of the unfinished file, in static memory, because a signal handler must not allocate.
std::array<char, PATH_MAX> unfinished{};

extern "C" void remove_unfinished(int signal) {
  unlink(unfinished.data());
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// Removes the unfinished file if a signal ends the program.
void remove_when_told_to_end(const fs::path& part) {
  std::snprintf(unfinished.data(), unfinished.size(), "%s", part.c_str());
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(signal, remove_unfinished) == SIG_IGN) std::signal(signal, SIG_IGN);
}

}  // namespace

tl::expected<std::string, InputError> read_file(const std::string& path) {
  const InputError too_large{.what = "has more than 512 MiB, the most that is read", .file = path};
  std::error_code no_size;
  const auto size = path == "-" ? 0 : fs::file_size(path, no_size);
  if (!no_size && size > kMostFileBytes) return tl::unexpected(too_large);
  auto bytes = read_start(path, kMostFileBytes);
  if (bytes && bytes->size() > kMostFileBytes) return tl::unexpected(too_large);
  return bytes;
}

tl::expected<std::string, InputError> read_start(const std::string& path, std::size_t most) {
  if (path == "-") return read_all(stdin, path, most);
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return tl::unexpected(InputError{.what = "is a directory", .file = path});
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) return cannot(path, "cannot be opened", errno);
  return read_all(file.get(), path, most);
}

tl::expected<io::PointFile, InputError> read_point_file(const std::string& path, const Reading& reading) {
  auto file = read_file(path).and_then([&](const std::string& bytes) { return io::read_points(bytes, path, reading); });
  if (!file) return file;
  const std::string passed = io::passed_text(file->passed);
  if (passed.empty()) return file;
  if (reading.strict) return tl::unexpected(InputError{.what = passed, .file = path});
  const InputError warning{.what = kWarning + passed, .file = path};
  std::fprintf(stderr, "snug: %s\n", warning.message().c_str());
  return file;
}

tl::expected<NewFile, InputError> NewFile::create(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) return tl::unexpected(InputError{.what = "is a directory", .file = path});
  const bool exists = fs::exists(status);
  // Follows a link to its target, so that the link itself stays.
  const fs::path target = exists ? fs::canonical(path, error) : fs::path(path);
  fs::path part = target;
  const bool aside = !exists || fs::is_regular_file(status);
  if (aside) part += "." + std::to_string(std::random_device{}()) + ".part";
  if (aside) remove_when_told_to_end(part);
  NewFile file(path, target, part);
  file.file_.reset(std::fopen(part.c_str(), aside ? "wbx" : "wb"));
  if (!file.file_) return cannot(path, "cannot be written", errno);
  if (aside && exists) fs::permissions(part, status.permissions(), error);
  return file;
}

NewFile::~NewFile() {
  if (!file_ || part_ == target_) return;
  std::error_code ignored;
  fs::remove(part_, ignored);
}

void NewFile::write(std::string_view bytes) {
  if (error_ == 0 && std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) error_ = errno;
}

tl::expected<void, InputError> NewFile::put_in_place() {
  if (error_ == 0 && std::fflush(file_.get()) != 0) error_ = errno;
  std::error_code failed;
  if (error_ == 0 && part_ != target_) fs::rename(part_, target_, failed);
  if (failed) error_ = failed.value();
  if (error_ != 0) return cannot(path_, "cannot be written", error_);
  file_.reset();
  return {};
}

tl::expected<void, InputError> write_file(const std::string& path, std::string_view bytes) {
  if (is_standard_output(path)) {
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size();
    if (!written || std::fflush(stdout) != 0) return cannot("standard output", "cannot be written", errno);
    return {};
  }
  return NewFile::create(path).and_then([&](NewFile&& file) {
    file.write(bytes);
    return file.put_in_place();
  });
}

std::string ending_of(const std::string& path) {
  std::string ending = fs::path(path).extension().string();
  ending.erase(0, 1);
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

}  // namespace snug::desktop
