// The discrete-orientation polytope: k half-spaces, as k/2 slabs along fixed axes that all k-DOPs of the same k share.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "geometry/core.hpp"
#include "geometry/reach.hpp"
#include "geometry/vector.hpp"
#include "trace/fields.hpp"

namespace snug {

/// The largest number of slabs: 13 for the 26-DOP, in 2-D 4 for the 8-DOP.
template <int Dim>
inline constexpr int kMostSlabs = Dim == 2 ? 4 : 13;

/// The k/2 axes of the slabs: the coordinate axes, then the directions to a box's vertices, then to its edges'
/// midpoints (k = 18 leaves out the vertices). They are small integers and not unit, so that projections onto them are
/// sums and differences of coordinates. Empty if there is no such k.
/// Source: C. Ericson, Real-Time Collision Detection, 2005, 4.6.
template <int Dim>
[[nodiscard]] std::span<const std::array<int, Dim>> kdop_axes(int k) noexcept;

template <int Dim>
using KdopAxis = std::array<int, Dim>;

/// p . axis, each sum rounded.
template <class Scalar, int Dim>
[[nodiscard]] Scalar project(const KdopAxis<Dim>& axis, const Vector<Scalar, Dim>& p) {
  Scalar sum = 0;
  for (int i = 0; i < Dim; ++i) sum += static_cast<Scalar>(axis[i]) * p[i];
  return sum;
}

/// All p with min_i <= p . axis_i <= max_i for each of the k/2 axes.
template <class Scalar, int Dim>
struct Kdop {
  int k = 2 * Dim;                            // 2-D: 4, 6, 8; 3-D: 6, 14, 18, 26
  std::array<Scalar, kMostSlabs<Dim>> min{};  // only the first k/2 are used
  std::array<Scalar, kMostSlabs<Dim>> max{};  // >= min
  SNUG_FIELDS(k, min, max);
};

/// The corners, each once, relative to an origin (subtracted before anything is rounded, so that far k-DOPs lose no
/// digits), in scene units. A slab that the others make redundant adds none. There are none at all if the slabs have no
/// point in common, unless only the rounding of their bounds keeps them apart. Each lies in all slabs within
/// kKdopCorner. kdop.k: one of the known.
template <class Scalar, int Dim>
[[nodiscard]] Corners<Dim> kdop_vertices(const Kdop<Scalar, Dim>& kdop,
                                         const Vector<Scalar, Dim>& origin = Vector<Scalar, Dim>::Zero());

template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> anchor(const Kdop<Scalar, Dim>& kdop) {
  Vector<Scalar, Dim> least;  // the first axes are those of the coordinates
  for (int i = 0; i < Dim; ++i) least[i] = kdop.min[i];
  return least;
}

template <class Scalar, int Dim>
[[nodiscard]] Corners<Dim> core_corners(const Kdop<Scalar, Dim>& kdop, const Vector<Scalar, Dim>& origin) {
  return kdop_vertices(kdop, origin);
}

/// In kdop_reach.hpp.
template <class Number, class Scalar, int Dim>
[[nodiscard]] Span<Number> core_span(const Plane<Scalar, Dim>& plane, const Kdop<Scalar, Dim>& kdop);
/// The span is a weighted sum of bounds, and the sizes of the weights add up to at most 6 times that of the normal
/// (kdop_reach.hpp).
template <class Scalar, int Dim>
[[nodiscard]] Scalar magnitude_of(const Kdop<Scalar, Dim>& kdop) {
  Scalar most = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(kdop.k / 2); ++i)
    most = std::max({most, std::abs(kdop.min[i]), std::abs(kdop.max[i])});
  return 6 * most;
}

/// p . axis by sums and differences alone, because the entries are -1, 0 and 1.
template <class Scalar, int Dim>
[[nodiscard]] Scalar sum_along(const KdopAxis<Dim>& axis, const Vector<Scalar, Dim>& p) {
  std::optional<Scalar> sum;
  for (int i = 0; i < Dim; ++i) {
    if (axis[i] == 0) continue;
    const Scalar term = axis[i] > 0 ? p[i] : -p[i];
    sum = sum ? *sum + term : term;
  }
  return *sum;
}

template <class Scalar, int Dim>
[[nodiscard]] Kdop<Scalar, Dim> moved(Kdop<Scalar, Dim> kdop, const Vector<Scalar, Dim>& by) {
  const auto axes = kdop_axes<Dim>(kdop.k);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Scalar along = sum_along<Scalar, Dim>(axes[i], by);
    kdop.min[i] += along;
    kdop.max[i] += along;
  }
  return kdop;
}

}  // namespace snug
