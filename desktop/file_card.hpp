// A path that the student is asked for.
#pragma once

#include <cstdint>
#include <string>

namespace snug::desktop {

struct FileCard {
  enum class What : std::uint8_t { kNone, kOpenPoints, kOpenLesson, kSavePoints, kSavePicture, kExportTable };
  What what = What::kNone;
  std::string path;
  bool replaces = false;  // whether the path is of a file that is there, and the next press replaces it
  std::string wrong;      // why the last press did nothing
  bool opened = false;    // just now: the field takes the keyboard
};

}  // namespace snug::desktop
