// The commands that use the window: no subcommand, and render and chart, which draw a picture instead.
#include <optional>

#include "desktop/cli/command.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/cli/lesson_files.hpp"

namespace snug::desktop {
namespace {

/// Reports what can be found wrong before there is a window, and then opens it.
CommandResult open_on(const WindowOptions& options, int (*open_window)(const WindowOptions&)) {
  if (!options.lesson.empty())
    if (const auto file = find_lesson("", options.lesson); !file) return bad_input(file.error());
  if (!options.points_file.empty())
    if (const auto points = read_point_file(options.points_file); !points) return bad_input(points.error());
  return Printed{"", open_window(options)};
}

/// The error if a picture cannot be written there; none if it can.
std::optional<InputError> wrong_picture(const std::string& path) {
  if (is_standard_output(path) || ending_of(path) == "png") return std::nullopt;
  return InputError{.what = "pictures are written as PNG: the name must end in .png, or be - for standard output",
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

void add_size(CLI::App& command, WindowOptions& options) {
  command.add_option_function<std::string>(
      "--size",
      [&options](const std::string& text) {
        if (const std::string wrong = parse_size(text, options); !wrong.empty())
          throw CLI::ValidationError("--size", wrong);
      },
      "WxH in pixels; 1280x800 by default");
}

void add_common(CLI::App& command, WindowOptions& options) {
  command.add_option("--step", options.step, "The step to show")
      ->transform(whole_number(0, std::numeric_limits<int>::max()));
  command.add_option("--seed", options.seed, "Seed of the points; by default the lesson's own")
      ->transform(whole_number());
  add_size(command, options);
  command.add_option("--points", options.points_file, "Point file to show instead of the lesson's points");
}

}  // namespace

void add_window(Commands& commands) {
  auto options = std::make_shared<WindowOptions>();
  commands.app.add_option("--lesson", options->lesson, "Id of the lesson to open; by default the first");
  add_common(commands.app, *options);
  commands.chosen = [options, open_window = commands.open_window]() -> CommandResult {
    if (options->width < kLeastWidth || options->height < kLeastHeight)
      return bad_input("--size: the window is at least " + std::to_string(kLeastWidth) + "x" +
                       std::to_string(kLeastHeight) + "; snug render draws smaller pictures");
    return open_on(*options, open_window);
  };
}

void add_render(Commands& commands) {
  CLI::App& command = *commands.app.add_subcommand("render", "Draw one step of a lesson as a picture");
  command.footer(
      "The picture is a PNG. For another look set SNUG_THEME to dark, contrast or projector. Drawing needs a display;\n"
      "xvfb-run provides one.");
  const auto options = add_command<WindowOptions>(
      commands, command, [open_window = commands.open_window](const WindowOptions& chosen) -> CommandResult {
        if (auto wrong = wrong_picture(chosen.screenshot)) return bad_input(std::move(*wrong));
        return open_on(chosen, open_window);
      });
  command.add_option("LESSON", options->lesson, "The lesson's id")->required();
  add_common(command, *options);
  command.add_flag("--stage", options->stage_alone, "The stage alone, without panels, buttons and sentence");
  command.add_option("-o,--output", options->screenshot, "PNG file to write; - is standard output")->required();
}

void add_chart(Commands& commands) {
  CLI::App& command = *commands.app.add_subcommand("chart", "Draw a result of snug cost as a picture");
  command.footer(
      "RESULT is a table of costs, growth or a turn, as snug cost writes it in CSV or JSON. The picture is a PNG. For\n"
      "another look set SNUG_THEME to dark, contrast or projector. A chart can tell 28 series apart; a table with "
      "more\n"
      "is refused. Drawing needs a display; xvfb-run provides one.");
  const auto options = add_command<WindowOptions>(
      commands, command, [open_window = commands.open_window](const WindowOptions& chosen) -> CommandResult {
        if (auto wrong = wrong_picture(chosen.screenshot)) return bad_input(std::move(*wrong));
        return Printed{"", open_window(chosen)};
      });
  command.add_option("RESULT", options->chart, "Table to draw")->required();
  command.add_option("--against", options->chart_then,
                     "Earlier result of the same kind, on the same points, to draw beside it");
  add_size(command, *options);
  command.add_option("-o,--output", options->screenshot, "PNG file to write; - is standard output")->required();
}

}  // namespace snug::desktop
