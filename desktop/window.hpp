// The window: a lesson on the screen, or one step of it as a picture.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "lesson/exercise/attempt.hpp"
#include "lesson/stand.hpp"

namespace snug::desktop {

struct DemoFile;

struct WindowOptions {
  std::string folder;                      // of the lessons; empty for the program's own
  std::string lesson;                      // its id, or its file; empty for the first
  std::string exercise;                    // its id, to open instead of a lesson; empty for none
  std::optional<lesson::Attempt> attempt;  // to watch: what was decided in it; none to decide
  std::shared_ptr<const DemoFile> demo;    // to play instead of a lesson; null for none
  std::string pictures;                    // the folder to draw its states into; empty to play it
  lesson::Standpoint at;                   // where in it; empty for where it was left, or for its start in a picture
  std::optional<std::uint64_t> seed;       // none: the lesson's own
  std::string points_file;                 // a file shown instead of the lesson's points; empty for none
  std::string screenshot;                  // where to write one frame as PNG before closing; empty to stay open
  std::string chart, chart_then;           // a `snug cost` result to draw instead of a lesson; an earlier one over it
  bool stage_alone = false;                // whether the picture is without panels, buttons and sentence
  int width = 1280, height = 800;
  bool sized = false;  // whether a size was requested: the window then does not shrink to the screen
};

/// A window's least size: below it panels would print over each other.
inline constexpr int kLeastWidth = 900, kLeastHeight = 600;

/// Whether the lessons are not those of the program.
[[nodiscard]] bool is_own(const WindowOptions& options);

/// Returns the program's exit status; errors are printed on stderr.
int run_window(const WindowOptions& options);

}  // namespace snug::desktop
