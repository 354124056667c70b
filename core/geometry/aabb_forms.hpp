// The axis-aligned box in its other two representations, and the ways between all three.
// Source: C. Ericson, Real-Time Collision Detection, 2005, 4.2.
//
// No conversion loses a point: in exact arithmetic the result contains the box that it was made of, and no face lies
// farther out than two units in the last place of the box's largest coordinate or width. A bound beyond every Scalar
// becomes infinite. The input is finite; nothing on the way over- or underflows to any effect.
#pragma once

#include <algorithm>

#include "geometry/aabb.hpp"
#include "number/outward.hpp"

namespace snug {

/// All p with min <= p <= min + widths in every coordinate, scene units.
template <class Scalar, int Dim>
struct AabbMinWidths {
  Vector<Scalar, Dim> min = Vector<Scalar, Dim>::Zero();
  Vector<Scalar, Dim> widths = Vector<Scalar, Dim>::Zero();  // >= 0
};

/// All p with |p - center| <= half_extents in every coordinate, scene units. (Also called centre-radius.)
template <class Scalar, int Dim>
struct AabbCenterExtents {
  Vector<Scalar, Dim> center = Vector<Scalar, Dim>::Zero();
  Vector<Scalar, Dim> half_extents = Vector<Scalar, Dim>::Zero();  // >= 0
};

template <class Number, class Scalar, int Dim>
[[nodiscard]] Span<Number> core_span(const Plane<Scalar, Dim>& plane, const AabbCenterExtents<Scalar, Dim>& box) {
  const Vector<Scalar, Dim> sizes = plane.normal.cwiseAbs();
  return around<Number>(plane, box.center, dot_as<Number, Scalar, Dim>(sizes, box.half_extents));
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar magnitude_of(const AabbCenterExtents<Scalar, Dim>& box) {
  return largest<Scalar, Dim>(box.center) + largest<Scalar, Dim>(box.half_extents);
}

template <class Scalar, int Dim>
[[nodiscard]] AabbMinWidths<Scalar, Dim> min_widths_of(const Aabb<Scalar, Dim>& box) {
  AabbMinWidths<Scalar, Dim> result{box.min, {}};
  for (int i = 0; i < Dim; ++i) result.widths[i] = sum_up<Scalar>(box.max[i], -box.min[i]);
  return result;
}

/// Halves before adding if the sum would overflow, and otherwise after, because halves could lose a digit.
template <class Scalar, int Dim>
[[nodiscard]] AabbCenterExtents<Scalar, Dim> center_extents_of(const Aabb<Scalar, Dim>& box) {
  AabbCenterExtents<Scalar, Dim> result;
  for (int i = 0; i < Dim; ++i) {
    const Scalar sum = box.min[i] + box.max[i];
    const Scalar center = std::isfinite(sum) ? sum / 2 : box.min[i] / 2 + box.max[i] / 2;
    result.center[i] = center;
    result.half_extents[i] = std::max(sum_up<Scalar>(box.max[i], -center), sum_up<Scalar>(center, -box.min[i]));
  }
  return result;
}

template <class Scalar, int Dim>
[[nodiscard]] Aabb<Scalar, Dim> min_max_of(const AabbMinWidths<Scalar, Dim>& box) {
  Aabb<Scalar, Dim> result{box.min, {}};
  for (int i = 0; i < Dim; ++i) result.max[i] = sum_up<Scalar>(box.min[i], box.widths[i]);
  return result;
}

template <class Scalar, int Dim>
[[nodiscard]] Aabb<Scalar, Dim> min_max_of(const AabbCenterExtents<Scalar, Dim>& box) {
  Aabb<Scalar, Dim> result;
  for (int i = 0; i < Dim; ++i) {
    result.min[i] = sum_down<Scalar>(box.center[i], -box.half_extents[i]);
    result.max[i] = sum_up<Scalar>(box.center[i], box.half_extents[i]);
  }
  return result;
}

/// Converts through min and max, so it may be off by three units in the last place.
template <class Scalar, int Dim>
[[nodiscard]] AabbMinWidths<Scalar, Dim> min_widths_of(const AabbCenterExtents<Scalar, Dim>& box) {
  return min_widths_of(min_max_of(box));
}

/// Converts through min and max, so it may be off by three units in the last place.
template <class Scalar, int Dim>
[[nodiscard]] AabbCenterExtents<Scalar, Dim> center_extents_of(const AabbMinWidths<Scalar, Dim>& box) {
  return center_extents_of(min_max_of(box));
}

}  // namespace snug
