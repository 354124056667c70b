// A polytope with faces so small on the screen that their edges would cover it: shaded faces within an outline.
#pragma once

#include "app/volumes.hpp"

namespace snug::app {

/// Whether its edges would leave next to no room between them. screen: its vertices there. front: for each face whether
/// it faces the eye.
[[nodiscard]] bool is_crowded(const Polytope& polytope, const std::vector<ImVec2>& screen,
                              const std::vector<bool>& front);

/// Draws it without its edges: the faces that face the eye, each as light as it faces the light, and the outline.
void draw_crowded(const Canvas& canvas, const Polytope& polytope, const std::vector<ImVec2>& screen,
                  const std::vector<bool>& front, const VolumeStyle& style);

}  // namespace snug::app
