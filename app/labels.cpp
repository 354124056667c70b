#include "app/labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace snug::app {
namespace {

constexpr int kDirections = 16;
constexpr std::array kRings{0.0f, 8.0f, 20.0f, 36.0f, 60.0f, 90.0f};  // farther out where it is crowded
constexpr int kOptionalRings = 2;
constexpr float kLineCost = 4;   // a line through a label makes it hard to read,
constexpr float kPointCost = 3;  // a point beneath it only hides that point
constexpr float kClearPointCost = 12;
constexpr std::array kRingCosts{0.0f, 1.0f, 2.5f,
                                5.0f, 9.0f, 14.0f};  // farther out than this, a label prefers to cover a line
constexpr float kTurnCost = 0.6f;                    // for each radian away from its preferred direction
constexpr float kMostOfOptional = 3;

float clamp_to(float value, float low, float high) { return std::max(low, std::min(value, high)); }

bool inside(const Rect& inner, const Rect& outer) {
  return inner.x >= outer.x && inner.y >= outer.y && inner.x + inner.width <= outer.x + outer.width &&
         inner.y + inner.height <= outer.y + outer.height;
}

bool touches(const Rect& rect, const Obstacles::Disc& disc) {
  const float dx = disc.x - clamp_to(disc.x, rect.x, rect.x + rect.width);
  const float dy = disc.y - clamp_to(disc.y, rect.y, rect.y + rect.height);
  return dx * dx + dy * dy < disc.radius * disc.radius;
}

bool taken(const Rect& rect, const std::vector<Rect>& others) {
  return std::any_of(others.begin(), others.end(), [&](const Rect& other) { return overlap(rect, other); });
}

float cost_of(const Rect& rect, const Obstacles& obstacles, float point_cost) {
  float cost = 0;
  for (const auto& circle : obstacles.circles) cost += crosses(rect, circle) ? kLineCost : 0;
  for (const auto& segment : obstacles.segments) cost += crosses(rect, segment) ? kLineCost : 0;
  for (const auto& disc : obstacles.discs) cost += touches(rect, disc) ? point_cost : 0;
  return cost;
}

Rect at(const LabelRequest& request, float angle, float gap) {
  const float dx = std::cos(angle), dy = std::sin(angle);
  return {request.x + dx * (gap + request.width / 2) - request.width / 2,
          request.y + dy * (gap + request.height / 2) - request.height / 2, request.width, request.height};
}

/// The obstacles that a label of this request could cover: a handful of points out of a thousand.
Obstacles near(const LabelRequest& request, const Obstacles& all) {
  Obstacles found{all.circles, all.segments, {}, {}};
  const float reach = request.gap + kRings.back() + std::hypot(request.width, request.height);
  for (const auto& disc : all.discs)
    if (std::abs(disc.x - request.x) < reach + disc.radius && std::abs(disc.y - request.y) < reach + disc.radius)
      found.discs.push_back(disc);
  return found;
}

std::optional<Rect> best_place(const LabelRequest& request, const Obstacles& all, const std::vector<Rect>& placed,
                               const Rect& bounds) {
  const Obstacles obstacles = near(request, all);
  const float toward = std::atan2(request.toward_y, request.toward_x);
  const float step = 2 * std::numbers::pi_v<float> / kDirections;
  std::optional<Rect> best;
  float least = request.optional ? kMostOfOptional : 1e9f;
  for (int ring = 0; ring < (request.optional ? kOptionalRings : static_cast<int>(kRings.size())); ++ring) {
    for (int k = 0; k < kDirections; ++k) {
      const float turn = static_cast<float>((k + 1) / 2) * (k % 2 == 0 ? -step : step);
      const float own = kRingCosts[ring] + kTurnCost * std::abs(turn);
      if (own >= least) continue;
      const Rect rect = at(request, toward + turn, request.gap + kRings[ring]);
      if (!inside(rect, bounds) || taken(rect, placed)) continue;
      const float cost = own + cost_of(rect, obstacles, request.clear_of_points ? kClearPointCost : kPointCost);
      if (cost < least) least = cost, best = rect;
    }
  }
  return best;
}

}  // namespace

bool overlap(const Rect& a, const Rect& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

bool crosses(const Rect& rect, const Obstacles::Circle& circle) {
  const float near_x = circle.x - clamp_to(circle.x, rect.x, rect.x + rect.width);
  const float near_y = circle.y - clamp_to(circle.y, rect.y, rect.y + rect.height);
  const float far_x = std::max(std::abs(circle.x - rect.x), std::abs(circle.x - rect.x - rect.width));
  const float far_y = std::max(std::abs(circle.y - rect.y), std::abs(circle.y - rect.y - rect.height));
  return std::hypot(near_x, near_y) <= circle.radius && circle.radius <= std::hypot(far_x, far_y);
}

// Clips the segment against the four sides; any remaining part is inside.
bool crosses(const Rect& rect, const Obstacles::Segment& segment) {
  const float dx = segment.bx - segment.ax, dy = segment.by - segment.ay;
  const std::array<std::array<float, 2>, 4> sides{{{-dx, segment.ax - rect.x},
                                                   {dx, rect.x + rect.width - segment.ax},
                                                   {-dy, segment.ay - rect.y},
                                                   {dy, rect.y + rect.height - segment.ay}}};
  float enter = 0, leave = 1;
  for (const auto& [slope, room] : sides) {
    if (slope == 0) {
      if (room < 0) return false;
      continue;
    }
    const float t = room / slope;
    if (slope < 0) enter = std::max(enter, t);
    else leave = std::min(leave, t);
  }
  return enter <= leave;
}

std::vector<std::optional<Rect>> place_labels(std::span<const LabelRequest> requests, const Obstacles& obstacles,
                                              const Rect& bounds) {
  std::vector<std::optional<Rect>> places;
  std::vector<Rect> placed = obstacles.taken;
  for (const LabelRequest& request : requests) {
    places.push_back(best_place(request, obstacles, placed, bounds));
    if (places.back()) placed.push_back(*places.back());
  }
  return places;
}

}  // namespace snug::app
