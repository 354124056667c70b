// Draws what the update of a body's volume works with: the body's local frame, and what the method keeps in it.
#include <algorithm>
#include <array>

#include "app/point_marks.hpp"
#include "app/subjects/scene/draw.hpp"
#include "app/subjects/scene/owner.hpp"
#include "fit/catalogue.hpp"
#include "lesson/subjects/scene/scene.hpp"

namespace snug::app {
namespace {

using lesson::SceneFrame;

constexpr std::size_t kMostOfHull = 400;  // of more points the hull's edges are a blur

/// The body of points as it stands in a frame.
struct Posed {
  const SceneFrame::Placed& at;
  Matrix<double, 3> rotation;
  const std::vector<Point3>& points;  // in its local frame
  [[nodiscard]] Point3 world(const Point3& local) const { return at.position + rotation * local; }
};

/// Arrows along its axes, and a cross at the pivot, which they start from.
void draw_local_frame(Brush& brush, const Posed& body) {
  const Palette& p = brush.p;
  double reach = 0;
  for (const Point3& point : body.points) reach = std::max(reach, point.norm());
  const ImVec2 pivot = brush.at(body.at.position);
  for (int axis = 0; axis < 3; ++axis) {
    const ImVec2 tip = brush.at(body.world(Point3::Unit(axis) * (0.45 * reach)));
    arrow(brush.list, pivot, tip, p.muted, brush.stroke(0.8f));
    brush.label(tip, 4, {tip.x - pivot.x, tip.y - pivot.y}, std::string("local ") + "xyz"[axis], p.muted,
                Face::kRegular, 12, true);
  }
  plus(brush.list, pivot, 5 * p.mark, p.ink, brush.stroke(0.8f));
}

/// The AABB of the points in the local frame, where it stands now: its vertices are all that the method looks at.
void draw_rotated_box(Brush& brush, const Posed& body) {
  Point3 least = body.points.front(), greatest = least;
  for (const Point3& point : body.points) least = least.cwiseMin(point), greatest = greatest.cwiseMax(point);
  const Point3 half = (greatest - least) / 2;
  const Obb<double, 3> box{body.world(least + half), body.rotation, half};
  draw_volume(brush.canvas, fit::Volume3(box), {Stroke::kDashed, brush.p.previous, brush.stroke(0.8f)});
  const ImVec2 at = brush.at(body.world(greatest));
  brush.label(at, 6, {0.5f, -1}, "rotated local AABB", brush.p.previous_text, Face::kRegular, 13, true);
}

/// The sphere about the pivot that the body never leaves: the loose box stands around it.
void draw_pivot_sphere(Brush& brush, const Posed& body) {
  double reach = 0;
  for (const Point3& point : body.points) reach = std::max(reach, point.norm());
  draw_volume(brush.canvas, fit::Sphere3{body.at.position, reach},
              {Stroke::kDashed, brush.p.previous, brush.stroke(0.8f)});
  const ImVec2 top = brush.at(body.at.position + brush.canvas.camera.up() * reach);
  brush.label(top, 6, {0.3f, -1}, "sphere about the pivot", brush.p.previous_text, Face::kRegular, 13, true);
}

/// The hull that the climbs go over, and the vertices that they end at.
void draw_hull(Brush& brush, const Posed& body) {
  if (body.points.size() > kMostOfHull) return;
  const auto found = fit::find_algorithm("hull", "quickhull")->fit(*brush.session.stage().subject().points(), {});
  Polytope hull = polytope_of(*std::get_if<ConvexHull<double, 3>>(&found.volume), 3);
  for (Point3& corner : hull.corners) corner = body.world(corner);
  draw_volume(brush.canvas, hull, {Stroke::kSolid, brush.p.muted, brush.stroke(0.5f)});
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax_element(hull.corners.begin(), hull.corners.end(),
                                                 [&](const Point3& a, const Point3& b) { return a[axis] < b[axis]; });
    for (const auto& end : {low, high})
      ring(brush.list, brush.at(*end), kRing * brush.p.mark, brush.p.examined, brush.stroke(0.9f));
  }
}

}  // namespace

void draw_update(Brush& brush, const SceneFrame& frame) {
  const Owner owner = owner_of(lesson::set_of(brush.session));
  if (!owner.of_points || brush.session.player().method(0) == nullptr) return;
  const SceneFrame::Placed& at = frame.bodies[owner.body];
  const Posed body{at, at.rotation(), lesson::members_of(brush.session)[owner.body].shape.corners};
  if (body.points.empty()) return;
  const std::string_view method = brush.session.player().method(0)->name;
  draw_local_frame(brush, body);
  if (method == "rotated_box") draw_rotated_box(brush, body);
  if (method == "loose") draw_pivot_sphere(brush, body);
  if (method == "hill_climb") draw_hull(brush, body);
}

}  // namespace snug::app
