// How the handles of boxes are drawn, in every subject.
#pragma once

#include "app/brush.hpp"
#include "lesson/boxes.hpp"

namespace snug::app {

/// Draws a cross at a box's centre.
void draw_center(Brush& brush, const Point3& center, Color color);
/// Draws a knob on a stalk from a place of its volume, and an arc if it rotates the volume.
void draw_knob(Brush& brush, const Point3& from, const Point3& knob, bool turns);
/// Draws the knobs that rotate one of the pair's boxes.
void draw_knobs(Brush& brush, const lesson::BoxPair& pair, int box);

}  // namespace snug::app
