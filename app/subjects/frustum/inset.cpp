// The box and the frustum from the frustum's camera: a small picture in a corner of the stage, with a margin around
// what the camera sees.
#include "app/subjects/frustum/draw.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace snug::app {
namespace {

constexpr double kAround = 0.45;  // the margin on every side, as a fraction of half the image
constexpr float kPad = 8;         // between the panel's rim and its content, pixels

/// The camera: a point's offset sideways and upwards, divided by its depth, is its place in the image, from -1 to 1.
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

/// The part of a line in front of the near plane.
std::optional<Piece> clipped(const Eye& eye, Point3 a, Point3 b) {
  if (!eye.in_front(a) && !eye.in_front(b)) return std::nullopt;
  const Point3 cut = a + (b - a) * ((eye.camera.near - a[2]) / (b[2] - a[2]));
  if (!eye.in_front(a)) a = cut;
  else if (!eye.in_front(b)) b = cut;
  return Piece{a, b};
}

/// A circle around a ball, across the view; in 2-D its diameter. A point is drawn as a small one.
std::vector<Piece> ball_seen(const Eye& eye, const lesson::BoxPair& pair) {
  constexpr int kPieces = 24;
  const double least = 0.02 * pair.boxes[1].half_extents[0];
  const double radius = std::max(pair.boxes[0].half_extents[0], least);
  const auto at = [&](int k) {
    const double angle = 2 * std::numbers::pi * k / kPieces;
    return eye.seen(pair.boxes[0].center + eye.camera.axes.col(0) * (radius * std::cos(angle)) +
                    eye.camera.axes.col(1) * (radius * std::sin(angle)));
  };
  std::vector<Piece> pieces;
  for (int k = 0; k < kPieces; ++k)
    if (const auto piece = clipped(eye, at(k), at(k + 1))) pieces.push_back(*piece);
  return pieces;
}

/// The box's edges as the camera sees them.
std::vector<Piece> edges_seen(const Eye& eye, const lesson::BoxPair& pair) {
  if (pair.form != lesson::Form::kBox) return ball_seen(eye, pair);
  std::vector<Piece> pieces;
  for (int from = 0; from < 1 << pair.dim; ++from)
    for (int axis = 0; axis < pair.dim; ++axis) {
      if ((from >> axis & 1) != 0) continue;
      const auto corner = [&](int bits) { return eye.seen(lesson::corner_of(pair.boxes[0], bits)); };
      if (const auto piece = clipped(eye, corner(from), corner(from | 1 << axis))) pieces.push_back(*piece);
    }
  return pieces;
}

/// The least and the greatest depth of the box's vertices.
std::array<double, 2> depths(const Eye& eye, const lesson::BoxPair& pair) {
  double least = 1e300, greatest = -1e300;
  if (pair.form != lesson::Form::kBox) {
    const double depth = eye.seen(pair.boxes[0].center)[2], radius = pair.boxes[0].half_extents[0];
    return {depth - radius, depth + radius};
  }
  for (int bits = 0; bits < 1 << pair.dim; ++bits) {
    const double depth = eye.seen(lesson::corner_of(pair.boxes[0], bits))[2];
    least = std::min(least, depth), greatest = std::max(greatest, depth);
  }
  return {least, greatest};
}

/// Where the image is on the screen.
struct Picture {
  ImVec2 middle, half;  // half: half of the part that the camera sees
  int dim;

  [[nodiscard]] ImVec2 at(const Point3& seen) const {
    const double far = 100 * (1 + kAround);
    const auto place = [&](int axis) { return static_cast<float>(std::clamp(seen[axis] / seen[2], -far, far)); };
    return {middle.x + half.x * place(0), dim == 2 ? middle.y : middle.y - half.y * place(1)};
  }
  [[nodiscard]] Rect image() const { return {middle.x - half.x, middle.y - half.y, 2 * half.x, 2 * half.y}; }
};

/// Draws twice: pale over the whole picture and, if visible to the camera, in full colour within the image.
template <class Draw>
void in_and_out(ImDrawList* list, const Rect& image, bool seen, const Draw& draw) {
  draw(0.4f);
  if (!seen) return;
  list->PushClipRect({image.x, image.y}, {image.x + image.width, image.y + image.height}, true);
  draw(1.0f);
  list->PopClipRect();
}

/// The side of the image that a plane appears as; all sides for near and far.
std::vector<ImVec2> side_in(const Rect& image, int dim, int plane) {
  const float right = image.x + image.width, bottom = image.y + image.height;
  if (plane >= 2 * dim - 2)
    return {{image.x, image.y}, {right, image.y}, {right, bottom}, {image.x, bottom}, {image.x, image.y}};
  if (plane < 2) return {{plane == 0 ? image.x : right, image.y}, {plane == 0 ? image.x : right, bottom}};
  return {{image.x, plane == 2 ? bottom : image.y}, {right, plane == 2 ? bottom : image.y}};
}

/// Where the inset's parts are.
struct Inset {
  const lesson::BoxPair& pair;
  Eye eye;
  float head;  // the height of the title's row
  Rect panel;
  Picture picture;
  Rect image;

  [[nodiscard]] bool flat() const { return pair.dim == 2; }
  [[nodiscard]] ImVec2 low() const { return {panel.x, panel.y}; }
  [[nodiscard]] ImVec2 high() const { return {panel.x + panel.width, panel.y + panel.height}; }
};

bool is_small(const Brush& brush) { return brush.rect.width < 560; }

Inset inset_at(const Brush& brush, ImVec2 at) {
  const lesson::BoxPair& pair = lesson::boxes_of(brush.session.stage().subject());
  const Look& look = brush.look;
  const Eye eye{lesson::camera_of(pair)};
  const bool flat = pair.dim == 2;
  const float head = look.px(20), outer = 1 + static_cast<float>(kAround);
  const float width = is_small(brush) ? 112.0f : look.px(brush.rect.width < 900 ? 168 : 224);
  const double aspect = eye.camera.half_tangents[1] / eye.camera.half_tangents[0];
  const float half_x = (width - 2 * kPad) / (2 * outer);
  const float half_y = flat ? look.px(8) : half_x * static_cast<float>(std::clamp(aspect, 0.3, 1.25));
  const float height = head + 2 * (flat ? half_y + look.px(17) : half_y * outer) + kPad;
  const Rect panel{at.x, at.y, width, height};
  const Picture picture{{panel.x + width / 2, panel.y + head + (height - head - kPad) / 2}, {half_x, half_y}, pair.dim};
  return {pair, eye, head, panel, picture, picture.image()};
}

void draw_ground(Brush& brush, const Inset& inset) {
  const Palette& p = brush.p;
  const Rect& image = inset.image;
  brush.panel(inset.panel);
  text(brush.list, brush.look, Face::kSemiBold, 12, {inset.panel.x + kPad, inset.panel.y + brush.look.px(5)}, p.muted,
       is_small(brush) ? "Camera" : "From the camera");
  brush.list->AddRectFilled({image.x, image.y}, {image.x + image.width, image.y + image.height}, p.ground);
}

/// The part of the image that the box covers: in 2-D, where there is no height, a band.
std::vector<ImVec2> outline_of(const Inset& inset, const std::vector<ImVec2>& ends) {
  if (!inset.flat()) return convex_outline(ends);
  const auto [least, most] =
      std::minmax_element(ends.begin(), ends.end(), [](ImVec2 a, ImVec2 b) { return a.x < b.x; });
  const float middle = inset.picture.middle.y, half = inset.picture.half.y * 0.7f;
  return {{least->x, middle - half}, {most->x, middle - half}, {most->x, middle + half}, {least->x, middle + half}};
}

/// ends: those of its edges, in pairs.
void draw_box_seen(Brush& brush, const Inset& inset, const std::vector<ImVec2>& ends, bool seen, Color color) {
  if (ends.empty()) return;
  const bool flat = inset.flat();
  const std::vector<ImVec2> outline = outline_of(inset, ends);
  in_and_out(brush.list, inset.image, seen, [&](float share) {
    if (outline.size() > 2)
      brush.list->AddConvexPolyFilled(outline.data(), static_cast<int>(outline.size()),
                                      with_alpha(color, (flat ? 2.5f : 1.2f) * brush.p.fill * share));
    if (flat) path(brush.list, outline, true, Stroke::kSolid, with_alpha(color, share), brush.stroke(0.8f));
    else
      for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
        line(brush.list, ends[i], ends[i + 1], Stroke::kSolid, with_alpha(color, share), brush.stroke(0.7f));
  });
}

void name_vertex(Brush& brush, const Inset& inset, const Point3& seen, bool higher, std::string_view word) {
  const Look& look = brush.look;
  const Rect& image = inset.image;
  const ImVec2 at = inset.picture.at(seen), low = inset.low(), high = inset.high();
  const float aside = look.px(6);
  const bool inside =
      at.x > low.x + aside && at.x < high.x - aside && at.y > low.y + inset.head && at.y < high.y - aside;
  if (!inset.eye.in_front(seen) || !inside) return;
  diamond(brush.list, at, 4, brush.p.support, brush.p.panel);
  const float above = (inset.flat() ? image.y : at.y - 3) - look.px(15),
              below = (inset.flat() ? image.y + image.height : at.y) + 4;
  // Where the panel ends there, it stands beside its vertex.
  const float wanted = higher ? above : below, y = std::clamp(wanted, low.y + inset.head, high.y - look.px(15));
  const float shift = std::abs(y - wanted) < 1 ? 0.0f : look.px(at.x < (low.x + high.x) / 2 ? 11.0f : -11.0f);
  text_middle(brush.list, look, Face::kSemiBold, 12, {at.x + shift, y}, brush.p.support_text, word);
}

/// Names the p- and n-vertex. They may lie in one line of sight, so the higher one is named above, the other below.
void name_vertices(Brush& brush, const Inset& inset, const query::PlaneTested<double, 3>& plane) {
  const Point3 p_seen = inset.eye.seen(plane.p_point), n_seen = inset.eye.seen(plane.n_point);
  const bool p_higher = inset.flat() || inset.picture.at(p_seen).y <= inset.picture.at(n_seen).y;
  name_vertex(brush, inset, p_seen, p_higher, "p");
  name_vertex(brush, inset, n_seen, !p_higher, "n");
}

}  // namespace

/// Empty if the stage has no room for it.
Rect draw_from_camera(Brush& brush, const FrustumShown& shown, ImVec2 at) {
  const Inset inset = inset_at(brush, at);
  const Palette& p = brush.p;
  const Rect& image = inset.image;
  const ImVec2 low = inset.low(), high = inset.high();
  if (high.y > brush.canvas.camera.free_bottom()) return {};
  draw_ground(brush, inset);
  brush.list->PushClipRect({low.x + 2, low.y + inset.head}, {high.x - 2, high.y - 2}, true);
  const bool outside = shown.finished && shown.verdict == query::Culling::kOutside;
  const auto depth = depths(inset.eye, inset.pair);
  std::vector<ImVec2> ends;
  for (const Piece& piece : edges_seen(inset.eye, inset.pair))
    for (const Point3& end : {piece.a, piece.b}) ends.push_back(inset.picture.at(end));
  draw_box_seen(brush, inset, ends, depth[0] <= inset.eye.camera.far, outside ? p.wrong : p.current);
  brush.list->AddRect({image.x, image.y}, {image.x + image.width, image.y + image.height}, p.previous, 0, 0,
                      brush.stroke(0.7f));
  if (shown.plane_at >= 0)
    path(brush.list, side_in(image, inset.pair.dim, shown.plane_at), false, Stroke::kSolid, p.examined,
         brush.stroke(1.4f));
  if (shown.plane && !shown.plane_asked && inset.pair.form == lesson::Form::kBox)
    name_vertices(brush, inset, *shown.plane);
  brush.list->PopClipRect();
  if (ends.empty())
    text(brush.list, brush.look, Face::kRegular, 12, {low.x + kPad, high.y - brush.look.px(18)}, p.muted,
         depth[1] > 0 ? "In front of the near plane." : "Behind the camera.");
  return inset.panel;
}

}  // namespace snug::app
