// What `snug trace-hash` prints, without the command line: for WebAssembly, where there is none.
// usage: MESH_FOLDER LESSON.toml ...
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "lesson/trace_hash.hpp"

namespace {

using namespace snug;

tl::expected<std::string, InputError> read_file(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) return tl::unexpected(InputError{.what = "cannot be opened", .file = path});
  std::string bytes;
  char buffer[4096];
  while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, file.get())) bytes.append(buffer, n);
  return bytes;
}

tl::expected<lesson::TraceHash, InputError> hash_of(lesson::Lesson lesson, const std::string& meshes) {
  std::optional<io::PointFile> mesh;
  if (!lesson.points.mesh.empty()) {
    const std::string path = meshes + "/" + lesson.points.mesh + ".ply";
    auto file = read_file(path).and_then([&](const std::string& bytes) { return io::read_points(bytes, path); });
    if (!file) return tl::unexpected(file.error());
    mesh = std::move(*file);
  }
  return lesson::Session::open(std::move(lesson), std::move(mesh)).and_then([](lesson::Session&& session) {
    return lesson::trace_hash(session);
  });
}

int fail(const InputError& error) {
  std::fprintf(stderr, "%s\n", error.message().c_str());
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<lesson::Lesson> lessons;
  for (int i = 2; i < argc; ++i) {
    const std::string path = argv[i];
    auto lesson = read_file(path).and_then([&](const std::string& text) { return lesson::read_lesson(text, path); });
    if (!lesson) return fail(lesson.error());
    lessons.push_back(std::move(*lesson));
  }
  for (lesson::Lesson& lesson : lessons) {
    const auto hash = hash_of(std::move(lesson), argv[1]);
    if (!hash) return fail(hash.error());
    std::puts(lesson::line_of(*hash).c_str());
  }
}
