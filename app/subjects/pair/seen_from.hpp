// Two boxes in the world, or in A's frame, where A is axis-aligned around the origin.
#pragma once

#include "app/subjects/pair/shown.hpp"
#include "lesson/boxes.hpp"

namespace snug::app {

struct SeenFrom {
  Matrix<double, 3> axes = Matrix<double, 3>::Identity();  // those of the frame, as columns
  Point3 origin = Point3::Zero();

  [[nodiscard]] Point3 at(const Point3& p) const { return axes.transpose() * (p - origin); }
  [[nodiscard]] Point3 back(const Point3& p) const { return origin + axes * p; }

  [[nodiscard]] Obb<double, 3> box(const Obb<double, 3>& box) const {
    return {at(box.center), axes.transpose() * box.axes, box.half_extents};
  }
  [[nodiscard]] lesson::BoxPair boxes(lesson::BoxPair pair) const {
    for (Obb<double, 3>& one : pair.boxes) one = box(one);
    return pair;
  }
  /// Turns the axes of a step.
  void turn(PairShown& shown) const {
    for (auto* axis : {&shown.axis, &shown.axis_asked})
      if (*axis) (*axis)->axis.direction = axes.transpose() * (*axis)->axis.direction;
  }
};

}  // namespace snug::app
