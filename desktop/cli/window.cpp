// What opens the window: no subcommand, and render, which draws into a picture instead.
#include "desktop/cli/command.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/cli/lesson_files.hpp"

namespace snug::desktop {
namespace {

/// What can be seen to be wrong before there is a window is said without one.
CommandResult open_on(const WindowOptions& options, int (*open_window)(const WindowOptions&)) {
  if (!options.lesson.empty())
    if (const auto file = find_lesson("", options.lesson); !file) return bad_input(file.error());
  if (!options.points_file.empty())
    if (const auto points = read_point_file(options.points_file); !points) return bad_input(points.error());
  return Printed{"", open_window(options)};
}

/// "1280x800" as two numbers.
std::string parse_size(const std::string& text, WindowOptions& options) {
  int width = 0, height = 0;
  char x = 0, more = 0;
  constexpr int kLeast = 64, kMost = 8192;
  if (std::sscanf(text.c_str(), "%5d%c%5d%c", &width, &x, &height, &more) != 3 || x != 'x' || width < kLeast ||
      height < kLeast || width > kMost || height > kMost)
    return "\"" + text + "\" is not a size: WxH, each from 64 to 8192";
  options.width = width;
  options.height = height;
  return {};
}

void add_size(CLI::App& command, WindowOptions& options) {
  command.add_option_function<std::string>(
      "--size",
      [&options](const std::string& text) {
        if (const std::string wrong = parse_size(text, options); !wrong.empty())
          throw CLI::ValidationError("--size", wrong);
      },
      "WxH in pixels; 1280x800 if none");
}

void add_common(CLI::App& command, WindowOptions& options) {
  command.add_option("--step", options.step, "The step that is shown")
      ->transform(whole_number(0, std::numeric_limits<int>::max()));
  command.add_option("--seed", options.seed, "Seed of the points; the lesson's own if none")->transform(whole_number());
  add_size(command, options);
  command.add_option("--points", options.points_file, "Point file to show instead of the lesson's points");
}

}  // namespace

void add_window(Commands& commands) {
  auto options = std::make_shared<WindowOptions>();
  commands.app.add_option("--lesson", options->lesson, "Id of the lesson that the window opens; the first if none");
  add_common(commands.app, *options);
  commands.chosen = [options, open_window = commands.open_window] { return open_on(*options, open_window); };
}

void add_render(Commands& commands) {
  CLI::App& command = *commands.app.add_subcommand("render", "Draw one step of a lesson into a picture");
  command.footer("Needs a display; xvfb-run serves.");
  const auto options =
      add_command<WindowOptions>(commands, command, [open_window = commands.open_window](const WindowOptions& chosen) {
        return open_on(chosen, open_window);
      });
  command.add_option("LESSON", options->lesson, "The lesson's id")->required();
  add_common(command, *options);
  command.add_option("-o,--output", options->screenshot, "The PNG file that is written")->required();
}

void add_chart(Commands& commands) {
  CLI::App& command = *commands.app.add_subcommand("chart", "Draw a result of snug cost into a picture");
  command.footer(
      "RESULT: costs, growth or a turn as snug cost --csv or --json writes them. SNUG_THEME is dark, contrast or\n"
      "projector for another look. Needs a display; xvfb-run serves.");
  const auto options = add_command<WindowOptions>(
      commands, command, [open_window = commands.open_window](const WindowOptions& chosen) -> CommandResult {
        return Printed{"", open_window(chosen)};
      });
  command.add_option("RESULT", options->chart, "What is drawn")->required();
  command.add_option("--against", options->chart_then, "An earlier result of the same kind to lie over it");
  add_size(command, *options);
  command.add_option("-o,--output", options->screenshot, "The PNG file that is written")->required();
}

}  // namespace snug::desktop
