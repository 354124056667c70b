#include "app/subjects/scene/pairs.hpp"

#include <algorithm>

#include "lesson/subjects/scene/scene.hpp"

namespace snug::app {
namespace {

using lesson::SceneFrame;

constexpr float kLeastContact = 3, kMostContact = 6;  // half of a contact's diamond, pixels
constexpr double kOfBody = 0.3;  // a contact's diamond is no larger than this part of the smaller body

void draw_between(Brush& brush, const Seen& a, const Seen& b, Stroke stroke, Color color, float width) {
  const auto ends = ends_between(a, b);
  line(brush.list, brush.at(ends[0]), brush.at(ends[1]), stroke, color, brush.stroke(width));
}

}  // namespace

Seen body_in(const Brush& brush, const SceneFrame& frame, std::size_t i) {
  return {lesson::members_of(brush.session)[i].shape, frame.bodies[i]};
}

void draw_pairs(Brush& brush, const SceneFrame& frame) {
  if (frame.bodies.size() > kCrowd) return;
  const Palette& p = brush.p;
  for (const BodyPair& pair : frame.pairs) {
    if (std::binary_search(frame.touching.begin(), frame.touching.end(), pair)) continue;
    const bool near = std::binary_search(frame.near.begin(), frame.near.end(), pair);
    draw_between(brush, body_in(brush, frame, pair.a), body_in(brush, frame, pair.b),
                 near ? Stroke::kDashed : Stroke::kDotted, near ? p.examined_text : p.previous, 0.9f);
  }
}

std::vector<std::vector<std::size_t>> partners_in(const SceneFrame& frame) {
  std::vector<std::vector<std::size_t>> partners(frame.bodies.size());
  for (const BodyPair& pair : frame.touching) {
    partners[pair.a].push_back(pair.b);
    partners[pair.b].push_back(pair.a);
  }
  return partners;
}

void draw_contact(Brush& brush, const Seen& a, const Seen& b) {
  const Palette& p = brush.p;
  const Vector<double, 3> at = contact_between(a, b);
  const double body = std::min(a.shape.reach, b.shape.reach) * brush.canvas.camera.scale_at(at);
  const float size = std::clamp(static_cast<float>(kOfBody * body), kLeastContact, kMostContact) * p.mark;
  diamond(brush.list, brush.at(at), size, p.support_text, p.ground);
}

void draw_touching_in_crowd(Brush& brush, const SceneFrame& frame) {
  for (const BodyPair& pair : frame.touching)
    draw_between(brush, body_in(brush, frame, pair.a), body_in(brush, frame, pair.b), Stroke::kSolid,
                 brush.p.support_text, 0.7f);
}

}  // namespace snug::app
