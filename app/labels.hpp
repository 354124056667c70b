// Places labels so that they cover neither each other nor, if possible, a point or a line.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/app.hpp"

namespace snug::app {

/// A label that wants a place beside its anchor. Page pixels, y down.
struct LabelRequest {
  float x = 0, y = 0;  // the anchor
  float gap = 8;       // clear space between anchor and label
  float width = 0, height = 0;
  float toward_x = 1, toward_y = -1;  // its preferred direction, seen from the anchor
  bool optional = false;              // left out if no place is free; others take the least bad place
  bool clear_of_points = false;       // moves farther out rather than cover a point
};

/// What labels keep clear of.
struct Obstacles {
  struct Circle {
    float x, y, radius;
  };  // only the line, not its inside
  struct Segment {
    float ax, ay, bx, by;
  };
  struct Disc {
    float x, y, radius;
  };  // a point with its mark
  std::vector<Circle> circles;
  std::vector<Segment> segments;
  std::vector<Disc> discs;
  std::vector<Rect> taken;  // buttons and other labels
};

/// A place for each request, in their order; earlier ones choose first. No two of the places overlap.
[[nodiscard]] std::vector<std::optional<Rect>> place_labels(std::span<const LabelRequest> requests,
                                                            const Obstacles& obstacles, const Rect& bounds);

[[nodiscard]] bool overlap(const Rect& a, const Rect& b);
/// Whether the circle's outline passes through the rectangle.
[[nodiscard]] bool crosses(const Rect& rect, const Obstacles::Circle& circle);
[[nodiscard]] bool crosses(const Rect& rect, const Obstacles::Segment& segment);

}  // namespace snug::app
