#include "app/subjects/cloud/hand.hpp"

#include <cmath>

#include "app/box_marks.hpp"
#include "app/polytope.hpp"
#include "lesson/figures.hpp"
#include "lesson/subjects/cloud/by_hand.hpp"
#include "lesson/subjects/cloud/cloud.hpp"

namespace snug::app {
namespace {

using lesson::Handle;

/// Null if the stage is about no cloud, but about a chart of costs over it.
const lesson::CloudSubject* cloud_of(const lesson::Session& session) {
  return lesson::as<lesson::CloudSubject>(session.stage().subject());
}

bool shows_hand_of(const lesson::Session& session, std::string_view volume) {
  for (const int slot : {0, 1}) {
    const lesson::Method* method = session.player().method(slot);
    if (method != nullptr && method->by_hand && method->volume == volume) return true;
  }
  return false;
}

/// Where the handle's stalk begins: the middle of the points for a box, that of the core for a core.
Point3 held_middle(const lesson::HeldVolume& held) { return lesson::at_handle(held, {}); }

void draw_core(Brush& brush, const lesson::HeldVolume& held) {
  const VolumeStyle style{Stroke::kDashed, brush.p.current, brush.stroke(0.9f)};
  if (const auto* capsule = std::get_if<Capsule<double, 3>>(&held.volume))
    draw_line(brush.canvas, capsule->a, capsule->b, style);
  const auto* lozenge = std::get_if<Lozenge<double, 3>>(&held.volume);
  if (lozenge == nullptr) return;
  const auto& [u, v] = lozenge->edges;
  const std::array<Point3, 4> corners{lozenge->origin, lozenge->origin + u, lozenge->origin + u + v,
                                      lozenge->origin + v};
  for (std::size_t i = 0; i < 4; ++i) draw_line(brush.canvas, corners[i], corners[(i + 1) % 4], style);
}

void draw_handle(Brush& brush, const lesson::HeldVolume& held, const Handle& handle, const Point3& at) {
  switch (handle.kind) {
    case Handle::Kind::kCenter: return draw_center(brush, at, brush.p.current);
    case Handle::Kind::kTurn: return draw_knob(brush, held_middle(held), at, true);
    default: return draw_knob(brush, at, at, false);
  }
}

/// A direction of a k-DOP: a line through the points with a knob at its end, and its name.
void draw_axis(Brush& brush, const lesson::AxesByHand& axes, Index i) {
  const Point3 at = axes.at(i);
  draw_line(brush.canvas, axes.opposite(i), at, {Stroke::kDotted, brush.p.current, brush.stroke(0.6f)});
  draw_knob(brush, at, at, true);
  const ImVec2 middle = brush.at(axes.center()), end = brush.at(at);
  brush.label(end, 12, {end.x - middle.x, end.y - middle.y},
              std::to_string(i + 1) + ": " + lesson::direction_text(axes.axes()[i], brush.dim()), brush.p.current_text,
              Face::kRegular, 13);
}

/// An arrow from the mean with its name; the longest is as long as the points spread twice.
void draw_named_arrow(Brush& brush, const Point3& from, const Point3& way, const std::string& name, Color color,
                      Color words) {
  const ImVec2 tail = brush.at(from), tip = brush.at(from + way);
  arrow(brush.list, tail, tip, color, brush.stroke(1.2f));
  brush.canvas.obstacles.segments.push_back({tail.x, tail.y, tip.x, tip.y});
  brush.label(tip, 8, {tip.x - tail.x, tip.y - tail.y}, name, words);
}

}  // namespace

bool shows_handle(const lesson::Session& session, Index i) {
  const lesson::CloudSubject* cloud = cloud_of(session);
  const Index points = lesson::count_of(session.stage().subject());
  return i < points || cloud == nullptr || shows_hand_of(session, cloud->hand().volume_of(i - points));
}

void draw_hand(Brush& brush) {
  const lesson::CloudSubject* cloud = cloud_of(brush.session);
  if (cloud == nullptr) return;
  const lesson::Hand& hand = cloud->hand();
  const lesson::HeldVolume* last = nullptr;
  for (Index i = 0; i < hand.size(); ++i) {
    if (!shows_hand_of(brush.session, hand.volume_of(i))) continue;
    const lesson::HeldVolume* held = hand.held(hand.volume_of(i));
    if (held == nullptr) {
      draw_axis(brush, *hand.axes(), hand.axis_of(i));
      continue;
    }
    if (held != last) draw_core(brush, *held);
    last = held;
    draw_handle(brush, *held, hand.handle(i), hand.at(i));
  }
}

void draw_image(Brush& brush) {
  const lesson::Session& session = brush.session;
  if (session.player().method(0)->name != lesson::kEigenByHand) return;
  const auto& run = lesson::fit_run(session.player().run(0));
  const auto seen = lesson::image_after(run.recording(), session.player().step());
  if (!seen || !(seen->spread > 0)) return;
  const Palette& p = brush.p;
  const double length = 2 * std::sqrt(seen->spread);  // of v; its image is as long where the matrix stretches most
  draw_named_arrow(brush, seen->mean, seen->direction * length, "v", p.current, p.current_text);
  draw_named_arrow(brush, seen->mean, seen->image * (length / seen->spread),
                   "C v, " + lesson::number_text(seen->degrees, 2) + "° off", p.support, p.support_text);
}

fit::Sphere3 with_hand(const lesson::Session& session, const fit::Sphere3& ball) {
  fit::Sphere3 all = ball;
  for (Index i = lesson::count_of(session.stage().subject()); i < session.stage().subject().size(); ++i)
    if (shows_handle(session, i)) all = ball_around(all, fit::Sphere3{session.stage().subject().at(i), 0});
  return all;
}

}  // namespace snug::app
