// snug lesson new: a small lesson that passes, to be made one's own.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

#include "desktop/cli/data_folder.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/cli/lesson_commands.hpp"
#include "lesson/names.hpp"
#include "lesson/subjects.hpp"

namespace snug::desktop {
namespace {

struct NewOptions {
  std::string id;
  std::string subject = "cloud";
  std::string folder = ".";
};

/// What an address and a file's name can have alike: small letters, digits and hyphens.
bool is_id(const std::string& id) {
  const auto fits = [](unsigned char c) { return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '-'; };
  return !id.empty() && id.size() <= 64 && id.front() != '-' && std::all_of(id.begin(), id.end(), fits);
}

std::vector<std::string_view> subject_names() {
  std::vector<std::string_view> names;
  for (const lesson::SubjectRow* row : lesson::subjects())
    if (!lesson::is_among(names, row->name)) names.push_back(row->name);
  return names;
}

CommandResult run_new(const NewOptions& options) {
  if (!is_id(options.id))
    return bad_input("a lesson's id has small letters, digits and hyphens, and at most 64 of them: " + options.id);
  const std::filesystem::path example = data_folder() / "lessons" / "examples" / (options.subject + ".toml");
  const auto names = subject_names();
  std::error_code error;
  if (!lesson::is_among(names, options.subject) || !std::filesystem::exists(example, error))
    return bad_input("--subject " + lesson::none_of_text(options.subject, names));
  const std::string path = (std::filesystem::path(options.folder) / (options.id + ".toml")).lexically_normal().string();
  if (std::filesystem::exists(path, error)) return bad_input({.what = "is there already", .file = path});
  const auto text = read_file(example.string());
  if (!text) return bad_input(text.error());
  auto file = NewFile::create(path);
  if (!file) return bad_input(file.error());
  file->write(*text);
  if (const auto placed = file->put_in_place(); !placed) return bad_input(placed.error());
  return Printed{path + '\n'};
}

}  // namespace

void add_lesson_new(Commands& commands, CLI::App& group) {
  CLI::App& start = *group.add_subcommand("new", "Write a small lesson to begin with");
  start.footer(
      "Writes ID.toml, a small lesson that passes `snug lesson check`, and prints its path. A file that is there\n"
      "already is left alone. lessons/README.md says what each key means.");
  const auto options = add_command<NewOptions>(commands, start, run_new);
  start
      .add_option("--subject", options->subject,
                  "What its stage is about: cloud, pair, volumes, frustum, field, tree, scene, update, cost, criteria "
                  "or claims")
      ->capture_default_str();
  start.add_option("--lessons", options->folder, "The folder to write to")->capture_default_str();
  start.add_option("ID", options->id, "The lesson's id, its file's name without .toml")->required();
}

}  // namespace snug::desktop
