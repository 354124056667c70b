// What a step of a test of two boxes draws; for this folder.
#pragma once

#include "app/brush.hpp"
#include "app/subjects/pair/shown.hpp"

namespace snug::app {

void draw_pair(Brush& brush, const PairShown& shown);

/// Both projections on the axis: each centre with its projected radius to either side, solid towards the other box; and
/// the distance of the centres, so that one sees whether it is greater than both radii together.
void draw_projections(Brush& brush, const lesson::BoxPair& pair, const query::AxisTested<double, 3>& axis);

}  // namespace snug::app
