// The graph of a scene's effects, in the order of the schedule: for this folder only.
#pragma once

#include "app/look.hpp"
#include "lesson/session.hpp"

namespace snug::app {

/// How wide and how high the graph of the session's scene is within a width; empty if its lesson is not about its
/// effects, or if no effect runs.
[[nodiscard]] ImVec2 graph_size(const Look& look, const lesson::Session& session, float width);

/// Draws it at a place: a node for each effect, filled and ticked if it runs in the current frame, dotted if it is
/// skipped, crossed if it is off; and for each thing that effects exchange a line from those that write it to those
/// that read it, strong if it changed in this frame.
void draw_graph(ImDrawList* list, const Look& look, const lesson::Session& session, ImVec2 at, float width);

}  // namespace snug::app
