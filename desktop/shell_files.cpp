// The files and the clipboard of the window: points are opened, saved, copied and pasted.
#include <imgui.h>

#include <algorithm>
#include <filesystem>

#include "app/cover.hpp"
#include "desktop/cli/defaults.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/shell.hpp"
#include "io/text.hpp"
#include "lesson/point_subject.hpp"

namespace snug::desktop {
namespace {

constexpr std::size_t kMostRecent = 5;

/// The points as rows of numbers that read back to the same bits.
std::string points_text(const lesson::Session& session, char between) {
  std::string text;
  for (const lesson::Point3& point : lesson::all_points(session.stage().subject().with_points()->unrounded_points())) {
    for (int axis = 0; axis < session.stage().subject().dim(); ++axis)
      text += (axis > 0 ? std::string(1, between) : "") + io::shortest_text(point[axis]);
    text += '\n';
  }
  return text;
}

}  // namespace

std::optional<std::size_t> Shell::lesson_for_points() const {
  for (std::size_t i = 0; i < lessons_.size(); ++i)
    if (lessons_[i].lesson.id == kPointsLesson) return i;
  return std::nullopt;
}

void Shell::open_points(const std::string& path) {
  std::error_code error;
  notice.clear();
  const bool large = std::filesystem::file_size(path, error) >= Loading::kLarge && !error;
  if (const auto lesson = course_shown ? lesson_for_points() : std::nullopt) {
    const auto read = large ? read_start(path, 1).map([](auto&&) { return io::PointFile(); }) : read_point_file(path);
    if (!tell(read)) return;  // the course stays
    open_at_place(*lesson);
    if (!large && notice.empty()) use_points(*read, path);
  } else if (!large) {
    use_file(path);
  }
  if (large && notice.empty()) return begin_loading(path);
  if (notice.empty()) remember(path);
}

void Shell::remember(const std::string& path) {
  std::error_code error;
  const std::string whole = std::filesystem::absolute(path, error).string();
  std::erase(kept_.recent, whole);
  kept_.recent.insert(kept_.recent.begin(), whole);
  kept_.recent.resize(std::min(kept_.recent.size(), kMostRecent));
  kept_.write();
}

void Shell::save_points(const std::string& path) {
  const std::string text = points_text(session(), ending_of(path) == "csv" ? ',' : ' ');
  if (tell(write_file(path, text))) say("Saved as " + path + ".");
}

void Shell::export_table(const std::string& path) {
  if (tell(write_file(path, app_.cover()->file(ending_of(path))))) say("Saved as " + path + ".");
}

void Shell::copy_points() {
  const std::string text = points_text(session(), '\t');  // as spreadsheets take it
  ImGui::SetClipboardText(text.c_str());
  say("Copied: " + std::to_string(std::count(text.begin(), text.end(), '\n')) + " points.");
}

void Shell::paste_points() {
  const char* const text = ImGui::GetClipboardText();
  if (text == nullptr || *text == '\0') return static_cast<void>(notice = "The clipboard has no text.");
  // A name that ends in .csv makes tabs separate columns.
  const auto read = io::read_points(text, "pasted.csv");
  if (!tell(read)) return;
  if (tell(app_.load(*read, "pasted"))) say("Pasted: " + std::to_string(read->points.size()) + " points.");
}

void Shell::switch_course() {
  if (course_shown) open_at_place(lead().first);
  else show_course();
}

}  // namespace snug::desktop
