#include "desktop/shell.hpp"

#include <filesystem>

#include "app/subjects/cost/costs.hpp"
#include "desktop/cli/cost_file.hpp"
#include "desktop/cli/files.hpp"

namespace snug::desktop {
namespace {

std::string mesh_path(const std::string& name) {
  return (program_folder() / "assets" / "meshes" / (name + ".ply")).string();
}

/// stem.csv in that folder, or stem-2.csv, stem-3.csv …: the first that is not there, so that nothing is overwritten.
std::filesystem::path new_name(const std::filesystem::path& folder, const std::string& stem,
                               const std::string& extension) {
  std::error_code ignored;
  std::filesystem::path path = folder / (stem + extension);
  for (int n = 2; std::filesystem::exists(path, ignored); ++n)
    path = folder / (stem + "-" + std::to_string(n) + extension);
  return path;
}

/// Which table of what was measured the file begins as; empty for none.
std::string result_in(const std::string& path) {
  const auto text = read_file(path);
  return text ? table_name(*text) : std::string();
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
    hint_shown = false, typed = {};
    if (opened) open_ = static_cast<std::size_t>(&file - lessons_.data());
    tell(opened);
    return opened;
  }
  return tl::unexpected(
      InputError{.what = "there is no lesson \"" + id + "\": `snug lesson list` says which there are"});
}

void Shell::use_mesh(const std::string& name) {
  const auto read = read_point_file(mesh_path(name));
  if (tell(read)) tell(app_.load(*read, name));
}

template <class Row>
void Shell::lay_over(const std::string& path) {
  auto table = read_table<Row>(path);
  if (tell(table) && !app::costs_of(app_)->lay_over(session(), std::move(*table))) notice = app::kPredictFirst;
}

void Shell::use_file(const std::string& path) {
  if (const std::string table = app::costs_of(app_) != nullptr ? result_in(path) : ""; !table.empty()) {
    if (table == cost::GrowthRow::kTable) lay_over<cost::GrowthRow>(path);
    else if (table == cost::TurnRow::kTable) lay_over<cost::TurnRow>(path);
    else lay_over<cost::CostRow>(path);
    return;
  }
  const auto read = read_point_file(path);
  if (tell(read)) tell(app_.load(*read, std::filesystem::path(path).filename().string()));
}

void Shell::save_costs(const std::string& format) {
  const app::Costs& costs = *app::costs_of(app_);
  if (costs.sheet().rows() == 0) {
    notice = "Not saved: nothing has been measured yet.";
    return;
  }
  const std::string name = costs.view() == app::CostView::kAccuracy
                               ? "costs"
                               : std::string(app::kCostViewNames[static_cast<std::size_t>(costs.view())]);
  std::error_code gone;
  const std::filesystem::path folder = std::filesystem::current_path(gone);
  if (gone || !std::filesystem::exists(folder, gone)) {
    notice = "Not saved: the folder that Snug was started in is no longer there. Start Snug in another one.";
    return;
  }
  const std::string path = new_name(folder, "snug-" + name, "." + format).string();
  const auto written = write_file(path, format == "csv" ? costs.sheet().csv() : costs.sheet().json());
  if (tell(written)) notice = "Saved as " + path + ".";
}

}  // namespace snug::desktop
