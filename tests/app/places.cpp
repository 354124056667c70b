#include "places.hpp"

namespace snug::app {

const std::string& assets_folder() {
  static const std::string folder = SNUG_ASSETS_DIR "/";
  return folder;
}

const std::string& lessons_folder() {
  static const std::string folder = SNUG_LESSONS_DIR "/";
  return folder;
}

}  // namespace snug::app
