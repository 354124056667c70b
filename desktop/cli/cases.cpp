#include "desktop/cli/cases.hpp"

#include "desktop/cli/command.hpp"
#include "desktop/cli/json.hpp"
#include "desktop/cli/lesson_files.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/subjects.hpp"

namespace snug::desktop {
namespace {

using lesson::Session;

tl::unexpected<InputError> not_about(const std::string& name, const char* what) {
  return tl::unexpected(InputError{.what = "the case \"" + name + "\" is not about " + what +
                                           "; `snug cases` says which "
                                           "command takes it"});
}

tl::expected<Session, InputError> session_of(const std::string& name) {
  return find_case(name).and_then([](const LessonFile& file) { return open_lesson(file); });
}

/// A volume as `snug overlap` and `snug cull` read it: its fields under its kind.
Json named(const fit::Volume3& volume, int dim) {
  return {{std::string(kVolumeNames[volume.index()]), json_of(volume, dim)}};
}

/// The command that takes a case.
const char* command_of(const lesson::Subject& subject) {
  if (subject.points() != nullptr) return "fit";
  const lesson::HasVolumes* const own = subject.with_volumes();
  if (own != nullptr && !own->planes().empty()) return "cull";
  return own != nullptr && own->volumes().size() == 2 ? "overlap" : "render";
}

CommandResult run_cases() {
  const auto cases = read_cases();
  if (!cases) return bad_input(cases.error());
  Printed printed;
  for (const LessonFile& file : *cases) {
    const lesson::Lesson& own = file.lesson;
    const auto subject = subject_of(file);
    if (!subject) return bad_input(subject.error());
    Json json{{"case", own.id}, {"title", own.title}, {"says", own.summary}, {"chapter", file.chapter}};
    json["command"] = command_of(**subject);
    json["algorithms"] = own.algorithms;
    json["source"] = own.source.empty() ? Json() : Json(own.source);
    printed.text += line_of(json);
  }
  return printed;
}

}  // namespace

tl::expected<PointCase, InputError> point_case(const std::string& name) {
  auto session = session_of(name);
  if (!session) return tl::unexpected(std::move(session.error()));
  const AnyPointSet* const points = session->stage().subject().points();
  const lesson::Lesson& own = session->lesson();
  const lesson::Method* const first = lesson::find_method(own, own.algorithms.front());
  if (points == nullptr || first == nullptr) return not_about(name, "points");
  return PointCase{*points, lesson::all_points(session->stage().subject().with_points()->unrounded_points()),
                   std::string(first->volume), std::string(first->name)};
}

tl::expected<std::string, InputError> overlap_case(const std::string& name) {
  auto session = session_of(name);
  if (!session) return tl::unexpected(std::move(session.error()));
  const lesson::HasVolumes* const own = session->stage().subject().with_volumes();
  const auto volumes = own != nullptr ? own->volumes() : std::vector<fit::Volume3>();
  if (volumes.size() != 2) return not_about(name, "two volumes");
  return line_of({{"a", named(volumes[0], session->stage().subject().dim())},
                  {"b", named(volumes[1], session->stage().subject().dim())}});
}

tl::expected<std::string, InputError> cull_case(const std::string& name) {
  auto session = session_of(name);
  if (!session) return tl::unexpected(std::move(session.error()));
  const lesson::HasVolumes* const own = session->stage().subject().with_volumes();
  if (own == nullptr || own->planes().empty()) return not_about(name, "a frustum");
  return line_of({{"frustum", {{"planes", own->planes()}}},
                  {"volume", named(own->volumes().front(), session->stage().subject().dim())}});
}

void add_cases(Commands& commands) {
  CLI::App& command =
      *commands.app.add_subcommand("cases", "List the named cases, on which programs are known to fail");
  command.footer(
      "JSON Lines: {\"case\",\"title\",\"says\",\"chapter\",\"command\",\"algorithms\":[..],\"source\"}. source is a "
      "public\n"
      "place where a known program failed on such input, or null. command is the command that takes the case:\n"
      "`snug fit --case NAME`, `snug overlap --case NAME` or `snug cull --case NAME`. `snug render NAME` draws it, "
      "and\n"
      "`snug NAME` opens it in the window.");
  command.callback([&commands] { commands.chosen = run_cases; });
}

}  // namespace snug::desktop
