// snug ids: what the shells' completions offer where a lesson, an exercise and so on is named.
#include <algorithm>

#include "desktop/cli/command.hpp"
#include "desktop/cli/definitions.hpp"
#include "desktop/cli/demo_files.hpp"
#include "desktop/cli/exercise_files.hpp"
#include "desktop/cli/lab_check.hpp"
#include "desktop/cli/lesson_files.hpp"
#include "desktop/cli/write_js.hpp"
#include "desktop/cli/written_files.hpp"
#include "measure/trials.hpp"

namespace snug::desktop {
namespace {

using Ids = std::vector<std::string>;

/// Files' names: nothing is read, for a shell waits.
Ids named(const tl::expected<std::vector<std::string>, InputError>& paths, const std::string& before = "") {
  Ids ids;
  if (paths)
    for (const std::string& path : *paths) ids.push_back(before + id_of(path));
  return ids;
}

Ids in_folder(const char* name) { return named(lesson_paths(folder_in_lessons("", name).string())); }

void add(Ids& ids, const Ids& more, const std::string& before = "") {
  for (const std::string& id : more) ids.push_back(before + id);
}

Ids lessons() {
  Ids ids = named(lesson_paths(""));
  add(ids, in_folder("labs"));
  add(ids, in_folder("cases"));
  return ids;
}

Ids exercises() {
  Ids ids = in_folder("exercises");
  std::erase(ids, "sets");
  add(ids, named(written_paths(""), std::string(kWritePrefix)));
  return ids;
}

Ids sets() {
  Ids ids;
  if (const auto read = read_sets_of(""))
    for (const lesson::ExerciseSet& set : *read) ids.push_back(set.id);
  return ids;
}

/// What `snug package` takes.
Ids packages() {
  Ids ids{"course"};
  add(ids, named(lesson_paths("")), "lesson:");
  add(ids, exercises(), "exercise:");
  add(ids, sets(), "set:");
  return ids;
}

Ids labs_by_name() {
  Ids ids;
  for (const Lab& lab : labs()) ids.emplace_back(lab.name);
  return ids;
}

Ids claims() {
  Ids ids;
  for (const cost::Claim* claim : cost::tried_claims()) ids.emplace_back(claim->name);
  return ids;
}

Ids of_kind(IdKind kind) {
  switch (kind) {
    case IdKind::kLessons: return lessons();
    case IdKind::kCases: return in_folder("cases");
    case IdKind::kExercises: return exercises();
    case IdKind::kSets: return sets();
    case IdKind::kDemos: return in_folder("demos");
    case IdKind::kPackages: return packages();
    case IdKind::kLabs: return labs_by_name();
    case IdKind::kClaims: return claims();
  }
  return {};
}

struct IdsOptions {
  Ids kinds;
};

CommandResult run_ids(const IdsOptions& options) {
  Printed printed;
  for (const std::string& name : options.kinds) {
    const auto kind = std::find(kIdKinds.begin(), kIdKinds.end(), name) - kIdKinds.begin();
    for (const std::string& id : of_kind(static_cast<IdKind>(kind))) printed.text += id + '\n';
  }
  return printed;
}

}  // namespace

void add_ids(Commands& commands) {
  CLI::App& command = *commands.app.add_subcommand("ids", "Print what completions offer")->group("");
  const auto options = add_command<IdsOptions>(commands, command, run_ids);
  command.add_option("KIND", options->kinds, "What they name")
      ->required()
      ->check(CLI::IsMember(std::vector<std::string>(kIdKinds.begin(), kIdKinds.end())));
}

}  // namespace snug::desktop
