// The state of the browser's door.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/app.hpp"
#include "lesson/place.hpp"

namespace snug::web {

struct Door {
  std::map<std::string, std::string, std::less<>> fonts;
  std::unique_ptr<app::App> app;
  bool graphics = false;
  app::Layout layout;
  float width = 1, height = 1, scale = 1;
  double last_frame = 0;
  std::array<float, 3> ground{};
  lesson::NamedStages stages;
  std::optional<lesson::WayTo> way;                  // to the place that an address names
  std::optional<io::PointFile> lent;                 // the mesh that is needed on it
  std::shared_ptr<const lesson::Exercise> exercise;  // whose file was read last
  lesson::Draft draft;                               // the lesson file that was read last
  bool remembers_later = false;                      // whether `stages` learn what the session is still preparing
  std::optional<io::PointFile> carried;              // the points that are on their way to the playground
};

[[nodiscard]] inline Door& door() {
  static Door only;
  return only;
}

/// Null before the first lesson is open.
[[nodiscard]] inline lesson::Session* session() { return door().app ? door().app->session() : nullptr; }

}  // namespace snug::web
