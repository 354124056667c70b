// A path that the student is asked for.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "app/app.hpp"

namespace snug::desktop {

/// How a picture of the stage is drawn. An animation has its ground, and one pixel for each of the screen's.
struct PictureHow {
  int scale = 2;  // pixels for each of the screen's
  bool transparent = false, labels = true;
  std::optional<app::Theme> theme = {};          // none: the window's own
  std::optional<std::array<int, 2>> steps = {};  // of an animation
};

struct FileCard {
  enum class What : std::uint8_t { kNone, kOpenPoints, kOpenLesson, kSavePoints, kSavePicture, kExportTable, kHandIn };
  What what = What::kNone;
  std::string path;
  bool replaces = false;  // whether the path is of a file that is there, and the next press replaces it
  std::string wrong;      // why the last press did nothing
  bool opened = false;    // just now: the field takes the keyboard
  PictureHow how = {};
  std::string steps = {};  // of an animation, as they are typed: "3-12"
};

}  // namespace snug::desktop
