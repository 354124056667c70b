// All volumes around the same points at once, in small pictures that turn together and have one scale.
#pragma once

#include <string>
#include <vector>

#include "app/look.hpp"
#include "geometry/point_set.hpp"
#include "geometry/volume.hpp"

namespace snug::app {

struct SmallPicture {
  const Volume<double, 3>* volume = nullptr;
  std::string id, name, figure;  // figure: beside the name
  bool chosen = false;
  bool best = false;  // nothing costs less
};

/// Where the pictures look from, radians.
struct Gaze {
  double yaw = 0.55, pitch = 0.32;
};

struct PictureHands {
  int clicked = -1;                  // the picture that was clicked, or pressed by a key
  float turned_x = 0, turned_y = 0;  // how far a drag went in this frame, pixels
};

/// Draws them into the rectangle. places: receives the middle of each.
PictureHands draw_small_pictures(ImDrawList* list, const Look& look, const Rect& room, const AnyPointSet& points,
                                 const std::vector<SmallPicture>& pictures, const Gaze& gaze,
                                 std::vector<ImVec2>& places);

/// The gaze after a drag.
[[nodiscard]] Gaze turned(const Gaze& gaze, float dx, float dy);

}  // namespace snug::app
