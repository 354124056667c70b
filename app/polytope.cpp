#include "app/polytope.hpp"

#include <algorithm>
#include <array>

#include "fit/hull/quickhull.hpp"
#include "fit/lift.hpp"
#include "query/kdop_vertices.hpp"

namespace snug::app {
namespace {

using V3 = Vector<double, 3>;

/// A box's corners by their bits (1: +x, 2: +y, 4: +z) and its faces.
Polytope box(const V3& center, const Matrix<double, 3>& half_axes, int dim) {
  Polytope polytope;
  const int corners = dim == 2 ? 4 : 8;
  for (int bits = 0; bits < corners; ++bits) {
    V3 corner = center;
    for (int axis = 0; axis < dim; ++axis) corner += half_axes.col(axis) * ((bits >> axis & 1) != 0 ? 1 : -1);
    polytope.corners.push_back(corner);
  }
  if (dim == 2) polytope.faces = {{0, 1, 3, 2}};
  else polytope.faces = {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};
  return polytope;
}

/// The edges of the plane in the order in which they join.
std::vector<int> joined(const std::vector<std::array<Index, 3>>& edges, std::size_t corners) {
  std::vector<int> next(corners, -1), around;
  for (const auto& edge : edges) next[edge[0]] = edge[1];
  if (edges.empty()) return around;
  for (int at = edges.front()[0]; around.size() < edges.size(); at = next[at]) around.push_back(at);
  return around;
}

/// The hull of a few points; they were accepted before.
template <int Dim>
Polytope hull_of(std::vector<Vector<double, Dim>> corners) {
  const auto set = PointSet<double, Dim>::make(std::move(corners));
  return set ? polytope_of(fit::lift(fit::quickhull(set->span()).volume), Dim) : Polytope{};
}

/// Sums over a volume's cores: the farthest of its corners, and a radius on top.
struct Farthest {
  const V3& direction;
  int dim;

  V3 operator()(const Sphere<double, 3>& ball) const { return pushed(ball.center, ball.radius); }
  V3 operator()(const Capsule<double, 3>& capsule) const {
    return pushed(of_corners({capsule.a, capsule.b}), capsule.radius);
  }
  V3 operator()(const Lozenge<double, 3>& lozenge) const {
    const V3 opposite = lozenge.origin + lozenge.edges[0] + lozenge.edges[1];
    return pushed(
        of_corners({lozenge.origin, lozenge.origin + lozenge.edges[0], lozenge.origin + lozenge.edges[1], opposite}),
        lozenge.radius);
  }
  V3 operator()(const auto& flat_faced) const { return of_corners(polytope_of(flat_faced, dim).corners); }

 private:
  [[nodiscard]] V3 pushed(const V3& core, double radius) const {
    const double length = direction.norm();
    return length > 0 ? V3(core + direction * (radius / length)) : core;
  }
  [[nodiscard]] V3 of_corners(const std::vector<V3>& corners) const {
    return *std::max_element(corners.begin(), corners.end(),
                             [&](const V3& a, const V3& b) { return a.dot(direction) < b.dot(direction); });
  }
};

}  // namespace

Polytope polytope_of(const Obb<double, 3>& obb, int dim) {
  return box(obb.center, obb.axes * obb.half_extents.asDiagonal(), dim);
}

Polytope polytope_of(const Aabb<double, 3>& aabb, int dim) {
  const V3 half = (aabb.max - aabb.min) / 2;
  return box(aabb.min + half, half.asDiagonal(), dim);
}

/// Through its vertices: those that touch a slab's side are a face, in order around it.
Polytope polytope_of(const Kdop<double, 3>& kdop, int dim) {
  if (dim == 2) {
    Kdop<double, 2> plane{.k = kdop.k};
    std::copy_n(kdop.min.begin(), plane.min.size(), plane.min.begin());
    std::copy_n(kdop.max.begin(), plane.max.size(), plane.max.begin());
    return hull_of<2>(query::kdop_vertices(plane));
  }
  return hull_of<3>(query::kdop_vertices(kdop));
}

Polytope polytope_of(const ConvexHull<double, 3>& hull, int dim) {
  Polytope polytope{hull.vertices, {}};
  if (dim == 2) {
    polytope.faces.push_back(joined(hull.facets, hull.vertices.size()));
    return polytope;
  }
  for (const auto& facet : hull.facets) polytope.faces.push_back({facet[0], facet[1], facet[2]});
  return polytope;
}

V3 farthest_in(const fit::Volume3& volume, const V3& direction, int dim) {
  return std::visit(Farthest{direction, dim}, volume);
}

fit::Sphere3 ball_around(const fit::Volume3& volume, int dim) {
  if (const auto* ball = std::get_if<fit::Sphere3>(&volume)) return *ball;
  V3 least = V3::Zero(), greatest = V3::Zero();
  for (int axis = 0; axis < dim; ++axis) {
    least[axis] = farthest_in(volume, -V3::Unit(axis), dim)[axis];
    greatest[axis] = farthest_in(volume, V3::Unit(axis), dim)[axis];
  }
  return {least + (greatest - least) / 2, (greatest - least).norm() / 2};
}

fit::Sphere3 ball_around(const fit::Sphere3& a, const fit::Sphere3& b) {
  const double apart = (b.center - a.center).norm();
  if (apart + b.radius <= a.radius) return a;
  if (apart + a.radius <= b.radius) return b;
  const double radius = (apart + a.radius + b.radius) / 2;
  return {a.center + (b.center - a.center) * ((radius - a.radius) / apart), radius};
}

}  // namespace snug::app
