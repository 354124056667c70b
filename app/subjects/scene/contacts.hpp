// Where two bodies of a frame touch, and between which of their points the line of a pair is drawn.
#pragma once

#include <array>

#include "lesson/subjects/scene/scene_frames.hpp"
#include "scene/world.hpp"

namespace snug::app {

/// A body whose reach is so many times another's is a floor or a wall to it.
inline constexpr double kMuchLarger = 2.5;

/// A body in a frame.
struct Seen {
  const scene::Shape& shape;
  const lesson::SceneFrame::Placed& at;
};

/// The ends of a pair's line: the centres; but of a body much larger than the other, such as a floor, its nearest
/// point.
[[nodiscard]] std::array<Vector<double, 3>, 2> ends_between(const Seen& a, const Seen& b);

/// The middle of the place where two bodies touch. Of shapes that overlap too deeply to have such a place, the middle
/// of ends_between.
[[nodiscard]] Vector<double, 3> contact_between(const Seen& a, const Seen& b);

}  // namespace snug::app
