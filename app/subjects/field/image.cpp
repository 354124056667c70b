// What the camera sees: the boxes that are drawn, in a small picture in a corner of the stage.
#include <algorithm>

#include "app/marks.hpp"
#include "app/subjects/field/draw.hpp"

namespace snug::app {
namespace {

using query::Culling;

constexpr float kImagePad = 8;
constexpr std::size_t kMostSeen = 1500;  // boxes that are drawn, the nearest ones

struct CameraImage {
  FrustumCamera<double, 3> camera;
  Rect image;

  /// Sideways, upwards, and how far away.
  [[nodiscard]] Point3 seen(const Point3& p) const {
    const Point3 local = camera.axes.transpose() * (p - camera.position);
    return {local[0], local[1], -local[2]};
  }
  [[nodiscard]] ImVec2 at(const Point3& seen) const {
    const double x = seen[0] / (seen[2] * camera.half_tangents[0]), y = seen[1] / (seen[2] * camera.half_tangents[1]);
    return {image.x + image.width * static_cast<float>(0.5 + x / 2),
            image.y + image.height * static_cast<float>(0.5 - y / 2)};
  }
};

/// Fills the sides of a box that face the camera. A side that reaches behind the near plane is left out.
void draw_seen(Brush& brush, const CameraImage& picture, const hierarchy::Field::Box& box, Color color) {
  constexpr std::array<double, 3> kShade{0.82, 1, 0.66};  // of the sides across x, y and z
  for (int axis = 0; axis < 3; ++axis) {
    const double eye = picture.camera.position[axis];
    if (eye >= box.min[axis] && eye <= box.max[axis]) continue;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::array<ImVec2, 4> outline;
    bool whole = true;
    for (std::size_t k = 0; k < 4; ++k) {
      Point3 corner;
      corner[axis] = eye > box.max[axis] ? box.max[axis] : box.min[axis];
      corner[u] = k == 1 || k == 2 ? box.max[u] : box.min[u];
      corner[v] = k >= 2 ? box.max[v] : box.min[v];
      const Point3 seen = picture.seen(corner);
      whole = whole && seen[2] >= picture.camera.near;
      if (whole) outline[k] = picture.at(seen);
    }
    if (whole) brush.list->AddConvexPolyFilled(outline.data(), 4, shaded(color, kShade[axis]));
  }
}

/// The boxes that are drawn, the farthest first.
std::vector<std::size_t> boxes_seen(const CameraImage& picture, const lesson::FieldRun& run) {
  std::vector<std::pair<double, std::size_t>> order;
  const auto& boxes = run.field().boxes;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (run.verdicts()[i] != Culling::kOutside)
      order.emplace_back(-picture.seen((boxes[i].min + boxes[i].max) / 2)[2], i);
  std::sort(order.begin(), order.end());
  if (order.size() > kMostSeen) order.erase(order.begin(), order.end() - kMostSeen);
  std::vector<std::size_t> seen;
  for (const auto& [depth, i] : order) seen.push_back(i);
  return seen;
}

}  // namespace

Rect draw_camera_image(Brush& brush, ImVec2 at) {
  const auto& stage = lesson::as<lesson::FieldSubject>(brush.session.stage().subject())->stage();
  const Look& look = brush.look;
  const Palette& p = brush.p;
  const bool small = brush.rect.width < 560;
  const float width = small ? 124.0f : look.px(brush.rect.width < 900 ? 190 : 248), head = look.px(22);
  const auto aspect = static_cast<float>(std::clamp(stage.recipe.tangents[1] / stage.recipe.tangents[0], 0.3, 1.25));
  const Rect image{at.x + kImagePad, at.y + head, width - 2 * kImagePad, (width - 2 * kImagePad) * aspect};
  const Rect panel{at.x, at.y, width, head + image.height + kImagePad};
  if (panel.y + panel.height > brush.canvas.camera.free_bottom()) return {};
  const ImVec2 low{image.x, image.y}, high{image.x + image.width, image.y + image.height};
  brush.panel(panel);
  text(brush.list, look, Face::kSemiBold, 12, {panel.x + kImagePad, panel.y + look.px(6)}, p.muted,
       small ? "Camera" : "From the camera");
  brush.list->AddRectFilled(low, high, p.ground);
  brush.list->PushClipRect(low, high, true);
  const ImDrawListFlags flags = brush.list->Flags;
  brush.list->Flags &= ~ImDrawListFlags_AntiAliasedFill;  // fringes are three quarters of the triangles
  const CameraImage picture{lesson::camera_of(stage.recipe, stage.now), image};
  const lesson::FieldRun& run = lesson::field_run(brush.session.player().run(0));
  for (const std::size_t i : boxes_seen(picture, run))
    draw_seen(brush, picture, run.field().boxes[i], run.verdicts()[i] == Culling::kInside ? p.current : p.examined);
  brush.list->Flags = flags;
  brush.list->PopClipRect();
  brush.list->AddRect(low, high, p.previous, 0, 0, 1);
  return panel;
}

}  // namespace snug::app
