#include "app/subjects/scene/contacts.hpp"

#include <algorithm>

#include "physics/manifold.hpp"
#include "query/distance/gjk.hpp"
#include "trace/observer.hpp"

namespace snug::app {
namespace {

using Point3 = Vector<double, 3>;

constexpr double kTouchMargin = 1e-3;  // of the smaller body's reach: bodies that touch may be a rounding apart

Pose<double, 3> pose_of(const Seen& body) { return {body.at.rotation(), body.at.position}; }

/// The point of a body nearest to a place outside it: of spheres and boxes; of other shapes the centre.
Point3 nearest_of(const Seen& body, const Point3& to) {
  const Point3 way = to - body.at.position;
  if (body.shape.kind == scene::Shape::Kind::kSphere)
    return body.at.position + way.normalized() * std::min(body.shape.radius, way.norm());
  if (body.shape.kind != scene::Shape::Kind::kBox) return body.at.position;
  const Matrix<double, 3> rotation = body.at.rotation();
  const Point3 local = rotation.transpose() * way;
  return body.at.position + rotation * local.cwiseMax(-body.shape.half_extents).cwiseMin(body.shape.half_extents);
}

std::optional<Point3> middle_of_manifold(const Seen& a, const Seen& b) {
  const double margin = kTouchMargin * std::min(a.shape.reach, b.shape.reach);
  const physics::Manifold manifold = physics::manifold_of(a.shape, pose_of(a), b.shape, pose_of(b), margin);
  if (manifold.count == 0) return std::nullopt;
  Point3 sum = Point3::Zero();
  for (const physics::ManifoldPoint& point : manifold.all()) sum += point.position;
  return sum / manifold.count;
}

/// The middle between the surfaces, along the line between the cores' nearest points.
std::optional<Point3> middle_of_cores(const Seen& a, const Seen& b) {
  const auto core = [&](const Seen& body) {
    query::GrownCore core;
    for (const Point3& corner : body.shape.corners)
      core.corners.push_back(body.at.position - a.at.position + body.at.rotation() * corner);
    return core;
  };
  Ignore ignore;
  const auto apart = query::separation_of<double, 3>(core(a), core(b), a.at.position, false, ignore);
  if (!apart || apart->overlap) return std::nullopt;
  const Point3 on_a = apart->on_a + apart->direction * a.shape.radius,
               on_b = apart->on_b - apart->direction * b.shape.radius;
  return Point3((on_a + on_b) / 2);
}

}  // namespace

std::array<Point3, 2> ends_between(const Seen& a, const Seen& b) {
  std::array<Point3, 2> ends{a.at.position, b.at.position};
  if (a.shape.reach > kMuchLarger * b.shape.reach) ends[0] = nearest_of(a, ends[1]);
  else if (b.shape.reach > kMuchLarger * a.shape.reach) ends[1] = nearest_of(b, ends[0]);
  return ends;
}

Point3 contact_between(const Seen& a, const Seen& b) {
  const bool faces = physics::has_manifolds(a.shape) && physics::has_manifolds(b.shape);
  if (const auto middle = faces ? middle_of_manifold(a, b) : middle_of_cores(a, b)) return *middle;
  const auto ends = ends_between(a, b);
  return (ends[0] + ends[1]) / 2;
}

}  // namespace snug::app
