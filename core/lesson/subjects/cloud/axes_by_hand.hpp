// The directions of a k-DOP's slabs, set by hand: each has a knob on a circle, in space a sphere, around the points.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fit/catalogue.hpp"
#include "lesson/subject.hpp"

namespace snug::lesson {

class AxesByHand {
 public:
  explicit AxesByHand(const AnyPointSet& points) { begin(points); }

  /// Begins with the coordinate axes.
  void begin(const AnyPointSet& points);
  /// Puts the knobs around points that have changed; in another dimension, it begins again.
  void follow(const AnyPointSet& points);

  [[nodiscard]] Index size() const { return static_cast<Index>(axes_.size()); }
  /// Unit; in 2-D z is 0.
  [[nodiscard]] const std::vector<Point3>& axes() const { return axes_; }
  [[nodiscard]] const Point3& center() const { return center_; }
  [[nodiscard]] Point3 at(Index i) const { return center_ + axes_[i] * reach_; }
  /// The other end of the direction, on the other side of the points.
  [[nodiscard]] Point3 opposite(Index i) const { return center_ - axes_[i] * reach_; }

  // Errors of all edits: the slabs would be endless; there would be too many.
  Done move(Index i, const Point3& to);
  Done remove(Index i);
  /// Drops the last ones, or adds directions that are as far as can be from all others: x+y, then x−y.
  Done resize(int count);
  [[nodiscard]] static int most(int dim) { return dim == 2 ? 8 : 13; }

  /// All directions, as one row of numbers.
  [[nodiscard]] std::vector<double> row() const;
  Done set_row(std::span<const double> row);

 private:
  Done take(std::vector<Point3> axes);

  int dim_ = 2;
  std::vector<Point3> axes_;
  Point3 center_ = Point3::Zero();
  double reach_ = 1;  // from the centre to a knob, scene units
};

/// Runs the method, and the volume alone. axes: as AxesByHand has them.
[[nodiscard]] fit::Recording record_slabs(std::span<const Point3> axes, const AnyPointSet& points,
                                          fit::Recording room = {});
[[nodiscard]] fit::Volume3 fit_slabs(std::span<const Point3> axes, const AnyPointSet& points);

/// A direction as people say it: "x+y", or in the plane "27°", in space its coordinates.
[[nodiscard]] std::string direction_text(const Point3& axis, int dim);

}  // namespace snug::lesson
