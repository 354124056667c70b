#include "desktop/shell.hpp"

#include "desktop/cli/files.hpp"

namespace snug::desktop {
namespace {

std::string mesh_path(const std::string& name) { return (program_folder() / "assets" / "meshes" / (name + ".ply")).string(); }

}  // namespace

tl::expected<void, InputError> Shell::open(const std::string& id) {
  for (const LessonFile& file : lessons_) {
    if (file.lesson.id != id) continue;
    std::optional<io::PointFile> mesh;
    if (!file.lesson.points.mesh.empty()) {
      auto read = read_point_file(mesh_path(file.lesson.points.mesh));
      if (!tell(read)) return tl::unexpected(read.error());
      mesh = std::move(*read);
    }
    auto opened = app_.open(file.lesson, std::move(mesh));
    tell(opened);
    return opened;
  }
  return tl::unexpected(InputError{.what = "there is no lesson \"" + id + "\": `snug lesson list` says which there are"});
}

void Shell::use_mesh(const std::string& name) {
  const auto read = read_point_file(mesh_path(name));
  if (tell(read)) tell(session().load(*read, name));
}

void Shell::use_file(const std::string& path) {
  const auto read = read_point_file(path);
  if (tell(read)) tell(session().load(*read, std::filesystem::path(path).filename().string()));
}

}  // namespace snug::desktop
