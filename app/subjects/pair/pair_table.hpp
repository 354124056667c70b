// The table of the 28 pairs of volumes and their tests. A cell puts its pair on the stage.
#pragma once

#include "app/look.hpp"
#include "lesson/session.hpp"

namespace snug::app {

/// Draws the table, if students choose the kinds of volumes, and returns its height.
float draw_pair_table(const Look& look, lesson::Session& session, ImVec2 at, float width);

}  // namespace snug::app
