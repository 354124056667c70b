// Draws what a box fitter works on: the convex hull, the edges that a box is built on, and in space the projection
// along one of the box's axes with the rectangle around it.
#include <Eigen/Geometry>
#include <algorithm>

#include "app/subjects/cloud/draw.hpp"
#include "lesson/point_subject.hpp"

namespace snug::app {
namespace {

/// In 2-D its outline; in 3-D its edges, or a ring around each vertex if there are too many to tell apart.
void draw_hull(Brush& brush, const CloudShown& shown) {
  constexpr std::size_t kMostVertices = 100;
  std::vector<ImVec2> corners;
  for (const Index i : shown.hull) corners.push_back(brush.at(brush.session.stage().subject().at(i)));
  if (brush.dim() == 2)
    return path(brush.list, convex_outline(std::move(corners)), true, Stroke::kSolid, brush.p.ink, brush.stroke(0.8f));
  if (shown.hull_solid && corners.size() <= kMostVertices)
    return draw_volume(brush.canvas, *shown.hull_solid, {Stroke::kSolid, brush.p.muted, brush.stroke(0.5f)});
  for (const ImVec2 at : corners) ring(brush.list, at, 4 * brush.p.mark, brush.p.ink, brush.stroke(0.6f));
}

/// The plane that the points are projected onto: the face of the box across that direction, just beyond the points.
struct Screen {
  Point3 along, place;
  [[nodiscard]] Point3 foot(const Point3& point) const { return point + along * along.dot(place - point); }
};

/// The screen lies beyond the box on the side that faces away from the eye, so that it hides nothing.
Screen screen_of(const Brush& brush, const CloudShown& shown, const Obb<double, 3>& box) {
  Point3 along = shown.along->normalized();
  if (along.dot(brush.canvas.camera.eye() - box.center) > 0) along = -along;
  double reach = 0, least = 0;
  for (Index i = 0; i < lesson::count_of(brush.session.stage().subject()); ++i) {
    const double at = along.dot(brush.session.stage().subject().at(i) - box.center);
    reach = std::max(reach, at), least = std::min(least, at);
  }
  return {along, box.center + along * (reach + 0.35 * box.half_extents.maxCoeff() + 0.1 * (reach - least))};
}

/// The corners of the rectangle that the box casts on the screen.
std::vector<ImVec2> rectangle_on(const Brush& brush, const Screen& screen, const Obb<double, 3>& box) {
  std::vector<ImVec2> corners;
  for (int bits = 0; bits < 8; ++bits) {
    Point3 corner = box.center;
    for (int axis = 0; axis < 3; ++axis)
      corner += box.axes.col(axis) * ((bits >> axis & 1) != 0 ? box.half_extents[axis] : -box.half_extents[axis]);
    corners.push_back(brush.at(screen.foot(corner)));
  }
  return convex_outline(std::move(corners));
}

void draw_projection(Brush& brush, const CloudShown& shown) {
  const fit::Volume3* volume = shown.candidate ? &*shown.candidate : brush.volume ? &*brush.volume : nullptr;
  const auto* box = volume != nullptr ? std::get_if<Obb<double, 3>>(volume) : nullptr;
  if (!shown.along || box == nullptr) return;
  const Palette& p = brush.p;
  const Screen screen = screen_of(brush, shown, *box);
  std::vector<ImVec2> feet;
  for (const Index i : shown.hull) {
    const Point3 point = brush.session.stage().subject().at(i);
    feet.push_back(brush.at(screen.foot(point)));
    line(brush.list, brush.at(point), feet.back(), Stroke::kDotted, with_alpha(p.muted, 0.6f), brush.stroke(0.5f));
    disc(brush.list, feet.back(), 2.5f * p.mark, p.muted);
  }
  if (shown.smallest)
    path(brush.list, rectangle_on(brush, screen, *shown.smallest), true, Stroke::kDotted, p.previous,
         brush.stroke(0.9f));
  const std::vector<ImVec2> rectangle = rectangle_on(brush, screen, *box);
  brush.list->AddConvexPolyFilled(rectangle.data(), static_cast<int>(rectangle.size()), with_alpha(p.examined, 0.08f));
  path(brush.list, rectangle, true, Stroke::kSolid, p.examined, brush.stroke(0.9f));
  path(brush.list, convex_outline(std::move(feet)), true, Stroke::kSolid, p.muted, brush.stroke(0.7f));
  for (const auto& [a, b] : shown.built_on)
    line(brush.list, brush.at(screen.foot(brush.session.stage().subject().at(a))),
         brush.at(screen.foot(brush.session.stage().subject().at(b))), Stroke::kSolid, p.examined, brush.stroke(1.6f));
  for (const Index i : shown.calipers)
    ring(brush.list, brush.at(screen.foot(brush.session.stage().subject().at(i))), 4 * p.mark, p.examined,
         brush.stroke(0.8f));
}

}  // namespace

void draw_box_fit(Brush& brush, const CloudShown& shown) {
  draw_hull(brush, shown);
  draw_projection(brush, shown);
  for (const auto& [a, b] : shown.built_on)
    line(brush.list, brush.at(brush.session.stage().subject().at(a)), brush.at(brush.session.stage().subject().at(b)),
         Stroke::kSolid, brush.p.examined, brush.stroke(1.4f));
}

}  // namespace snug::app
