// snug demo list, check, play and pictures.
#include <filesystem>
#include <map>
#include <memory>

#include "desktop/cli/command.hpp"
#include "desktop/cli/demo_files.hpp"
#include "desktop/cli/json.hpp"
#include "lesson/names.hpp"
#include "number/fnv.hpp"

namespace snug::desktop {
namespace {

struct DemoOptions {
  std::string folder;
  std::vector<std::string> files;
  bool write = false;
};

// ---- list ------------------------------------------------------------------------------------------------------

CommandResult list_demos(const DemoOptions& options) {
  const auto paths = demo_paths(options.folder);
  if (!paths) return bad_input(paths.error());
  Printed printed;
  for (const std::string& path : *paths) {
    const auto demo = find_demo(options.folder, path);
    if (!demo) return tl::unexpected(demo.error());
    printed.text += line_of({{"demo", (*demo)->demo.id},
                             {"title", (*demo)->demo.title},
                             {"lecture", (*demo)->demo.lecture},
                             {"states", (*demo)->demo.states.size()},
                             {"file", path}});
  }
  return printed;
}

// ---- check -----------------------------------------------------------------------------------------------------

/// The lessons that were read so far, for a demo comes back to some.
using LessonsRead = std::map<std::string, LessonFile>;

tl::expected<std::uint64_t, InputError> played_hash(const DemoFile& file, const lesson::DemoState& state,
                                                    const std::string& folder, LessonsRead& lessons) {
  if (!lessons.contains(state.lesson)) {
    auto found = find_lesson(folder, state.lesson, Read::kAsWritten);
    if (!found) return tl::unexpected(at_key(file, state, "lesson", found.error()));
    lessons.emplace(state.lesson, *std::move(found));
  }
  auto session = open_lesson(lessons.at(state.lesson));
  if (!session) return tl::unexpected(session.error());
  if (const auto taken = lesson::go_to(state, *session, mesh_named); !taken)
    return tl::unexpected(at_key(file, state, taken.error().key, taken.error().error));
  if (lesson::is_among(state.reveal, lesson::kRevealAnswer) && session->conversation().asked() == nullptr)
    return tl::unexpected(at_key(file, state, "reveal", {.what = "no question stands open at this step"}));
  return session->player().trace_hash();
}

/// A line for a state that is not as it was, and one for the demo.
std::string differences(const DemoFile& file, const std::vector<std::uint64_t>& hashes, std::size_t& differ) {
  std::string text;
  for (std::size_t i = 0; i < hashes.size(); ++i) {
    const lesson::DemoState& state = file.demo.states[i];
    if (state.hash == hashes[i]) continue;
    differ += 1;
    text += line_of({{"demo", file.demo.id},
                     {"state", i + 1},
                     {"slide", state.slide},
                     {"line", state.place.line},
                     {"was", state.hash ? Json(hex_of(*state.hash)) : Json()},
                     {"is", hex_of(hashes[i])}});
  }
  return text + line_of({{"demo", file.demo.id}, {"states", hashes.size()}, {"differ", differ}, {"file", file.path}});
}

CommandResult check_demos(const DemoOptions& options) {
  Printed printed;
  std::vector<std::pair<std::string, std::string>> changed;  // files, and their new text: written if all is well
  std::vector<InputError> mistakes;
  LessonsRead lessons;
  for (const std::string& path : options.files) {
    const auto file = find_demo(options.folder, path);
    if (!file) {
      mistakes.insert(mistakes.end(), file.error().begin(), file.error().end());
      continue;
    }
    std::vector<std::uint64_t> hashes;
    for (const lesson::DemoState& state : (*file)->demo.states) {
      const auto hash = played_hash(**file, state, options.folder, lessons);
      if (hash) hashes.push_back(*hash);
      else mistakes.push_back(hash.error());
    }
    if (hashes.size() != (*file)->demo.states.size()) continue;
    std::size_t differ = 0;
    printed.text += differences(**file, hashes, differ);
    if (differ > 0 && !options.write) printed.status = 1;
    if (differ == 0 || !options.write) continue;
    auto text = lesson::with_hashes((*file)->text, (*file)->demo, hashes);
    if (!text) text.error().file = (*file)->path, mistakes.push_back(with_column(text.error()));
    else changed.emplace_back((*file)->path, *std::move(text));
  }
  if (!mistakes.empty()) return tl::unexpected(std::move(mistakes));
  for (const auto& [path, text] : changed)
    if (const auto done = write_file(path, text); !done) return bad_input(done.error());
  return printed;
}

/// A demo that is shown: every state is tried before there is a window.
struct ShownDemo : WindowOptions {
  std::string id;
};
CommandResult show_demo(ShownDemo options, OpenWindow open_window) {
  const auto file = find_demo("", options.id);
  if (!file) return tl::unexpected(file.error());
  LessonsRead lessons;
  for (const lesson::DemoState& state : (*file)->demo.states)
    if (const auto hash = played_hash(**file, state, "", lessons); !hash) return bad_input(hash.error());
  if (!options.pictures.empty() && ending_of(options.pictures) != "pdf" &&
      !std::filesystem::is_directory(options.pictures))
    return bad_input(InputError{.what = "there is no such folder", .file = options.pictures});
  options.demo = *file;
  return Printed{"", open_window(options)};
}

std::shared_ptr<ShownDemo> add_window_command(Commands& commands, CLI::App& command) {
  auto options =
      add_command<ShownDemo>(commands, command, [open_window = commands.open_window](const ShownDemo& chosen) {
        return show_demo(chosen, open_window);
      });
  command.add_option("FILE", options->id, "The demo's file, which ends in .toml, or its id")->required();
  return options;
}

}  // namespace

void add_demo(Commands& commands) {
  CLI::App& group = *commands.app.add_subcommand("demo", "List, check or play a lecturer's demos");
  group.footer(
      "A demo is a file of states in the order of a lecture's slides: each has a lesson, where in it one stands, what\n"
      "is shown beside the stage, and notes. lessons/README.md lists its keys. On the page,\n"
      "index.html?demo=ID&state=K plays it.");
  group.require_subcommand(1);

  CLI::App& list = *group.add_subcommand("list", "List the demos");
  list.footer("JSON Lines: {\"demo\",\"title\",\"lecture\",\"states\",\"file\"}.");
  add_lessons_folder(list, add_command<DemoOptions>(commands, list, list_demos)->folder);

  CLI::App& check = *group.add_subcommand("check", "Play each state of a demo and compare its hash");
  check.footer("Prints a line for each state whose trace is not what the file says:\n"
               "{\"demo\",\"state\",\"slide\",\"line\",\"was\",\"is\"}, and one for each demo: "
               "{\"demo\",\"states\",\"differ\",\"file\"}.\n"
               "Exit status 1 if a state differs; 2 if one cannot be shown, with file and line on standard error.");
  const auto checked = add_command<DemoOptions>(commands, check, check_demos);
  check.add_option("FILE", checked->files, "Demo files, which end in .toml, or ids of the program's own")->required();
  check.add_flag("--write", checked->write, "Write the hashes that are into the files, and exit with status 0");
  add_lessons_folder(check, checked->folder);

  CLI::App& play = *group.add_subcommand("play", "Present a demo in the window");
  play.footer(
      "Page Down or Right: the next reveal or state. Page Up or Left: back, to what was shown then. Home or H: this\n"
      "state as it was. B or the full stop: black. F: the picture is frozen. S: the notes in a second window. V or a\n"
      "number: the class votes. L, W, R: spotlight, pen, ruler. Q: the state as a code. F11: the whole screen. Esc: "
      "leaves.\n"
      "The card of keys (F1) says more.");
  add_window_command(commands, play);

  CLI::App& pictures = *group.add_subcommand("pictures", "Draw each state of a demo as a picture");
  pictures.footer(
      "Writes 01-LESSON.png and so on, or the pages of one PDF, with all that is revealed. Drawing needs a\n"
      "display; xvfb-run provides one.");
  WindowOptions& drawn = *add_window_command(commands, pictures);
  pictures.add_option("-o,--output", drawn.pictures, "The folder to write to, or a file that ends in .pdf")->required();
  add_size(pictures, drawn);
}

}  // namespace snug::desktop
