// How the stage shows a lesson, as far as its file says so: the table [view] (lessons/README.md).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/vector.hpp"

namespace snug::lesson {

/// A place on the stage: fixed coordinates, a handle, which may be dragged, or where two volumes are nearest.
struct StagePlace {
  std::string handle;  // its name, or kGap; empty for the coordinates
  Vector<double, 3> at = Vector<double, 3>::Zero();
  std::size_t numbers = 0;  // how many coordinates the file gives
  static constexpr std::string_view kGap = "gap";
  [[nodiscard]] bool is_gap() const { return handle == kGap; }
};

/// A close-up in a corner of the stage.
struct Inset {
  StagePlace at;
  double size = 0;  // how wide the part of the scene is that it shows, scene units; 0: three times the gap
};

struct StageView {
  std::optional<std::array<double, 2>> camera;  // yaw and pitch, degrees; in 3-D
  double zoom = 1;                              // how many times larger than with everything in view
  std::optional<StagePlace> look_at;            // what is in the middle; none: the middle of everything
  std::vector<std::string> names;               // of the first points
  bool named = true;                            // whether handles are named that the step is not about
  bool outline = false;                         // whether lines join the points in their order
  std::optional<int> decimals;                  // of lengths, areas and volumes
  double point_size = 1;                        // times the usual size of a point
  std::optional<Inset> inset;
};

}  // namespace snug::lesson
