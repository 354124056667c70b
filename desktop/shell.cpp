#include "desktop/shell.hpp"

#include <filesystem>

#include "app/costs.hpp"
#include "desktop/cli/cost_file.hpp"
#include "desktop/cli/files.hpp"

namespace snug::desktop {
namespace {

std::string mesh_path(const std::string& name) { return (program_folder() / "assets" / "meshes" / (name + ".ply")).string(); }

/// Whether the file begins as a table of what was measured.
bool is_result(const std::string& path) {
  const auto text = read_file(path);
  return text && (text->starts_with("# snug table:") || text->starts_with("{\"table\""));
}

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
  if (tell(read)) tell(app_.load(*read, name));
}

void Shell::use_file(const std::string& path) {
  if (session().lesson().measures && is_result(path)) {
    auto table = read_costs(path);
    if (tell(table)) app_.costs().lay_over(std::move(*table));
    return;
  }
  const auto read = read_point_file(path);
  if (tell(read)) tell(app_.load(*read, std::filesystem::path(path).filename().string()));
}

void Shell::save_costs(const std::string& format) {
  const app::CostTable& table = app_.costs().table();
  const std::span<const cost::CostRow> rows(table.rows);
  const std::string path = (std::filesystem::current_path() / ("snug-costs." + format)).string();
  const auto written = write_file(path, format == "csv" ? cost::csv_of(table.provenance, rows) : cost::json_of(table.provenance, rows));
  if (tell(written)) notice = "Saved as " + path + ".";
}

}  // namespace snug::desktop
