// Draws the pairs of a scene's frame.
#pragma once

#include <vector>

#include "app/brush.hpp"
#include "app/subjects/scene/contacts.hpp"

namespace snug::app {

// Drawing every edge, box and line takes eight times as many vertices. A scene with more bodies than this draws lines
// for touching pairs alone, and only the selected body's box.
inline constexpr std::size_t kCrowd = 400;

/// A body of the frame that is drawn.
[[nodiscard]] Seen body_in(const Brush& brush, const lesson::SceneFrame& frame, std::size_t i);
/// Draws the pairs that do not touch, by the last stage that let them pass: dotted boxes, dashed spheres.
void draw_pairs(Brush& brush, const lesson::SceneFrame& frame);
/// Lists the bodies that each body touches.
[[nodiscard]] std::vector<std::vector<std::size_t>> partners_in(const lesson::SceneFrame& frame);
/// Marks the place where two bodies touch.
void draw_contact(Brush& brush, const Seen& a, const Seen& b);
/// Draws a line for each pair that touches.
void draw_touching_in_crowd(Brush& brush, const lesson::SceneFrame& frame);

}  // namespace snug::app
