#include "app/polytope.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "fit/hull/quickhull.hpp"
#include "fit/lift.hpp"
#include "geometry/convert.hpp"
#include "geometry/kdop.hpp"
#include "geometry/tolerance.hpp"
#include "query/distance/support_function.hpp"

namespace snug::app {
namespace {

using V3 = Vector<double, 3>;

/// A box's vertices by their bits (1: +x, 2: +y, 4: +z) and its faces.
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

/// The vertices of planar edges, in the order in which the edges join.
std::vector<int> joined(const std::vector<std::array<Index, 3>>& edges, std::size_t corners) {
  std::vector<int> next(corners, -1), around;
  for (const auto& edge : edges) next[edge[0]] = edge[1];
  if (edges.empty()) return around;
  for (int at = edges.front()[0]; around.size() < edges.size(); at = next[at]) around.push_back(at);
  return around;
}

/// The hull of a few points of the plane, which were accepted before.
Polytope hull_of(std::vector<Vector<double, 2>> corners) {
  const auto set = PointSet<double, 2>::make(std::move(corners));
  return set ? polytope_of(fit::lift(fit::quickhull(set->span()).volume), 2) : Polytope{};
}

/// The corners on one side of a slab, in order around that face; outward: across it.
std::vector<int> face_of(const std::vector<V3>& corners, const V3& outward, double bound, double doubt) {
  std::vector<int> face;
  V3 middle = V3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (std::abs(outward.dot(corners[i]) - bound) > doubt) continue;
    face.push_back(static_cast<int>(i));
    middle += corners[i];
  }
  middle /= std::max(1.0, static_cast<double>(face.size()));
  const V3 u = outward.cross(V3(std::abs(outward[1]) < 0.9 ? V3::UnitY() : V3::UnitX())), v = outward.cross(u);
  const auto angle = [&](int corner) {
    const V3 way = corners[corner] - middle;
    return std::atan2(way.dot(v), way.dot(u) * outward.norm());
  };
  std::sort(face.begin(), face.end(), [&](int a, int b) { return angle(a) < angle(b); });
  return face;
}

constexpr std::size_t kMostFacetsJoined = 128;  // of more facets, those in one plane are too small to matter

/// A solid's facets; those that lie in one plane but for rounding are one face.
std::vector<std::vector<int>> joined_facets(const ConvexHull<double, 3>& hull) {
  const double doubt = tolerance::kOnOutline * magnitude_of(hull);
  std::vector<std::vector<int>> faces;
  for (const auto& [a, b, c] : hull.facets) {
    const V3& corner = hull.vertices[a];
    const V3 outward = (hull.vertices[b] - corner).cross(hull.vertices[c] - corner).normalized();
    std::vector<int> face = face_of(hull.vertices, outward, outward.dot(corner), doubt);
    if (face.size() < 3) face = {a, b, c};
    std::vector<int> first = face;
    std::rotate(first.begin(), std::min_element(first.begin(), first.end()), first.end());
    if (std::find(faces.begin(), faces.end(), first) == faces.end()) faces.push_back(std::move(first));
  }
  return faces;
}

}  // namespace

Polytope polytope_of(const Obb<double, 3>& obb, int dim) {
  return box(obb.center, obb.axes * obb.half_extents.asDiagonal(), dim);
}

Polytope polytope_of(const Aabb<double, 3>& aabb, int dim) {
  const V3 half = (aabb.max - aabb.min) / 2;
  return box(aabb.min + half, half.asDiagonal(), dim);
}

/// A k-DOP's faces from its vertices: those that touch one side of a slab form a face, in order around it.
Polytope polytope_of(const Kdop<double, 3>& kdop, int dim) {
  if (dim == 2) return hull_of(kdop_vertices(converted<double, 2>(kdop)));
  Polytope polytope{kdop_vertices(kdop), {}};
  const double doubt = tolerance::kKdopCorner<double> * magnitude_of(kdop);
  const auto axes = kdop_axes<3>(kdop.k);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const V3 axis(axes[i][0], axes[i][1], axes[i][2]);
    for (const auto& [outward, bound] : {std::pair{V3(-axis), -kdop.min[i]}, {axis, kdop.max[i]}})
      if (auto face = face_of(polytope.corners, outward, bound, doubt); face.size() > 2)
        polytope.faces.push_back(std::move(face));
  }
  return polytope;
}

Polytope polytope_of(const ConvexHull<double, 3>& hull, int dim) {
  Polytope polytope{hull.vertices, {}};
  if (dim == 2) {
    polytope.faces.push_back(joined(hull.facets, hull.vertices.size()));
    return polytope;
  }
  if (hull.affine_dim < 3) {  // a polygon in space, its vertices in order; a segment; or a point, which has no face
    if (hull.vertices.size() < 2) return polytope;
    polytope.faces.emplace_back(hull.vertices.size());
    std::iota(polytope.faces.front().begin(), polytope.faces.front().end(), 0);
    return polytope;
  }
  if (hull.facets.size() > kMostFacetsJoined) {
    for (const auto& facet : hull.facets) polytope.faces.push_back({facet[0], facet[1], facet[2]});
    return polytope;
  }
  polytope.faces = joined_facets(hull);
  return polytope;
}

V3 farthest_in(const fit::Volume3& volume, const V3& direction, int dim) {
  const auto farthest = [&]<int Dim>(std::integral_constant<int, Dim>) {
    return std::visit(
        [&](const auto& kind) {
          const Vector<double, Dim> way = direction.template head<Dim>();
          V3 lifted;
          convert_into(lifted, query::support(converted<double, Dim>(kind), way));
          return lifted;
        },
        volume);
  };
  return dim == 2 ? farthest(std::integral_constant<int, 2>()) : farthest(std::integral_constant<int, 3>());
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
