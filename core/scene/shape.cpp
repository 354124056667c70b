#include "scene/shape.hpp"

#include <algorithm>

#include "query/distance/gjk.hpp"
#include "query/overlap/obb_sat.hpp"
#include "query/overlap/overlaps_spheres.hpp"

namespace snug::scene {
namespace {

Centered box(const V3& center, const Matrix<double, 3>& axes, const V3& half) {
  Centered result{{.kind = Shape::Kind::kBox, .half_extents = half}, center, axes};
  for (int bits = 0; bits < 8; ++bits)
    result.shape.corners.push_back(
        {bits & 1 ? half[0] : -half[0], bits & 2 ? half[1] : -half[1], bits & 4 ? half[2] : -half[2]});
  return result;
}

Centered core(std::vector<V3> corners, double radius) {
  Centered result{{.kind = Shape::Kind::kOther, .radius = radius}};
  Aabb<double, 3> bounds{corners.front(), corners.front()};
  for (const V3& p : corners) bounds = {bounds.min.cwiseMin(p), bounds.max.cwiseMax(p)};
  result.center = bounds.min / 2 + bounds.max / 2;
  for (V3& p : corners) p -= result.center;
  result.shape.corners = std::move(corners);
  result.shape.half_extents = (bounds.max - bounds.min) / 2 + V3::Constant(radius);
  return result;
}

struct Center {
  Centered operator()(const Sphere<double, 3>& ball) const {
    return {{.kind = Shape::Kind::kSphere, .radius = ball.radius, .corners = {V3::Zero()}}, ball.center};
  }
  Centered operator()(const Aabb<double, 3>& aabb) const {
    return box(aabb.min / 2 + aabb.max / 2, Matrix<double, 3>::Identity(), (aabb.max - aabb.min) / 2);
  }
  Centered operator()(const Obb<double, 3>& obb) const { return box(obb.center, obb.axes, obb.half_extents); }
  template <query::HasCorners Kind>
  Centered operator()(const Kind& volume) const {
    const V3 origin = V3::Zero();
    std::vector<V3> corners = core_corners(volume, origin);
    if (corners.empty()) corners = {anchor(volume)};
    return core(std::move(corners), query::radius_of(volume));
  }
  /// Smooth volumes were refused earlier (scene/declaration.cpp).
  template <class Kind>
  Centered operator()(const Kind& volume) const {
    return core({anchor(volume)}, 0);
  }
  Centered operator()(const Cloud& points) const { return core(points, 0); }
};

Obb<double, 3> obb_at(const Shape& shape, const Pose<double, 3>& pose) {
  return {pose.translation, pose.rotation, shape.half_extents};
}

bool sphere_touches(const Shape& ball, const V3& center, const Shape& other, const Pose<double, 3>& at) {
  if (other.kind == Shape::Kind::kSphere)
    return !query::apart_exactly<double, 3>(center, ball.radius, at.translation, other.radius);
  return query::test_sphere_box(Sphere<double, 3>{center, ball.radius}, obb_at(other, at)).overlap;
}

query::GrownCore core_at(const Shape& shape, const Pose<double, 3>& pose, const V3& origin) {
  query::GrownCore core{{}, shape.radius};
  core.corners.reserve(shape.corners.size());
  for (const V3& corner : shape.corners)
    core.corners.push_back(turned<double, 3>(pose.rotation, corner) + (pose.translation - origin));
  return core;
}

}  // namespace

Centered centered(const std::variant<Volume3, Cloud>& declared) {
  Centered result;
  if (const auto* cloud = std::get_if<Cloud>(&declared)) result = Center{}(*cloud);
  else result = std::visit(Center{}, *std::get_if<Volume3>(&declared));
  Shape& shape = result.shape;
  for (const V3& corner : shape.corners) shape.reach = std::max(shape.reach, corner.norm());
  shape.reach = (shape.reach + shape.radius) * (1 + tolerance::kLooseReach<double>);
  shape.thinnest = shape.kind == Shape::Kind::kSphere ? shape.radius : shape.half_extents.minCoeff();
  if (!std::holds_alternative<Cloud>(declared)) return result;
  if (auto set = PointSet<double, 3>::make(shape.corners))
    shape.cloud = std::make_shared<const AnyPointSet>(*std::move(set));
  return result;
}

bool touch(const Shape& a, const Pose<double, 3>& at_a, const Shape& b, const Pose<double, 3>& at_b) {
  using Kind = Shape::Kind;
  if (a.kind == Kind::kSphere && b.kind != Kind::kOther) return sphere_touches(a, at_a.translation, b, at_b);
  if (b.kind == Kind::kSphere && a.kind != Kind::kOther) return sphere_touches(b, at_b.translation, a, at_a);
  if (a.kind == Kind::kBox && b.kind == Kind::kBox) return query::obb_sat(obb_at(a, at_a), obb_at(b, at_b)).overlap;
  const V3 origin = at_a.translation / 2 + at_b.translation / 2;
  Ignore ignore;
  const auto separation =
      query::separation_of<double, 3>(core_at(a, at_a, origin), core_at(b, at_b, origin), origin, true, ignore);
  return separation && separation->overlap;
}

}  // namespace snug::scene
