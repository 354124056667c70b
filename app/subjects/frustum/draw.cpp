// Draws a box and a frustum: the current plane, its normal, the vertices that this selects, and their distances.
#include "app/subjects/frustum/draw.hpp"

#include <algorithm>
#include <cmath>

#include "app/box_marks.hpp"
#include "app/labels.hpp"
#include "lesson/figures.hpp"
#include "lesson/subjects/frustum/matrix_planes.hpp"

namespace snug::app {
namespace {

using query::Culling;
using Plane = query::PlaneTested<double, 3>;
using Corner = query::CornerTested<double, 3>;

constexpr double kNormal = 0.3;     // as a fraction of the frustum's half depth
constexpr float kLeastNormal = 28;  // pixels
constexpr float kVertex = 13;       // size of a p- or n-vertex's mark, pixels

struct Side {
  std::vector<Point3> corners;  // in order around the face; in 2-D the two ends of an edge
  Point3 middle;
};

}  // namespace

Polytope solid_of(const lesson::BoxPair& pair) {
  Polytope frustum = polytope_of(pair.boxes[1], pair.dim);
  for (std::size_t bits = 0; bits < frustum.corners.size(); ++bits)
    frustum.corners[bits] = lesson::corner_of(pair, 1, static_cast<int>(bits));
  return frustum;
}

namespace {

Side side_of(const lesson::BoxPair& pair, int plane) {
  const auto [axis, positive] = lesson::face_on_plane(pair.dim, plane);
  const Polytope frustum = solid_of(pair);
  Side face{{}, Point3::Zero()};
  if (pair.dim == 2) {
    for (int bits = 0; bits < 4; ++bits)
      if (((bits >> axis & 1) != 0) == positive) face.corners.push_back(frustum.corners[bits]);
  } else {
    for (const int bits : frustum.faces[2 * axis + (positive ? 0 : 1)]) face.corners.push_back(frustum.corners[bits]);
  }
  for (const Point3& corner : face.corners) face.middle += corner / static_cast<double>(face.corners.size());
  return face;
}

/// The unit normal of a side, pointing out of the frustum.
Point3 normal_of(const Side& face, const lesson::BoxPair& pair) {
  const Point3 along = face.corners[1] - face.corners[0];
  Point3 normal =
      pair.dim == 2 ? Point3(along[1], -along[0], 0) : Point3(along.cross(face.corners[2] - face.corners[0]));
  if (normal.dot(face.middle - pair.boxes[1].center) < 0) normal = -normal;
  return normal.normalized();
}

/// Where the normal is drawn on a face: away from the box.
Point3 clear_of(const Side& face, const Point3& box) {
  Point3 best = face.middle;
  for (const Point3& corner : face.corners) {
    const Point3 place = face.middle + (corner - face.middle) * 0.55;
    if ((place - box).norm() > (best - box).norm()) best = place;
  }
  return best;
}

/// "n (+, −)"
std::string normal_words(int dim, int signs) {
  std::string words = "n (";
  for (int axis = 0; axis < dim; ++axis)
    words += std::string(axis > 0 ? ", " : "") + ((signs >> axis & 1) != 0 ? "+" : "−");
  return words + ")";
}

ImVec2 displaced(ImVec2 at, ImVec2 by, float length) { return {at.x + by.x * length, at.y + by.y * length}; }

ImVec2 way_between(ImVec2 from, ImVec2 to) {
  const float length = std::hypot(to.x - from.x, to.y - from.y);
  return length > 0 ? ImVec2{(to.x - from.x) / length, (to.y - from.y) / length} : ImVec2{0, -1};
}

/// "+0.42", "−0.17"
std::string signed_words(double distance) { return (distance > 0 ? "+" : "") + lesson::number_text(distance); }

/// The box's lowest vertex on the screen, or a ball's lowest point.
ImVec2 lowest_corner(const Canvas& canvas, const lesson::BoxPair& pair) {
  const Obb<double, 3>& box = pair.boxes[0];
  if (pair.form != lesson::Form::kBox) return canvas.at(box.center - canvas.camera.up() * box.half_extents[0]);
  ImVec2 lowest = canvas.at(box.center);
  for (int bits = 0; bits < 1 << pair.dim; ++bits)
    if (const ImVec2 at = canvas.at(lesson::corner_of(pair.boxes[0], bits)); at.y > lowest.y) lowest = at;
  return lowest;
}

std::string verdict_words(const FrustumShown& shown, const lesson::Session& session) {
  const std::string body = session.stage().subject().name_of(0);
  if (!shown.verdict) return body;
  return body + ": " + std::string(query::kCullingNames[static_cast<std::size_t>(*shown.verdict)]) +
         (shown.finished ? "" : " so far");
}

/// Draws the camera, where the frustum's sides meet.
void draw_camera(Brush& brush, const lesson::BoxPair& pair) {
  const Palette& p = brush.p;
  const Point3 eye = lesson::camera_of(pair).position;
  for (int bits = 0; bits < 1 << pair.dim; bits += 2)
    draw_line(brush.canvas, eye, lesson::corner_of(pair, 1, bits), {Stroke::kDotted, p.previous, brush.stroke(0.6f)});
  const ImVec2 at = brush.at(eye);
  disc(brush.list, at, 6 * p.mark, p.ground);
  ring(brush.list, at, 6 * p.mark, p.previous, brush.stroke(0.8f));
  disc(brush.list, at, 2.5f * p.mark, p.previous);
  brush.canvas.obstacles.discs.push_back({at.x, at.y, 8});
  const ImVec2 away = way_between(brush.at(pair.boxes[1].center), at);
  brush.label(at, 10, away, "camera", p.previous_text, Face::kRegular, 13);
}

/// Draws the box's axes, which the signs refer to.
void draw_box_axes(Brush& brush, const lesson::BoxPair& pair) {
  const Palette& p = brush.p;
  const Obb<double, 3>& box = pair.boxes[0];
  const ImVec2 center = brush.at(box.center);
  for (int axis = 0; axis < pair.dim; ++axis) {
    const ImVec2 tip = brush.at(box.center + box.axes.col(axis) * (26 * static_cast<double>(p.mark) /
                                                                   brush.canvas.camera.scale_at(box.center)));
    arrow(brush.list, center, tip, p.muted, brush.stroke(0.7f));
    brush.canvas.obstacles.segments.push_back({center.x, center.y, tip.x, tip.y});
    brush.label(tip, 2, way_between(center, tip), std::string(1, "xyz"[axis]), p.ink, Face::kSemiBold, 12, true);
  }
}

/// In 2-D, draws the line that an edge lies on, with strokes in its positive half-space.
void draw_whole_line(Brush& brush, const std::vector<ImVec2>& edge, ImVec2 middle, ImVec2 tip) {
  const Color color = brush.p.examined;
  const ImVec2 along = way_between(edge[0], edge[1]), out = way_between(middle, tip);
  const float reach = brush.rect.width + brush.rect.height, step = 14;
  line(brush.list, displaced(middle, along, -reach), displaced(middle, along, reach), Stroke::kSolid,
       with_alpha(color, 0.5f), brush.stroke(0.5f));
  for (float t = -reach; t < reach; t += step) {
    const ImVec2 at = displaced(middle, along, t);
    line(brush.list, at, displaced(displaced(at, out, 7), along, 4), Stroke::kSolid, with_alpha(color, 0.45f), 1);
  }
  brush.canvas.obstacles.segments.push_back({edge[0].x, edge[0].y, edge[1].x, edge[1].y});
}

/// Draws the current plane: its side of the frustum, and its normal.
void draw_plane(Brush& brush, const lesson::BoxPair& pair, const FrustumShown& shown) {
  const Palette& p = brush.p;
  const Side face = side_of(pair, shown.plane_at);
  std::vector<ImVec2> outline;
  for (const Point3& corner : face.corners) outline.push_back(brush.at(corner));
  const auto [foot, normal] = normal_arrow(pair, shown);
  const ImVec2 middle = brush.at(foot), end = brush.at(foot + normal);
  // A normal that is nearly along the view is drawn longer, because students need its direction.
  const double longer =
      std::clamp(kLeastNormal / std::max(std::hypot(end.x - middle.x, end.y - middle.y), 1.0f), 1.0f, 4.0f);
  const ImVec2 tip = brush.at(foot + normal * longer);
  if (pair.dim == 2) draw_whole_line(brush, outline, middle, tip);
  else brush.list->AddConvexPolyFilled(outline.data(), static_cast<int>(outline.size()), with_alpha(p.examined, 0.16f));
  path(brush.list, outline, pair.dim == 3, Stroke::kSolid, p.examined, brush.stroke(1.6f));
  arrow(brush.list, middle, tip, p.ink, brush.stroke(1.1f));
  brush.canvas.obstacles.segments.push_back({middle.x, middle.y, tip.x, tip.y});
  const std::string name = lesson::plane_name(pair.dim, shown.plane_at);
  const bool signs = shown.plane && !shown.plane_asked && pair.form == lesson::Form::kBox;
  brush.label(tip, 6, way_between(middle, tip),
              signs ? name + ": " + normal_words(pair.dim, shown.plane->signs) : name + " plane", p.ink,
              Face::kSemiBold, 14);
  if (signs) draw_box_axes(brush, pair);
}

/// Draws the far plane that the matrix gives, beside the frustum's own.
void draw_matrix_far(Brush& brush, const lesson::BoxPair& pair, const FrustumShown& shown) {
  const std::string_view test = brush.session.player().method(0)->name;
  const bool tested = shown.plane && !shown.plane_asked && shown.plane->plane == lesson::planes_of_frustum(3) - 1;
  if (!lesson::is_of_matrix(test) || (!tested && !shown.finished)) return;
  const lesson::FarPlane far = lesson::far_plane_of(test, pair);
  std::vector<ImVec2> outline;
  for (const Point3& corner : far.corners) outline.push_back(brush.at(corner));
  if (outline.empty()) return;
  const Palette& p = brush.p;
  brush.list->AddConvexPolyFilled(outline.data(), static_cast<int>(outline.size()), with_alpha(p.wrong, 0.08f));
  path(brush.list, outline, true, Stroke::kDotted, p.wrong, brush.stroke(1.4f));
  const ImVec2 low = *std::max_element(outline.begin(), outline.end(), [](ImVec2 a, ImVec2 b) { return a.y < b.y; });
  brush.label(low, 12, {0, 1}, "far plane of the matrix", p.wrong_text, Face::kSemiBold, 13);
}

/// Draws the distance from each vertex to the plane.
void draw_distances(Brush& brush, const lesson::BoxPair& pair, const Plane& plane) {
  const Palette& p = brush.p;
  const Point3 normal = normal_of(side_of(pair, plane.plane), pair);
  if (pair.form != lesson::Form::kBox) return draw_center_distance(brush, plane, normal, pair);
  for (const bool along : {true, false}) {
    const Point3 vertex = along ? plane.p_point : plane.n_point;
    const double distance = along ? plane.p_distance : plane.n_distance;
    const ImVec2 from = brush.at(vertex), foot = brush.at(vertex - normal * distance);
    const ImVec2 way = way_between(from, foot), aside{-way.y, way.x};
    const Color color = distance > 0 ? p.examined : p.current;
    line(brush.list, from, foot, Stroke::kDashed, color, brush.stroke(0.9f));
    line(brush.list, displaced(foot, aside, -6), displaced(foot, aside, 6), Stroke::kSolid, color, brush.stroke());
    brush.canvas.obstacles.segments.push_back({from.x, from.y, foot.x, foot.y});
    brush.label({(from.x + foot.x) / 2, (from.y + foot.y) / 2}, 5, aside.x >= 0 ? aside : ImVec2{-aside.x, -aside.y},
                signed_words(distance), distance > 0 ? p.examined_text : p.current_text, Face::kMonoBold, 12);
  }
}

/// For tests by vertices: a ring at a vertex that is outside, a tick at one that is not; the last one names the plane.
void draw_corners(Brush& brush, const FrustumShown& shown) {
  const Palette& p = brush.p;
  for (const Corner& corner : shown.corners) {
    const ImVec2 at = brush.at(corner.point);
    const bool last = &corner == &shown.corners.back() && !shown.finished;
    if (corner.outside) ring(brush.list, at, (last ? 13 : 10) * p.mark, p.examined, brush.stroke(last ? 1.2f : 0.8f));
    else
      tick(brush.list, displaced(at, {0.7f, -0.7f}, 14 * p.mark), 5 * p.mark, p.optimum,
           brush.stroke(last ? 1.2f : 0.8f));
    brush.canvas.obstacles.discs.push_back({at.x, at.y, 14 * p.mark});
    if (!last) continue;
    const std::string of = corner.plane < 0 ? "every plane" : lesson::plane_name(brush.dim(), corner.plane);
    const std::string by = corner.plane < 0 ? "" : " " + signed_words(corner.distance);
    brush.label(at, 20 * p.mark, {0.5f, -1}, (corner.outside ? "outside " : "inside ") + of + by,
                corner.outside ? p.examined_text : p.optimum_text);
  }
}

}  // namespace

NormalArrow normal_arrow(const lesson::BoxPair& pair, const FrustumShown& shown) {
  const Side face = side_of(pair, shown.plane_at);
  return {clear_of(face, pair.boxes[0].center), normal_of(face, pair) * (kNormal * pair.boxes[1].half_extents[0])};
}

void draw_frustum(Brush& brush, const FrustumShown& shown) {
  const lesson::BoxPair& pair = lesson::boxes_of(brush.session.stage().subject());
  const Palette& p = brush.p;
  draw_camera(brush, pair);
  draw_volume(brush.canvas, solid_of(pair), {Stroke::kSolid, p.previous, brush.stroke(0.9f), 0.6f * p.fill});
  const bool outside = shown.finished && shown.verdict == Culling::kOutside;
  draw_body(brush, pair, outside ? p.wrong : p.current);
  draw_center(brush, pair.boxes[1].center, p.previous);
  draw_knobs(brush, pair, 1);
  const Color verdict = outside                                                     ? p.wrong_text
                        : shown.finished && shown.verdict == Culling::kIntersecting ? p.examined_text
                                                                                    : p.current_text;
  brush.label(lowest_corner(brush.canvas, pair), 16, {0, 1}, verdict_words(shown, brush.session), verdict,
              Face::kSemiBold, 15);
  draw_matrix_far(brush, pair, shown);
  if (shown.plane_at >= 0) draw_plane(brush, pair, shown);
  if (shown.plane && !shown.plane_asked) draw_distances(brush, pair, *shown.plane);
  draw_corners(brush, shown);
  const ImVec2 end = brush.at(lesson::corner_of(pair, 1, 0b011));  // at the far end, and away from the camera's axis
  brush.label(end, 10, way_between(brush.at(pair.boxes[1].center), end), "Frustum", p.previous_text, Face::kSemiBold,
              15);
}

void mark_frustum(Brush& brush, const FrustumShown& shown) {
  const Palette& p = brush.p;
  // A box that is far away is small: its letters would stand over each other.
  const auto distance = [](ImVec2 a, ImVec2 b) { return std::hypot(a.x - b.x, a.y - b.y); };
  const bool lettered =
      shown.vertices.size() < 2 || distance(brush.at(brush.point(shown.vertices.front())),
                                            brush.at(brush.point(shown.vertices.back()))) >= 2 * kVertex * p.mark;
  for (const Index& i : shown.vertices) {
    const ImVec2 place = brush.at(brush.point(i));
    diamond(brush.list, place, kVertex * p.mark, p.support, p.ground);
    const float size = kVertex * p.mark / brush.look.text_scale;  // a mark does not grow with the text
    if (lettered && overlap(brush.rect, {place.x, place.y, 0, 0})) {
      text_middle(brush.list, brush.look, Face::kSemiBold, size, {place.x, place.y - 0.6f * kVertex * p.mark}, p.ground,
                  &i == shown.vertices.data() ? "p" : "n");
      const float half = 0.6f * kVertex * p.mark;  // no label over the letter
      brush.canvas.obstacles.taken.push_back({place.x - half, place.y - half, 2 * half, 2 * half});
    }
    brush.canvas.obstacles.discs.push_back({place.x, place.y, kVertex * p.mark});
  }
}

void name_frustum(PointNames& names, const FrustumShown& shown) {
  Brush& brush = names.brush;
  const ImVec2 box = brush.at(lesson::boxes_of(brush.session.stage().subject()).boxes[0].center);
  for (const Index i : shown.vertices) {
    names.skip(i);
    const ImVec2 at = brush.at(brush.point(i));
    brush.label(at, 15 * brush.p.mark, {at.x - box.x, at.y - box.y}, brush.session.stage().subject().name_of(i),
                brush.p.support_text, Face::kSemiBold, 15);
  }
}

}  // namespace snug::app
