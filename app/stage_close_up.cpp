// Draws the stage once more, magnified, in the close-up.
#include <algorithm>
#include <cmath>

#include "app/close_up.hpp"
#include "app/point_marks.hpp"
#include "app/stage.hpp"

namespace snug::app {
namespace {

bool inside(const Rect& rect, ImVec2 at) {
  return at.x > rect.x && at.y > rect.y && at.x < rect.x + rect.width && at.y < rect.y + rect.height;
}

/// A face of a mesh, on the screen.
struct Facet {
  std::array<ImVec2, 3> corners;
  float depth;
  Color color;
};

/// As matte as OpenGL's shader has it.
float shade_of(float towards_eye, float towards_light) {
  const float edge = 1 - std::clamp(towards_eye, 0.0f, 1.0f);
  return (0.58f + 0.48f * std::pow(0.5f + 0.5f * towards_light, 1.4f)) * (1 - 0.25f * edge * edge * edge);
}

/// The faces of a mesh that are in a picture, the farthest first.
std::vector<Facet> faces_in(const Rect& picture, const GlScene& scene, std::span<const ScreenPoint> places) {
  constexpr std::size_t kMost = 20000;  // a picture of more shows no single one
  std::vector<Facet> faces;
  for (const auto& [a, b, c] : scene.triangles) {
    const ScreenPoint &p = places[a], &q = places[b], &r = places[c];
    const auto [left, right] = std::minmax({p.x, q.x, r.x});
    const auto [high, low] = std::minmax({p.y, q.y, r.y});
    if (right < picture.x || left > picture.x + picture.width) continue;
    if (low < picture.y || high > picture.y + picture.height) continue;
    const Point3f normal = (scene.normals[a] + scene.normals[b] + scene.normals[c]).normalized();
    const bool front = (q.x - p.x) * (r.y - p.y) < (r.x - p.x) * (q.y - p.y);
    const Point3f seen = front ? normal : Point3f(-normal), to_eye = (scene.eye - scene.points[a]).normalized();
    faces.push_back({{ImVec2{p.x, p.y}, {q.x, q.y}, {r.x, r.y}},
                     p.depth + q.depth + r.depth,
                     shaded(scene.surface, shade_of(seen.dot(to_eye), seen.dot(scene.light)))});
  }
  std::sort(faces.begin(), faces.end(), [](const Facet& one, const Facet& other) { return one.depth > other.depth; });
  if (faces.size() > kMost) faces.erase(faces.begin(), faces.end() - kMost);
  return faces;
}

/// Draws them without smooth edges, which would leave seams between them.
void draw_surface(ImDrawList* list, const std::vector<Facet>& faces) {
  const ImDrawListFlags flags = list->Flags;
  list->Flags &= ~ImDrawListFlags_AntiAliasedFill;
  for (const auto& [corners, depth, color] : faces) list->AddTriangleFilled(corners[0], corners[1], corners[2], color);
  list->Flags = flags;
}

}  // namespace

void Stage::draw_close_up(const Brush& brush, float top) {
  close_up_ = close_up_of(brush, top, close_up_ ? close_up_->panel : Rect{});
  if (!close_up_) return;
  draw_close_up_panel(brush, *close_up_);
  const Rect picture = picture_of(*close_up_, brush.look);
  Camera camera = camera_;
  camera.magnify(close_up_->times, {close_up_->x, close_up_->y},
                 {picture.x + picture.width / 2, picture.y + picture.height / 2});
  std::vector<ScreenPoint> handles;
  for (Index i = 0; i < brush.session.stage().subject().size(); ++i) {
    handles.push_back(camera.project(brush.point(i)));
    if (!brush.handles[i].visible) handles.back().visible = false;
  }
  GlScene behind;  // OpenGL draws beneath the panel: what it does on the stage, the brush does here
  behind.three_d = scene_.three_d, behind.eye = scene_.eye, behind.light = scene_.light;
  Obstacles obstacles;
  Brush close{.list = brush.list,
              .look = brush.look,
              .p = brush.p,
              .session = brush.session,
              .view = brush.view,
              .rect = {picture.x, picture.y, picture.width, picture.height - kScaleHeight},
              .canvas = {brush.list, brush.look, camera, frame_, behind, obstacles},
              .hands = hands_,
              .handles = handles,
              .point_radius = brush.point_radius,
              .volume = brush.volume,
              .labels = {}};
  brush.list->PushClipRect({picture.x, picture.y}, {picture.x + picture.width, picture.y + picture.height}, true);
  draw_in_close_up(close);
  brush.list->PopClipRect();
  draw_close_up_scale(brush, *close_up_);
}

/// Everything but the ground. Of the labels only those of what is in the picture, where there is room.
void Stage::draw_in_close_up(Brush& close) const {
  if (!scene_.triangles.empty()) draw_surface(close.list, faces_in(close.rect, scene_, close.handles));
  draw_outline(close);
  view_->draw(close);
  const ImVec2 low = close.list->GetClipRectMin(), high = close.list->GetClipRectMax();
  const Rect seen{low.x - 9, low.y - 9, high.x - low.x + 18, high.y - low.y + 18};  // with the halves of points
  for (Index i = 0; i < close.session.stage().subject().size(); ++i) {
    const ScreenPoint& handle = close.handles[i];
    if (handle.visible && view_->shows_points(close.session) && view_->is_point(close.session, i) &&
        inside(seen, {handle.x, handle.y}))
      disc(close.list, {handle.x, handle.y}, close.point_radius, close.p.point);
  }
  draw_handles(close);
  std::erase_if(close.labels, [&](const Label& label) {
    return !inside(close.rect, {label.request.x, label.request.y});
  });
  for (Label& label : close.labels) label.request.optional = true;
  draw_labels(close);
}

}  // namespace snug::app
