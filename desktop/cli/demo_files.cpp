#include "desktop/cli/demo_files.hpp"

#include <algorithm>

#include "desktop/cli/files.hpp"

namespace snug::desktop {
namespace {

using Found = tl::expected<std::shared_ptr<const DemoFile>, std::vector<InputError>>;

Found read_file_of(const std::string& path) {
  auto text = read_start(path, lesson::kMostLessonBytes);
  if (!text) return tl::unexpected(std::vector<InputError>{text.error()});
  lesson::DemoDraft draft = lesson::read_demo(*text, path);
  if (draft.mistakes.empty())
    return std::make_shared<const DemoFile>(DemoFile{path, *std::move(text), std::move(draft.demo)});
  std::vector<InputError> errors;
  for (const lesson::FileError& mistake : draft.mistakes) errors.push_back(with_column(mistake));
  return tl::unexpected(std::move(errors));
}

}  // namespace

tl::expected<std::vector<std::string>, InputError> demo_paths(const std::string& folder) {
  return lesson_paths(folder_in_lessons(folder, "demos").string());
}

Found find_demo(const std::string& folder, const std::string& id) {
  if (is_path(id)) return read_file_of(id);
  const auto paths = demo_paths(folder);
  if (!paths) return tl::unexpected(std::vector<InputError>{paths.error()});
  for (const std::string& path : *paths)
    if (id_of(path) == id) return read_file_of(path);
  return tl::unexpected(
      std::vector<InputError>{{.what = "there is no demo \"" + id + "\"; `snug demo list` lists them"}});
}

InputError at_key(const DemoFile& file, const lesson::DemoState& state, std::string_view key, const InputError& error) {
  const std::string quoted = '"' + std::string(key) + "\": ";
  return with_column({state.place_of(key), quoted + error.message(), file.path});
}

}  // namespace snug::desktop
