// Where labels stand so that they cover neither each other nor, where it can be helped, a point or a line.
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
  float toward_x = 1, toward_y = -1;  // where it would rather stand, seen from the anchor
  bool optional = false;              // left out where nothing is free; others take the least bad place
  bool clear_of_points = false;       // goes farther out rather than over a point
};

/// What labels keep clear of.
struct Obstacles {
  struct Circle {
    float x, y, radius;
  };  // the line, not what is inside
  struct Segment {
    float ax, ay, bx, by;
  };
  struct Disc {
    float x, y, radius;
  };  // a point with what is drawn around it
  std::vector<Circle> circles;
  std::vector<Segment> segments;
  std::vector<Disc> discs;
  std::vector<Rect> taken;  // buttons and other labels
};

/// A place for each request, in their order; earlier ones choose first. No two of the places overlap.
[[nodiscard]] std::vector<std::optional<Rect>> place_labels(std::span<const LabelRequest> requests,
                                                            const Obstacles& obstacles, const Rect& bounds);

[[nodiscard]] bool overlap(const Rect& a, const Rect& b);
/// Whether the circle's line passes through the rectangle.
[[nodiscard]] bool crosses(const Rect& rect, const Obstacles::Circle& circle);
[[nodiscard]] bool crosses(const Rect& rect, const Obstacles::Segment& segment);

}  // namespace snug::app
