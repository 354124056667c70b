#include "physics/manifold.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/limits.hpp"

namespace snug::physics {
namespace {

using Kind = Shape::Kind;
using PoseAt = Pose<double, 3>;

Manifold flipped(Manifold manifold) {
  manifold.normal = -manifold.normal;
  return manifold;
}

Manifold of_spheres(const V3& a, double radius_a, const V3& b, double radius_b, double margin) {
  Manifold manifold;
  const V3 between = b - a;
  const double distance = between.norm(), separation = distance - radius_a - radius_b;
  if (separation > margin) return manifold;
  manifold.normal = distance > 0 ? V3(between / distance) : V3(V3::UnitY());  // concentric: any direction is a way out
  manifold.points[0] = {a + manifold.normal * (radius_a + separation / 2), separation};
  manifold.count = 1;
  return manifold;
}

/// The normal points from the box to the ball.
Manifold of_box_and_sphere(const Shape& box, const PoseAt& at, const V3& center, double radius, double margin) {
  const V3 local = turned_back<double, 3>(at.rotation, center - at.translation);
  const V3 nearest = local.cwiseMax(-box.half_extents).cwiseMin(box.half_extents);
  V3 normal = local - nearest;
  double distance = normal.norm();
  if (distance > 0) {
    normal /= distance;
  } else {  // the centre is inside: out through the nearest face
    int axis = 0;
    const V3 depth = box.half_extents - local.cwiseAbs();
    depth.minCoeff(&axis);
    normal = V3::Unit(axis) * (local[axis] < 0 ? -1.0 : 1.0);
    distance = -depth[axis];
  }
  Manifold manifold;
  const double separation = distance - radius;
  if (separation > margin) return manifold;
  manifold.normal = turned<double, 3>(at.rotation, normal);
  manifold.points[0] = {center - manifold.normal * (radius + separation / 2), separation};
  manifold.count = 1;
  return manifold;
}

// ---- two boxes

/// The axis along which they overlap least, or are farthest apart. code: 0 … 2 a face of a, 3 … 5 of b, from 6 on
/// edges.
struct Widest {
  double separation = -std::numeric_limits<double>::infinity();
  V3 normal = V3::Zero();  // from a to b
  int code = -1;
};

double reach_along(const Shape& box, const PoseAt& at, const V3& axis) {
  return turned_back<double, 3>(at.rotation, axis).cwiseAbs().dot(box.half_extents);
}

void consider(Widest& widest, const Shape& a, const PoseAt& at_a, const Shape& b, const PoseAt& at_b, const V3& axis,
              int code, double handicap) {
  const double offset = axis.dot(at_b.translation - at_a.translation);
  const double separation = std::abs(offset) - reach_along(a, at_a, axis) - reach_along(b, at_b, axis);
  if (separation - handicap > widest.separation) widest = {separation, offset < 0 ? V3(-axis) : axis, code};
}

Widest widest_axis(const Shape& a, const PoseAt& at_a, const Shape& b, const PoseAt& at_b) {
  // A later face has to be better by a little; otherwise rounding would choose between equal ones.
  const double thinner = std::min(a.thinnest, b.thinnest), slight = limits::kSlop * thinner / 16;
  Widest faces;
  for (int i = 0; i < 3; ++i) consider(faces, a, at_a, b, at_b, at_a.rotation.col(i), i, i == 0 ? 0 : slight);
  for (int i = 0; i < 3; ++i) consider(faces, a, at_a, b, at_b, at_b.rotation.col(i), 3 + i, slight);
  Widest best = faces;
  const double handicap = limits::kEdgeOverFace * thinner;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const V3 axis = at_a.rotation.col(i).cross(at_b.rotation.col(j));
      const double length = axis.norm();
      if (length > limits::kParallelEdges)
        consider(best, a, at_a, b, at_b, axis / length, 6 + 3 * i + j, best.code < 6 ? handicap : 0);
    }
  return best;
}

/// A face has four corners, and each of four planes adds at most one.
struct Polygon {
  std::array<V3, 8> corners;
  int count = 0;
  void add(const V3& corner) {
    if (count < 8) corners[count++] = corner;
  }
};

/// The part of the polygon where normal . p <= offset.
Polygon clipped(const Polygon& polygon, const V3& normal, double offset) {
  Polygon result;
  for (int i = 0; i < polygon.count; ++i) {
    const V3& from = polygon.corners[i];
    const V3& to = polygon.corners[(i + 1) % polygon.count];
    const double before = normal.dot(from) - offset, after = normal.dot(to) - offset;
    if (before <= 0) result.add(from);
    if ((before < 0 && after > 0) || (before > 0 && after < 0))
      result.add(from + (to - from) * (before / (before - after)));
  }
  return result;
}

/// The face of a box whose normal points most against a direction.
Polygon face_against(const Shape& box, const PoseAt& at, const V3& way) {
  const V3 local = turned_back<double, 3>(at.rotation, way);
  int axis = 0;
  local.cwiseAbs().maxCoeff(&axis);
  const double side = local[axis] > 0 ? -1 : 1;
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  Polygon face;
  for (int k = 0; k < 4; ++k) {
    V3 corner = V3::Zero();
    corner[axis] = side * box.half_extents[axis];
    corner[u] = (k == 1 || k == 2 ? 1 : -1) * box.half_extents[u];
    corner[v] = (k >= 2 ? 1 : -1) * box.half_extents[v];
    face.add(placed(at, corner));
  }
  return face;
}

/// axis: that of the reference box across which the faces meet; normal: along it, towards the other box.
Manifold of_faces(const Shape& reference, const PoseAt& at, int axis, const V3& normal, const Shape& other,
                  const PoseAt& at_other, double margin) {
  Polygon face = face_against(other, at_other, normal);
  for (int k = 1; k < 3; ++k) {
    const int side = (axis + k) % 3;
    const V3 across = at.rotation.col(side);
    const double middle = across.dot(at.translation), half = reference.half_extents[side];
    face = clipped(face, across, middle + half);
    face = clipped(face, -across, half - middle);
  }
  const double surface = normal.dot(at.translation) + reference.half_extents[axis];
  Manifold manifold{.normal = normal};
  for (int i = 0; i < face.count; ++i) {
    const V3& corner = face.corners[i];
    const double separation = normal.dot(corner) - surface;
    if (separation > margin) continue;
    manifold.points[manifold.count++] = {corner - normal * (separation / 2), separation};
  }
  return manifold;
}

/// The middle of the edge along an axis that reaches farthest in a direction.
V3 edge_middle(const Shape& box, const PoseAt& at, int axis, const V3& way) {
  const V3 local = turned_back<double, 3>(at.rotation, way);
  V3 middle;
  for (int k = 0; k < 3; ++k) middle[k] = local[k] < 0 ? -box.half_extents[k] : box.half_extents[k];
  middle[axis] = 0;
  return placed(at, middle);
}

Manifold of_edges(const Shape& a, const PoseAt& at_a, const Shape& b, const PoseAt& at_b, const Widest& widest) {
  const int i = (widest.code - 6) / 3, j = (widest.code - 6) % 3;
  const V3 u = at_a.rotation.col(i), v = at_b.rotation.col(j);
  const V3 p = edge_middle(a, at_a, i, widest.normal), q = edge_middle(b, at_b, j, -widest.normal);
  const V3 between = q - p;
  const double cosine = u.dot(v), square = 1 - cosine * cosine;
  const double s = (between.dot(u) - cosine * between.dot(v)) / square,
               t = (cosine * between.dot(u) - between.dot(v)) / square;
  const V3 on_a = p + std::clamp(s, -a.half_extents[i], a.half_extents[i]) * u,
           on_b = q + std::clamp(t, -b.half_extents[j], b.half_extents[j]) * v;
  Manifold manifold{.normal = widest.normal};
  manifold.points[0] = {(on_a + on_b) / 2, widest.separation};
  manifold.count = 1;
  return manifold;
}

Manifold of_boxes(const Shape& a, const PoseAt& at_a, const Shape& b, const PoseAt& at_b, double margin) {
  const Widest widest = widest_axis(a, at_a, b, at_b);
  if (widest.separation > margin) return {};
  if (widest.code >= 6) return of_edges(a, at_a, b, at_b, widest);
  if (widest.code < 3) return of_faces(a, at_a, widest.code, widest.normal, b, at_b, margin);
  return flipped(of_faces(b, at_b, widest.code - 3, -widest.normal, a, at_a, margin));
}

}  // namespace

Manifold manifold_of(const Shape& a, const PoseAt& at_a, const Shape& b, const PoseAt& at_b, double margin) {
  if (a.kind == Kind::kSphere && b.kind == Kind::kSphere)
    return of_spheres(at_a.translation, a.radius, at_b.translation, b.radius, margin);
  if (a.kind == Kind::kBox && b.kind == Kind::kSphere)
    return of_box_and_sphere(a, at_a, at_b.translation, b.radius, margin);
  if (a.kind == Kind::kSphere && b.kind == Kind::kBox)
    return flipped(of_box_and_sphere(b, at_b, at_a.translation, a.radius, margin));
  return of_boxes(a, at_a, b, at_b, margin);
}

double separation_of(const Shape& a, const PoseAt& at_a, const Shape& b, const PoseAt& at_b) {
  if (a.kind == Kind::kBox && b.kind == Kind::kBox) return widest_axis(a, at_a, b, at_b).separation;
  return manifold_of(a, at_a, b, at_b, std::numeric_limits<double>::infinity()).points[0].separation;
}

}  // namespace snug::physics
