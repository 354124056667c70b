// What is drawn alike of the boxes that a hand takes hold of.
#pragma once

#include "app/brush.hpp"
#include "lesson/boxes.hpp"

namespace snug::app {

/// A cross where a box's centre is.
void draw_center(Brush& brush, const Point3& center, Color color);
/// A knob, on a stalk from a place of its volume; an arc where it turns that.
void draw_knob(Brush& brush, const Point3& from, const Point3& knob, bool turns);
/// The knobs that turn one of the pair's boxes.
void draw_knobs(Brush& brush, const lesson::BoxPair& pair, int box);

}  // namespace snug::app
