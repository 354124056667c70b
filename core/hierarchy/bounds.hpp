// Axis-aligned boxes around the bodies, which decide a tree's shape. Their rounding does not matter, because the nodes'
// volumes are made from the bodies' volumes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "query/support_function.hpp"

namespace snug::hierarchy {

/// For any volume; what follows is faster. The volume must not be empty.
template <template <class, int> class Kind, class Scalar, int Dim>
[[nodiscard]] Aabb<double, Dim> bounds_of(const Kind<Scalar, Dim>& volume) {
  return query::box_around(volume);
}
template <class Scalar, int Dim>
[[nodiscard]] Aabb<double, Dim> bounds_of(const Aabb<Scalar, Dim>& box) {
  return {box.min.template cast<double>(), box.max.template cast<double>()};
}
template <class Scalar, int Dim>
[[nodiscard]] Aabb<double, Dim> bounds_around(const Vector<Scalar, Dim>& center, const Vector<double, Dim>& reach) {
  return {center.template cast<double>() - reach, center.template cast<double>() + reach};
}
template <class Scalar, int Dim>
[[nodiscard]] Aabb<double, Dim> bounds_of(const Sphere<Scalar, Dim>& sphere) {
  return bounds_around<Scalar, Dim>(sphere.center, Vector<double, Dim>::Constant(static_cast<double>(sphere.radius)));
}
template <class Scalar, int Dim>
[[nodiscard]] Aabb<double, Dim> bounds_of(const Obb<Scalar, Dim>& box) {
  return bounds_around<Scalar, Dim>(box.center, (box.axes.cwiseAbs() * box.half_extents).template cast<double>());
}
template <class Scalar, int Dim>
[[nodiscard]] Aabb<double, Dim> bounds_of(const Capsule<Scalar, Dim>& capsule) {
  const Vector<double, Dim> reach = Vector<double, Dim>::Constant(static_cast<double>(capsule.radius));
  return {capsule.a.cwiseMin(capsule.b).template cast<double>() - reach,
          capsule.a.cwiseMax(capsule.b).template cast<double>() + reach};
}
template <class Scalar, int Dim>
[[nodiscard]] Aabb<double, Dim> bounds_of(const Lozenge<Scalar, Dim>& lozenge) {
  const Vector<double, Dim> reach = Vector<double, Dim>::Constant(static_cast<double>(lozenge.radius));
  Aabb<double, Dim> bounds{lozenge.origin.template cast<double>() - reach,
                           lozenge.origin.template cast<double>() + reach};
  for (const auto& edge : lozenge.edges) {
    bounds.min += edge.template cast<double>().cwiseMin(0.0);
    bounds.max += edge.template cast<double>().cwiseMax(0.0);
  }
  return bounds;
}
template <class Scalar, int Dim>
[[nodiscard]] Aabb<double, Dim> bounds_of(const Kdop<Scalar, Dim>& kdop) {
  Aabb<double, Dim> bounds;  // the coordinate slabs come first
  for (std::size_t i = 0; i < Dim; ++i) {
    bounds.min[static_cast<int>(i)] = static_cast<double>(kdop.min[i]);
    bounds.max[static_cast<int>(i)] = static_cast<double>(kdop.max[i]);
  }
  return bounds;
}
/// The hull must have a vertex.
template <class Scalar, int Dim>
[[nodiscard]] Aabb<double, Dim> bounds_of(const ConvexHull<Scalar, Dim>& hull) {
  Aabb<Scalar, Dim> bounds{hull.vertices.front(), hull.vertices.front()};
  for (const auto& v : hull.vertices) bounds = {bounds.min.cwiseMin(v), bounds.max.cwiseMax(v)};
  return bounds_of(bounds);
}

/// In Layout's frame; in 2-D the third coordinate is 0.
struct Box {
  std::array<double, 3> low{}, high{};
};

/// Half of the surface, and the edges' lengths summed; in the plane the area is 0. Where there is no area, the length
/// decides.
struct Size {
  double area = 0, length = 0;

  friend Size operator+(const Size& a, const Size& b) { return {a.area + b.area, a.length + b.length}; }
  friend Size operator-(const Size& a, const Size& b) { return {a.area - b.area, a.length - b.length}; }
  friend bool operator<(const Size& a, const Size& b) {
    return a.area < b.area || (a.area == b.area && a.length < b.length);
  }
  friend bool operator==(const Size& a, const Size& b) = default;
};

[[nodiscard]] inline Size surface_of(const Box& box) {
  const double x = box.high[0] - box.low[0], y = box.high[1] - box.low[1], z = box.high[2] - box.low[2];
  return {x * y + y * z + z * x, x + y + z};
}
/// In the plane, the area is of no use, because a line's is 0.
[[nodiscard]] inline Size surface_of(const Box& box, int dim) {
  const Size size = surface_of(box);
  return dim == 2 ? Size{0, size.length} : size;
}

[[nodiscard]] inline Box united(const Box& a, const Box& b) {
  Box box;
  for (std::size_t i = 0; i < 3; ++i)
    box.low[i] = std::min(a.low[i], b.low[i]), box.high[i] = std::max(a.high[i], b.high[i]);
  return box;
}

/// The bodies' boxes, all within [0, 2] from the corner of the scene: so no area over- or underflows.
struct Layout {
  std::vector<Box> boxes;
  std::array<double, 3> origin{};
  double unit = 1;  // a length of 1 in scene units, a power of two
  int dim = 3;

  [[nodiscard]] double position(int axis, double local) const { return origin[axis] + local * unit; }
  /// Half of the surface area, or in the plane half of the perimeter, in scene units.
  [[nodiscard]] double area(const Size& size) const { return dim == 2 ? size.length * unit : size.area * unit * unit; }
};

/// Moves the boxes to the frame.
void normalize(Layout& layout);

template <template <class, int> class VolumeType, class Scalar, int Dim>
[[nodiscard]] Layout layout_of(std::span<const VolumeType<Scalar, Dim>> volumes) {
  Layout layout{.boxes = std::vector<Box>(volumes.size()), .dim = Dim};
  for (std::size_t body = 0; body < volumes.size(); ++body) {
    const Aabb<double, Dim> bounds = bounds_of(volumes[body]);
    for (int i = 0; i < Dim; ++i) {
      layout.boxes[body].low[i] = bounds.min[i];
      layout.boxes[body].high[i] = bounds.max[i];
    }
  }
  normalize(layout);
  return layout;
}

}  // namespace snug::hierarchy
