#include "app/subjects/scene/effects.hpp"

#include <array>
#include <cmath>

#include "app/marks.hpp"
#include "app/subjects/scene/graph.hpp"
#include "app/subjects/scene/pairs.hpp"
#include "geometry/frustum_corners.hpp"
#include "lesson/subjects/scene/scene.hpp"
#include "query/cull/classify.hpp"

namespace snug::app {
namespace {

constexpr float kGraphPad = 10, kLeastStage = 560, kHalfOfSleep = 3.5f, kMostWidth = 400;
// The stage's least height beside the graph, buttons and sentence included. If less is left, the panel has the graph.
constexpr float kLeastForBodies = 420;

/// The camera's frustum, dashed. Its vertices differ in one bit along each edge.
void draw_view_of_camera(Brush& brush, const Frustum<double, 3>& camera) {
  const auto corners = corners_of(camera);
  if (!corners) return;
  for (int c = 0; c < 8; ++c)
    for (int bit = 1; bit < 8; bit <<= 1)
      if ((c & bit) == 0)
        line(brush.list, brush.at((*corners)[c]), brush.at((*corners)[c | bit]), Stroke::kDashed, brush.p.examined,
             brush.stroke(0.5f));
}

/// Whether another body that sleeps lies on a body: one z stands for the whole pile.
bool bears_sleeper(const Brush& brush, const lesson::SceneFrame& frame, std::size_t i) {
  const Seen body = body_in(brush, frame, i);
  for (std::size_t j = 0; j < frame.bodies.size(); ++j) {
    if (j == i || frame.asleep[j] == 0) continue;
    const Seen other = body_in(brush, frame, j);
    const Point3 way = other.at.position - body.at.position;
    if (way[1] > std::hypot(way[0], way[2]) && way[1] < body.shape.reach + other.shape.reach) return true;
  }
  return false;
}

/// A z above a body, clear of the mark in its middle. It is drawn as a mark: words must not stand over others, and
/// bodies may.
void draw_asleep(Brush& brush, const Seen& body) {
  const ImVec2 at = brush.at(body.at.position + Point3(0, body.shape.reach, 0));
  const float half = kHalfOfSleep * brush.p.mark;
  const std::array<ImVec2, 4> z{ImVec2{at.x - half, at.y - half},
                                {at.x + half, at.y - half},
                                {at.x - half, at.y + half},
                                {at.x + half, at.y + half}};
  path(brush.list, z, false, Stroke::kSolid, brush.p.ground, 4);
  path(brush.list, z, false, Stroke::kSolid, brush.p.ink, 1.5f);
  brush.canvas.obstacles.discs.push_back({at.x, at.y, 2 * half});
}

}  // namespace

void draw_effects(Brush& brush, const lesson::SceneFrame& frame) {
  const lesson::SceneRecording& run = *lesson::recorded_scene(brush.session, 0);
  if (!lesson::set_of(brush.session).graph || frame.bodies.size() > kCrowd) return;
  if (run.camera) draw_view_of_camera(brush, *run.camera);
  for (std::size_t i = 0; i < frame.bodies.size(); ++i) {
    const Seen body = body_in(brush, frame, i);
    const bool culled =
        i < frame.visibility.size() && frame.visibility[i] == static_cast<std::uint8_t>(query::Culling::kOutside);
    if (culled) cross(brush.list, brush.at(body.at.position), 7 * brush.p.mark, brush.p.wrong, brush.stroke());
    if (frame.asleep[i] != 0 && !bears_sleeper(brush, frame, i)) draw_asleep(brush, body);
  }
}

float graph_room(const Look& look, const lesson::Session& session, const Rect& stage) {
  const float height = graph_size(look, session, kMostWidth).y;
  if (height == 0 || stage.width < kLeastStage) return 0;
  return room_over_picture(look, stage, height + 2 * kGraphPad + 8, kLeastForBodies);
}

Rect draw_graph_inset(Brush& brush, ImVec2 at) {
  const Look& look = brush.look;
  if (graph_room(look, brush.session, brush.rect) == 0) return {};
  const ImVec2 size = graph_size(look, brush.session, kMostWidth);
  const Rect panel{at.x, at.y, size.x + 2 * kGraphPad, size.y + 2 * kGraphPad};
  const ImVec2 low{panel.x, panel.y}, high{panel.x + panel.width, panel.y + panel.height};
  brush.list->AddRectFilled(low, high, with_alpha(brush.p.panel, 0.94f), 8);
  brush.list->AddRect(low, high, brush.p.line, 8, 0, 1);
  draw_graph(brush.list, look, brush.session, {panel.x + kGraphPad, panel.y + kGraphPad}, kMostWidth);
  return panel;
}

}  // namespace snug::app
