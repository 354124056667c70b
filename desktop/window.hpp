// The window door: one lesson on the screen, or one step of it in a picture.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace snug::desktop {

struct WindowOptions {
  std::string lesson;  // its id; empty for the first
  int step = 0;
  std::optional<std::uint64_t> seed;  // the lesson's own where there is none
  std::string points_file;            // shown instead of the lesson's points; empty for none
  std::string screenshot;             // where to write one frame as PNG and leave; empty to stay open
  std::string chart, chart_then;      // a result of `snug cost` to draw in place of a lesson, and one that lies over it
  bool stage_alone = false;           // the picture has no panels, buttons or sentence
  int width = 1280, height = 800;
  bool sized = false;  // they were asked for: a window does not shrink to the screen then
};

/// A window's least size: below it panels would print over each other.
inline constexpr int kLeastWidth = 900, kLeastHeight = 600;

/// Returns the exit status of the program; what went wrong is said on stderr.
int run_window(const WindowOptions& options);

}  // namespace snug::desktop
