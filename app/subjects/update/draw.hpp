// Draws an update; for this folder only.
#pragma once

#include "app/point_marks.hpp"
#include "app/subjects/update/shown.hpp"

namespace snug::app {

/// The body with both frames and its knobs, what the update keeps of it, and the volume.
void draw_update_of_body(Brush& brush, const UpdateShown& shown);
/// The climb at hand over the hull: the edges walked along, and the projections of what was compared.
void draw_climb(Brush& brush, const UpdateShown& shown);
/// The marks on the vertices of the climb, and their names.
void mark_climb(Brush& brush, const UpdateShown& shown);
void name_climb(PointNames& names, const UpdateShown& shown);

/// A line beside the body, along an axis, onto which its points are projected.
struct AxisRuler {
  Point3 origin, axis;  // axis: unit
  double half = 1;      // its length each way, scene units
  AxisRuler(const Brush& brush, const UpdateShown& shown, const Point3& along);
  [[nodiscard]] Point3 at(double along) const { return origin + axis * along; }
  /// Where a place of the world projects to.
  [[nodiscard]] Point3 foot(const Point3& place) const { return at(axis.dot(place - origin)); }
};

}  // namespace snug::app
