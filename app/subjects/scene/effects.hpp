// What a lesson on effects shows of each body: whether it sleeps, and whether the camera sees it. For this folder only.
#pragma once

#include "app/brush.hpp"
#include "lesson/subjects/scene/scene_frames.hpp"

namespace snug::app {

/// Marks the piles that sleep, crosses out those that the camera does not see, and draws the camera's frustum.
void draw_effects(Brush& brush, const lesson::SceneFrame& frame);

/// How much of the stage's height the graph of the effects takes; 0 if it would leave too little for the bodies, or if
/// the lesson is not about effects.
[[nodiscard]] float graph_room(const Look& look, const lesson::Session& session, const Rect& stage);
/// Draws the graph in the corner of the stage, below a height; empty if the stage has no room for it.
[[nodiscard]] Rect draw_graph_inset(Brush& brush, ImVec2 at);

}  // namespace snug::app
