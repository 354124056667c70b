// The grid of the ground, as thin strips of triangles in the stage's clip space.
#pragma once

#include <vector>

#include "app/stage_gl.hpp"

namespace snug::app {

struct GroundVertex {
  float x, y;    // clip space
  float across;  // device pixels from the line's middle
  float share;   // opacity: lines fade with the distance
};

/// The grid's triangles, three vertices each. width, height: of the stage, and thick: of a line, in device pixels.
std::vector<GroundVertex> ground_lines(const GlScene& scene, int width, int height, float scale, float thick);

}  // namespace snug::app
