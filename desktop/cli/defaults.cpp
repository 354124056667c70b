#include "desktop/cli/defaults.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>
#include <vector>

#include "desktop/cli/data_folder.hpp"
#include "desktop/cli/files.hpp"
#include "lesson/toml_file.hpp"
#include "lesson/toml_table.hpp"

namespace snug::desktop {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = 1 << 16;
constexpr std::array<std::string_view, 4> kThemes{"light", "dark", "contrast", "projector"};

Defaults in_force;

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

/// Where snug.toml is looked for. The specification ignores folders that are not absolute.
std::vector<fs::path> folders_of_defaults() {
  const std::string own = environment("XDG_CONFIG_HOME"), home = environment("HOME"),
                    system = environment("XDG_CONFIG_DIRS");
  std::vector<fs::path> folders{own.empty() ? fs::path(home) / ".config" : fs::path(own)};
  std::istringstream list(system.empty() ? "/etc/xdg" : system);
  for (std::string folder; std::getline(list, folder, ':');) folders.emplace_back(folder);
  std::erase_if(folders, [](const fs::path& folder) { return !folder.is_absolute(); });
  for (fs::path& folder : folders) folder /= "snug";
  folders.push_back(data_folder());
  return folders;
}

/// ~/ is the student's home; a relative folder begins at the file's.
fs::path folder_in(lesson::TomlTable& table, const char* key, const fs::path& file) {
  const std::string text = table.text_or(key, "");
  if (text.empty()) return {};
  if (!text.starts_with("~/")) return (file.parent_path() / text).lexically_normal();
  const std::string home = environment("HOME");
  if (home.empty()) return {};
  return fs::path(home) / text.substr(2);
}

tl::expected<Defaults, InputError> read_file_of_defaults(const fs::path& file) {
  const auto text = read_start(file.string(), kMostBytes);
  if (!text) return tl::unexpected(text.error());
  lesson::Complaints complaints(file.string());
  const auto toml = lesson::parse_file(*text, "a file of defaults", complaints);
  if (!toml) return tl::unexpected(complaints.first()->error());
  lesson::TomlTable table(*toml, "the file", complaints);
  Defaults found{file.string(),
                 folder_in(table, "lessons", file),
                 folder_in(table, "results", file),
                 table.text_or("theme", ""),
                 table.text_or("first_lesson", ""),
                 table.text_or("page", "")};
  std::error_code error;
  if (!found.lessons.empty() && !fs::is_directory(found.lessons, error))
    table.wrong("lessons", "is not a folder: " + found.lessons.string());
  if (!found.theme.empty() && std::find(kThemes.begin(), kThemes.end(), found.theme) == kThemes.end())
    table.wrong("theme", "is light, dark, contrast or projector");
  if (!found.page.empty() && !found.page.starts_with("https://") && !found.page.starts_with("http://"))
    table.wrong("page", "is the address of Snug's page: \"https://...\"");
  const fs::path lesson = (found.lessons.empty() ? data_folder() / "lessons" : found.lessons) / found.first_lesson;
  if (!found.first_lesson.empty() && !fs::exists(lesson.string() + ".toml", error))
    table.wrong("first_lesson", "is not a lesson: there is no " + lesson.string() + ".toml");
  table.refuse_others();
  if (complaints.first() != nullptr) return tl::unexpected(complaints.mistakes().front().error());
  return found;
}

}  // namespace

tl::expected<void, InputError> read_defaults() {
  std::error_code error;
  for (const fs::path& folder : folders_of_defaults())
    if (const fs::path file = folder / "snug.toml"; fs::exists(file, error))
      return read_file_of_defaults(file).map([](Defaults&& found) { in_force = std::move(found); });
  return {};
}

const Defaults& defaults() { return in_force; }

fs::path lessons_folder() { return in_force.lessons.empty() ? data_folder() / "lessons" : in_force.lessons; }

}  // namespace snug::desktop
