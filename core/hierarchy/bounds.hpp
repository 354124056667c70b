// Axis-aligned boxes around the bodies, which decide a tree's shape. Their rounding does not matter, because the nodes'
// volumes are made from the bodies' volumes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "geometry/bounds.hpp"
#include "query/distance/support_function.hpp"

namespace snug::hierarchy {

/// The box around a volume whose kind has no bounds_of in geometry/bounds.hpp. The volume must not be empty.
template <template <class, int> class Kind, class Scalar, int Dim>
[[nodiscard]] Aabb<double, Dim> bounds_of(const Kind<Scalar, Dim>& volume) {
  return query::box_around(volume);
}

/// In Layout's frame; in 2-D the third coordinate is 0.
struct Box {
  std::array<double, 3> low{}, high{};
};

/// A box's size, in proportion to how likely a line is to meet it. Sizes compare by area, equal areas by length.
struct Size {
  double area = 0;    // half of the surface area: x y + y z + z x
  double length = 0;  // x + y + z: a quarter of the edges' total length, in the plane half of the perimeter

  friend Size operator+(const Size& a, const Size& b) { return {a.area + b.area, a.length + b.length}; }
  friend Size operator-(const Size& a, const Size& b) { return {a.area - b.area, a.length - b.length}; }
  friend bool operator<(const Size& a, const Size& b) {
    return a.area < b.area || (a.area == b.area && a.length < b.length);
  }
  friend bool operator==(const Size& a, const Size& b) = default;
};

[[nodiscard]] inline Size half_surface_of(const Box& box) {
  const double x = box.high[0] - box.low[0], y = box.high[1] - box.low[1], z = box.high[2] - box.low[2];
  return {x * y + y * z + z * x, x + y + z};
}
/// In the plane the area is 0, so that half perimeters are compared: a line meets a segment too, which has no area.
[[nodiscard]] inline Size half_surface_of(const Box& box, int dim) {
  const Size size = half_surface_of(box);
  return dim == 2 ? Size{0, size.length} : size;
}

[[nodiscard]] inline Box united(const Box& a, const Box& b) {
  Box box;
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] = std::min(a.low[i], b.low[i]);
    box.high[i] = std::max(a.high[i], b.high[i]);
  }
  return box;
}

/// The bodies' boxes, moved and scaled into [0, 2], so that no area over- or underflows.
struct Layout {
  std::vector<Box> boxes;
  std::array<double, 3> origin{};
  double unit = 1;  // a length of 1 in scene units, a power of two
  int dim = 3;

  [[nodiscard]] double center(Index body, int axis) const {
    return (boxes[body].low[axis] + boxes[body].high[axis]) / 2;
  }
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
