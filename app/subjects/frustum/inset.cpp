// The same from the frustum's camera: a small picture in a corner of the stage, with a margin around what the camera
// sees.
#include "app/subjects/frustum/draw.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace snug::app {
namespace {

constexpr double kAround = 0.45;  // of half the image, on every side

/// The camera's eye: a point's place sideways and upwards over its depth is its place in the image, from -1 to 1.
struct Eye {
  FrustumCamera<double, 3> camera;

  [[nodiscard]] Point3 seen(const Point3& p) const {
    const Point3 local = camera.axes.transpose() * (p - camera.position);
    return {local[0] / camera.half_tangents[0], local[1] / camera.half_tangents[1], -local[2]};
  }
  [[nodiscard]] bool in_front(const Point3& seen) const { return seen[2] >= camera.near; }
};

struct Piece {
  Point3 a, b;
};

/// What of a line is in front of the near plane.
std::optional<Piece> clipped(const Eye& eye, Point3 a, Point3 b) {
  if (!eye.in_front(a) && !eye.in_front(b)) return std::nullopt;
  const Point3 cut = a + (b - a) * ((eye.camera.near - a[2]) / (b[2] - a[2]));
  if (!eye.in_front(a)) a = cut;
  else if (!eye.in_front(b)) b = cut;
  return Piece{a, b};
}

/// The box's edges as the eye sees them.
std::vector<Piece> edges_seen(const Eye& eye, const lesson::BoxPair& pair) {
  std::vector<Piece> pieces;
  for (int from = 0; from < 1 << pair.dim; ++from)
    for (int axis = 0; axis < pair.dim; ++axis) {
      if ((from >> axis & 1) != 0) continue;
      const auto corner = [&](int bits) { return eye.seen(lesson::corner_of(pair.boxes[0], bits)); };
      if (const auto piece = clipped(eye, corner(from), corner(from | 1 << axis))) pieces.push_back(*piece);
    }
  return pieces;
}

/// The least and the greatest depth of the box's corners.
std::array<double, 2> depths(const Eye& eye, const lesson::BoxPair& pair) {
  double least = 1e300, greatest = -1e300;
  for (int bits = 0; bits < 1 << pair.dim; ++bits) {
    const double depth = eye.seen(lesson::corner_of(pair.boxes[0], bits))[2];
    least = std::min(least, depth), greatest = std::max(greatest, depth);
  }
  return {least, greatest};
}

/// Where the image stands on the screen.
struct Picture {
  ImVec2 middle, half;  // half: of what the camera sees
  int dim;

  [[nodiscard]] ImVec2 at(const Point3& seen) const {
    const double far = 100 * (1 + kAround);
    const auto place = [&](int axis) { return static_cast<float>(std::clamp(seen[axis] / seen[2], -far, far)); };
    return {middle.x + half.x * place(0), dim == 2 ? middle.y : middle.y - half.y * place(1)};
  }
  [[nodiscard]] Rect image() const { return {middle.x - half.x, middle.y - half.y, 2 * half.x, 2 * half.y}; }
};

/// Draws twice: pale all over the picture, and, where it is seen at all, as it is within the image.
template <class Draw>
void in_and_out(ImDrawList* list, const Rect& image, bool seen, const Draw& draw) {
  draw(0.4f);
  if (!seen) return;
  list->PushClipRect({image.x, image.y}, {image.x + image.width, image.y + image.height}, true);
  draw(1.0f);
  list->PopClipRect();
}

/// The image's side that a plane is seen as; all of them for near and far.
std::vector<ImVec2> side_in(const Rect& image, int dim, int plane) {
  const float right = image.x + image.width, bottom = image.y + image.height;
  if (plane >= 2 * dim - 2)
    return {{image.x, image.y}, {right, image.y}, {right, bottom}, {image.x, bottom}, {image.x, image.y}};
  if (plane < 2) return {{plane == 0 ? image.x : right, image.y}, {plane == 0 ? image.x : right, bottom}};
  return {{image.x, plane == 2 ? bottom : image.y}, {right, plane == 2 ? bottom : image.y}};
}

}  // namespace

/// Returns the room that it takes, empty where the stage has none for it.
Rect draw_from_camera(Brush& brush, const FrustumShown& shown, float top) {
  const lesson::BoxPair* pair = brush.session.boxes();
  const Palette& p = brush.p;
  const Look& look = brush.look;
  const Eye eye{lesson::camera_of(*pair)};
  const bool flat = pair->dim == 2, small = brush.rect.width < 560;
  const float head = look.px(20), pad = 8, outer = 1 + static_cast<float>(kAround);
  const float width = small ? 112.0f : look.px(brush.rect.width < 900 ? 168 : 224);
  const double aspect = eye.camera.half_tangents[1] / eye.camera.half_tangents[0];
  const float half_x = (width - 2 * pad) / (2 * outer);
  const float half_y = flat ? look.px(8) : half_x * static_cast<float>(std::clamp(aspect, 0.3, 1.25));
  const float height = head + 2 * (flat ? half_y + look.px(17) : half_y * outer) + pad;
  const Rect panel{brush.rect.x + 12, top, width, height};
  if (top + height > brush.canvas.camera.free_bottom()) return {};
  const ImVec2 low{panel.x, panel.y}, high{panel.x + width, panel.y + height};
  ImDrawList* list = brush.list;
  list->AddRectFilled(low, high, p.panel, 8);
  list->AddRect(low, high, p.line, 8, 0, 1);
  text(list, look, Face::kSemiBold, 12, {panel.x + pad, panel.y + look.px(5)}, p.muted,
       small ? "Camera" : "From the camera");
  const Picture picture{{panel.x + width / 2, panel.y + head + (height - head - pad) / 2}, {half_x, half_y}, pair->dim};
  const Rect image = picture.image();
  list->AddRectFilled({image.x, image.y}, {image.x + image.width, image.y + image.height}, p.ground);
  list->PushClipRect({low.x + 2, low.y + head}, {high.x - 2, high.y - 2}, true);
  const bool outside = shown.finished && shown.verdict == query::Culling::kOutside;
  const Color color = outside ? p.wrong : p.current;
  const std::vector<Piece> pieces = edges_seen(eye, *pair);
  const auto depth = depths(eye, *pair);
  std::vector<ImVec2> ends;
  for (const Piece& piece : pieces)
    for (const Point3& end : {piece.a, piece.b}) ends.push_back(picture.at(end));
  if (!ends.empty()) {
    std::vector<ImVec2> outline;
    if (flat) {
      const auto [least, most] =
          std::minmax_element(ends.begin(), ends.end(), [](ImVec2 a, ImVec2 b) { return a.x < b.x; });
      const float high_y = half_y * 0.7f;
      outline = {{least->x, picture.middle.y - high_y},
                 {most->x, picture.middle.y - high_y},
                 {most->x, picture.middle.y + high_y},
                 {least->x, picture.middle.y + high_y}};
    } else {
      outline = convex_outline(ends);
    }
    in_and_out(list, image, depth[0] <= eye.camera.far, [&](float share) {
      if (outline.size() > 2)
        list->AddConvexPolyFilled(outline.data(), static_cast<int>(outline.size()),
                                  with_alpha(color, (flat ? 2.5f : 1.2f) * p.fill * share));
      if (flat) path(list, outline, true, Stroke::kSolid, with_alpha(color, share), brush.stroke(0.8f));
      else
        for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
          line(list, ends[i], ends[i + 1], Stroke::kSolid, with_alpha(color, share), brush.stroke(0.7f));
    });
  }
  list->AddRect({image.x, image.y}, {image.x + image.width, image.y + image.height}, p.previous, 0, 0,
                brush.stroke(0.7f));
  if (shown.plane_at >= 0)
    path(list, side_in(image, pair->dim, shown.plane_at), false, Stroke::kSolid, p.examined, brush.stroke(1.4f));
  if (shown.plane && !shown.plane_asked) {
    // They may lie in one line of sight: the higher one is named above it, the other below.
    const Point3 p_seen = eye.seen(shown.plane->p_point), n_seen = eye.seen(shown.plane->n_point);
    const bool p_higher = flat || picture.at(p_seen).y <= picture.at(n_seen).y;
    const auto name = [&](const Point3& seen, bool higher, std::string_view word) {
      const ImVec2 at = picture.at(seen);
      const float aside = look.px(6);
      const bool inside = at.x > low.x + aside && at.x < high.x - aside && at.y > low.y + head && at.y < high.y - aside;
      if (!eye.in_front(seen) || !inside) return;
      diamond(list, at, 4, p.support, p.panel);
      const float above = (flat ? image.y : at.y - 3) - look.px(15), below = (flat ? image.y + image.height : at.y) + 4;
      text_middle(list, look, Face::kSemiBold, 12, {at.x, higher ? above : below}, p.support_text, word);
    };
    name(p_seen, p_higher, "p");
    name(n_seen, !p_higher, "n");
  }
  list->PopClipRect();
  if (ends.empty())
    text(list, look, Face::kRegular, 12, {panel.x + pad, high.y - look.px(18)}, p.muted,
         depth[1] > 0 ? "Before the near plane." : "Behind the camera.");
  return panel;
}

}  // namespace snug::app
