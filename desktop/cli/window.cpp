// The commands that use the window: no subcommand, and render and chart, which draw a picture instead.
#include <algorithm>
#include <optional>

#include "desktop/cli/command.hpp"
#include "desktop/cli/defaults.hpp"
#include "desktop/cli/definitions.hpp"
#include "desktop/cli/did_you_mean.hpp"
#include "desktop/cli/drafts.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/cli/lesson_files.hpp"
#include "desktop/cli/steps.hpp"
#include "desktop/cli/words.hpp"

namespace snug::desktop {
namespace {

/// The error if the lesson, with these points, does not have the place that is asked for.
tl::expected<void, InputError> check_place(const LessonFile& file, const WindowOptions& options) {
  auto session = open_lesson(file);
  if (!session) return tl::unexpected(session.error());
  const auto in_file = [&](InputError error) {
    error.file = file.path;
    return tl::unexpected(std::move(error));
  };
  lesson::Place at = options.at;
  if (options.seed) at.seed = options.seed;
  if (options.points == nullptr) {
    const auto gone = lesson::go_to(at, *session, mesh_named);
    return gone ? tl::expected<void, InputError>() : in_file(gone.error().error);
  }
  if (options.seed) session->stage().scatter(*options.seed);
  if (const auto loaded = session->stage().load(*options.points, options.points_file); !loaded) return loaded;
  const auto gone = lesson::go_in_run(at, *session);
  return gone ? tl::expected<void, InputError>() : in_file(gone.error());
}

/// Lessons of one's own are opened as far as they can be read.
tl::expected<void, InputError> check_drafts(const WindowOptions& options) {
  const std::string path = is_path(options.lesson) ? options.lesson : "";
  const auto drafts = Drafts::open(options.folder, path);
  if (!drafts) return tl::unexpected(drafts.error());
  const bool known = options.lesson.empty() || !path.empty() || drafts->find(options.lesson) != nullptr;
  return known ? tl::expected<void, InputError>() : tl::unexpected(no_lesson(options.folder, options.lesson));
}

/// Where a lesson is named by the page's address of a place in it: takes the place from there. Errors: what is wrong
/// with the address; options that it leaves nothing to.
tl::expected<void, InputError> take_address(WindowOptions& options) {
  if (options.lesson.find('?') == std::string::npos) return {};
  if (!options.at.is_bare() || options.seed)
    return tl::unexpected(
        InputError{.what = "the address says which step, seed and algorithm: leave those options out"});
  lesson::PlaceRead read = lesson::read_place(options.lesson.substr(options.lesson.find('?')));
  if (!read.problems.empty()) return tl::unexpected(InputError{.what = read.problems.front()});
  if (read.place.lesson.empty()) return tl::unexpected(InputError{.what = "the address names no lesson"});
  options.lesson = read.place.lesson;
  options.at = std::move(read.place);
  return {};
}

/// Reports what can be found wrong before there is a window, and then opens it. A program that only becomes the
/// window's leaves that to it.
CommandResult open_on(WindowOptions options, OpenWindow open_window) {
  if (const auto taken = take_address(options); !taken) return bad_input(taken.error());
  if (!open_window.checks_first) return Printed{"", open_window(options)};
  if (!options.points_file.empty()) {
    auto points = read_point_file(options.points_file);  // once, for it may be standard input
    if (!points) return bad_input(points.error());
    options.points = std::make_shared<const io::PointFile>(*std::move(points));
  }
  if (options.screenshot.empty() && is_own(options)) {
    if (const auto checked = check_drafts(options); !checked) return bad_input(checked.error());
  } else if (!options.lesson.empty()) {
    const auto file = find_lesson(options.folder, options.lesson);
    if (!file) return bad_input(file.error());
    WindowOptions place = options;
    if (options.steps) place.at.step = (*options.steps)[1];
    if (!place.at.is_bare())
      if (const auto checked = check_place(*file, place); !checked) return bad_input(checked.error());
  }
  return Printed{"", open_window(options)};
}

/// The error if a picture cannot be written so; none if it can.
std::optional<InputError> wrong_picture(const WindowOptions& options) {
  const std::string &path = options.screenshot, ending = is_standard_output(path) ? "png" : ending_of(path);
  const auto wrong = [&](const char* what) { return InputError{.what = what, .file = path}; };
  if (options.steps && ending != "gif") return wrong("steps are written as an animation: the name must end in .gif");
  if (options.steps) return std::nullopt;
  if (ending == "gif") return wrong("an animation is of several steps: --steps K-M says which");
  if (ending == "svg" && !options.stage_alone) return wrong("an SVG is of the stage alone: add --stage");
  if (ending == "png" || ending == "svg") return std::nullopt;
  return wrong("pictures are written as PNG, SVG or GIF: the name must end in .png, .svg or .gif, or be - for a PNG on "
               "standard output");
}

constexpr int kMostFrames = 500, kMostAnimationPixels = 1920 * 1080;

/// The error if the animation would be too large; none if it can be drawn.
std::optional<InputError> wrong_steps(const WindowOptions& options) {
  if (!options.steps) return std::nullopt;
  const auto [first, last] = *options.steps;
  if (options.scale * options.scale * options.width * options.height > kMostAnimationPixels)
    return InputError{.what = "--size: an animation has at most 1920x1080 pixels"};
  if (options.transparent) return InputError{.what = "--transparent: an animation keeps its ground"};
  if (last - first >= kMostFrames) return InputError{.what = "--steps: an animation has at most 500 steps"};
  return std::nullopt;
}

std::string parse_steps(const std::string& text, WindowOptions& options) {
  options.steps = steps_of(text);
  return options.steps ? "" : '"' + text + "\" is no range of steps: K-M, such as 0-12";
}

/// The same for a chart, which can be SVG as well.
std::optional<InputError> wrong_chart(const std::string& path) {
  if (is_standard_output(path) || ending_of(path) == "png" || ending_of(path) == "svg") return std::nullopt;
  return InputError{.what = "charts are written as PNG or SVG: the name must end in .png or .svg, or be - for a PNG on "
                            "standard output",
                    .file = path};
}

/// Parses "1280x800" as two numbers.
std::string parse_size(const std::string& text, WindowOptions& options) {
  int width = 0, height = 0;
  char x = 0, more = 0;
  constexpr int kLeast = 64, kMost = 8192;
  if (std::sscanf(text.c_str(), "%5d%c%5d%c", &width, &x, &height, &more) != 3 || x != 'x' || width < kLeast ||
      height < kLeast || width > kMost || height > kMost)
    return "\"" + text + "\" is not a size: WxH, each from 64 to 8192";
  options.width = width;
  options.height = height;
  options.sized = true;
  return {};
}

/// Adds --step: a number, or "end".
CLI::Option* add_step(CLI::App& command, WindowOptions& options) {
  const CLI::Validator step = whole_number(0, std::numeric_limits<int>::max());
  return command.add_option_function<std::string>(
      "--step",
      [&options, step](std::string text) {
        if (text == "end") return static_cast<void>(options.at.step = lesson::Place::kLastStep);
        if (const std::string wrong = step(text); !wrong.empty()) throw CLI::ValidationError("--step", wrong);
        options.at.step = std::stoi(text);
      },
      "The step to show; end for the last");
}

void add_common(CLI::App& command, WindowOptions& options) {
  CLI::Option* const step = add_step(command, options);
  command.add_option("--algorithm", options.at.algorithm, "The lesson's algorithm to show; by default its first");
  CLI::Option* const question =
      command.add_option("--question", options.at.question, "Id of the question to show, at its own step");
  question->excludes(step);
  command.add_flag("--answered", options.at.answered, "With the outcome of the question's model answer")
      ->needs(question);
  add_lessons_folder(command, options.folder);
  command.add_option("--seed", options.seed, "Seed of the points; by default the lesson's own")
      ->transform(seed_of_page());
  command.add_option("--situation", options.at.situation, "The situation to show; by default the lesson's own");
  add_size(command, options);
  command.add_option("--points", options.points_file, "Point file to show instead of the lesson's points");
}

/// Adds --theme and --scale.
void add_look(CLI::App& command, WindowOptions& options) {
  command.add_option("--theme", options.theme, "light, dark, contrast or projector; by default as SNUG_THEME says")
      ->check(CLI::IsMember({"light", "dark", "contrast", "projector"}));
  command.add_option("--scale", options.scale, "1, 2 or 4 device pixels for each pixel of the size; 1 by default")
      ->check(CLI::IsMember({1, 2, 4}));
}

}  // namespace

void add_size(CLI::App& command, WindowOptions& options) {
  command.add_option_function<std::string>(
      "--size",
      [&options](const std::string& text) {
        if (const std::string wrong = parse_size(text, options); !wrong.empty())
          throw CLI::ValidationError("--size", wrong);
      },
      "WxH in pixels; 1280x800 by default");
}

std::optional<std::array<int, 2>> steps_of(const std::string& text) {
  int first = 0, last = 0;
  char more = 0;
  if (std::sscanf(text.c_str(), "%7d-%7d%c", &first, &last, &more) != 2 || first < 0 || last <= first)
    return std::nullopt;
  return std::array{first, last};
}

bool is_own(const WindowOptions& options) { return !options.folder.empty() || is_path(options.lesson); }

std::optional<std::string> neither_command_nor_lesson(const CLI::App& snug, const std::string& word) {
  if (is_path(word) || find_lesson("", word, Read::kAsWritten)) return std::nullopt;
  std::vector<std::string> commands;
  for (const CLI::App* command : subcommands_of(snug)) commands.push_back(command->get_name());
  std::string meant = did_you_mean(word, commands);
  if (meant.empty()) meant = did_you_mean(word, lesson_ids(""));
  std::string points;  // where it may be meant as a file of points
  if (word.find('.') != std::string::npos) {
    const std::vector<std::string> endings{".xyz", ".csv", ".txt", ".obj", ".ply", ".stl", ".off"};
    points = ", and point files end in " + joined(endings);
    if (meant.empty()) meant = did_you_mean('.' + ending_of(word), endings);
  }
  return '"' + word + "\" is neither a command nor a lesson" + points + meant + " (see `snug --help`)";
}

void add_window(Commands& commands) {
  auto options = std::make_shared<WindowOptions>();
  auto word = std::make_shared<std::string>();
  constexpr const char* kWhich =
      "The lesson to open: its id, or its file, which ends in .toml; by default the course's page, or the lesson last "
      "open. Or a point file, to see which volume suits it";
  CLI::Option* const lesson = commands.app.add_option("--lesson", options->lesson, "The same as LESSON");
  commands.app.add_option("LESSON", *word, kWhich)->excludes(lesson);
  add_common(commands.app, *options);
  commands.chosen = [options, word, snug = &commands.app, open_window = commands.open_window]() -> CommandResult {
    if (!word->empty() && options->points_file.empty() && io::is_point_extension(ending_of(*word)))
      options->points_file = *word, options->lesson = kPointsLesson;
    else if (!word->empty()) options->lesson = *word;
    if (!word->empty() && !is_own(*options))
      if (const auto wrong = neither_command_nor_lesson(*snug, options->lesson)) return bad_input(*wrong);
    if (options->width < kLeastWidth || options->height < kLeastHeight)
      return bad_input("--size: the window is at least " + std::to_string(kLeastWidth) + "x" +
                       std::to_string(kLeastHeight) + "; snug render draws smaller pictures");
    return open_on(*options, open_window);
  };
}

void add_render(Commands& commands) {
  CLI::App& command =
      *commands.app.add_subcommand("render", "Draw a step of a lesson as a picture, or steps as an animation");
  command.footer(
      "The picture is a PNG; with --stage also an SVG, in which words are text; with --steps an animated GIF. Each "
      "carries\n"
      "the address of what it shows, for the page. With --question the question stands open in it; with --answered as "
      "well, its model "
      "answer\n"
      "was given, and the outcome is told. For another look set SNUG_THEME to dark, contrast or projector. Drawing\n"
      "needs a display; xvfb-run provides one.");
  const auto options = add_command<WindowOptions>(
      commands, command, [open_window = commands.open_window](const WindowOptions& chosen) -> CommandResult {
        if (auto wrong = wrong_picture(chosen)) return bad_input(std::move(*wrong));
        if (auto wrong = wrong_steps(chosen)) return bad_input(std::move(*wrong));
        return open_on(chosen, open_window);
      });
  command
      .add_option("LESSON", options->lesson,
                  "The lesson's id, or its file, which ends in .toml; or the page's address of a place in it")
      ->required();
  add_common(command, *options);
  command.add_flag("--stage", options->stage_alone, "The stage alone, without panels, buttons and sentence");
  CLI::Option* const transparent =
      command.add_flag("--transparent", options->transparent, "Without a ground; with --stage");
  transparent->needs("--stage");
  command.add_flag_callback(
      "--no-labels", [options] { options->labels = false; }, "Without names and measures on the stage");
  add_look(command, *options);
  command
      .add_option_function<std::string>(
          "--steps",
          [&chosen = *options](const std::string& text) {
            if (const std::string wrong = parse_steps(text, chosen); !wrong.empty())
              throw CLI::ValidationError("--steps", wrong);
          },
          "K-M: an animation from step K to step M")
      ->excludes("--step")
      ->excludes("--question");
  command.add_option("--pause", options->pause, "Seconds from step to step in an animation; 0.8 by default")
      ->check(number_in(0.05, 10));
  command
      .add_option("-o,--output", options->screenshot, "PNG, SVG or GIF file to write; - is a PNG on standard output")
      ->required();
}

void add_chart(Commands& commands) {
  CLI::App& command = *commands.app.add_subcommand("chart", "Draw a result of snug cost as a picture");
  command.footer(
      "RESULT is a table of costs, growth, a turn, or the trials of one claim, as snug cost writes it in CSV or JSON.\n"
      "The picture is a PNG or an SVG, by its name's ending. An SVG has the colours for a light and a dark background, "
      "and\n"
      "needs no display; to draw a PNG, xvfb-run provides one. For another look use --theme, or set SNUG_THEME.\n"
      "A chart can tell 28 series apart; a table with more is refused.");
  const auto options = add_command<WindowOptions>(
      commands, command, [open_window = commands.open_window](const WindowOptions& chosen) -> CommandResult {
        if (auto wrong = wrong_chart(chosen.screenshot)) return bad_input(std::move(*wrong));
        return Printed{"", open_window(chosen)};
      });
  command.add_option("RESULT", options->chart, "Table to draw")->required();
  command.add_option("--against", options->chart_then,
                     "Earlier result of the same kind, on the same points, to draw beside it");
  add_size(command, *options);
  command.add_flag("--transparent", options->transparent, "Without a ground");
  add_look(command, *options);
  command.add_option("-o,--output", options->screenshot, "PNG or SVG file to write; - is a PNG on standard output")
      ->required();
}

}  // namespace snug::desktop
