// The window: a lesson on the screen, or one step of it as a picture.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "io/point_file.hpp"
#include "lesson/exercise/attempt.hpp"
#include "lesson/place.hpp"

namespace snug::desktop {

struct DemoFile;

struct WindowOptions {
  std::string folder;                      // of the lessons; empty for the program's own
  std::string lesson;                      // its id, or its file; empty for the first
  std::string exercise;                    // its id, to open instead of a lesson; empty for none
  std::optional<lesson::Attempt> attempt;  // to watch: what was decided in it; none to decide
  std::shared_ptr<const DemoFile> demo;    // to play instead of a lesson; null for none
  std::string pictures;                    // the folder or PDF to draw its states into; empty to play it
  lesson::Place at;                        // where in it; bare for where it was left, or for its start in a picture
  std::optional<std::uint64_t> seed;       // none: the lesson's own
  std::string points_file;                 // a file shown instead of the lesson's points; empty for none
  std::shared_ptr<const io::PointFile> points;  // what was read of it, for standard input can be read only once
  std::string screenshot;                       // where to write one frame as PNG before closing; empty to stay open
  std::string chart, chart_then;  // a `snug cost` result to draw instead of a lesson; an earlier one over it
  bool stage_alone = false;       // whether the picture is without panels, buttons and sentence
  std::string theme;              // of the picture; empty: as SNUG_THEME says
  int scale = 1;                  // device pixels of the picture for each of its pixels
  bool transparent = false, labels = true;
  std::optional<std::array<int, 2>> steps;  // from one to the other, as an animation
  double pause = 0.8;                       // seconds from step to step in it
  int width = 1280, height = 800;
  bool sized = false;  // whether a size was requested: the window then does not shrink to the screen
};

/// A window's least size: below it panels would print over each other.
inline constexpr int kLeastWidth = 900, kLeastHeight = 600;

/// Whether the lessons are not those of the program.
[[nodiscard]] bool is_own(const WindowOptions& options);

/// How a command opens the window.
struct OpenWindow {
  /// checks_first: whether the command checks what it can before; where another program takes this one's place, that
  /// one checks, and reads standard input.
  OpenWindow(int (*run)(const WindowOptions&), bool checks_first = true) : run(run), checks_first(checks_first) {}
  int operator()(const WindowOptions& options) const { return run(options); }
  int (*run)(const WindowOptions&);
  bool checks_first;
};

/// Returns the program's exit status; errors are printed on stderr.
int run_window(const WindowOptions& options);

}  // namespace snug::desktop
