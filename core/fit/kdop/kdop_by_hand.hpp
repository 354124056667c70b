// The k-DOP whose directions are chosen by hand: what is between its slabs, as a polygon or a solid.
// Source: J. T. Klosowski, M. Held, J. S. B. Mitchell, H. Sowizral, K. Zikan, "Efficient collision detection using
// bounding volume hierarchies of k-DOPs", 1998.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "fit/kdop/kdop_steps.hpp"
#include "geometry/hull.hpp"
#include "geometry/point_set.hpp"
#include "trace/observer.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 3> kKdopByHandPseudocode{
    "for each direction that was set by hand",
    "  slab ← least to greatest p · direction",
    "return the intersection of the slabs",
};

/// A slab in any direction. axis: unit, within rounding; bounds in scene units, rounded.
template <int Dim>
struct FreeSlab {
  Vector<double, Dim> axis;
  double min = 0, max = 0;
};

/// How well directions enclose: the largest determinant of Dim of them, 1 where they are perpendicular; 0 where all are
/// parallel, in space to one plane. axes: unit.
template <int Dim>
[[nodiscard]] double enclosing(std::span<const Vector<double, Dim>> axes);
/// Below it, slabs are taken for endless.
inline constexpr double kLeastEnclosing = 1.0 / 64;

/// What is between the slabs, widened by a few roundings until it contains every point in exact arithmetic. None if the
/// slabs are endless. slabs: their bounds are the points' extremes. points: n >= 1 finite points, scene units.
template <int Dim>
[[nodiscard]] std::optional<ConvexHull<double, Dim>> within_slabs(std::span<const FreeSlab<Dim>> slabs,
                                                                  PointSpan<double, Dim> points);

/// Only what is between the slabs is a volume, so there is none before they enclose anything.
template <int Dim>
using SlabsStep = Step<ConvexHull<double, Dim>, SlabFound, Finished>;

/// The extremes along an axis: the first of equal ones.
template <int Dim>
[[nodiscard]] SlabFound extremes_along(const Vector<double, Dim>& axis, PointSpan<double, Dim> points) {
  SlabFound found{.least = 0, .greatest = 0, .min = axis.dot(points[0]), .max = axis.dot(points[0])};
  for (Index i = 1; i < points.size(); ++i) {
    const double at = axis.dot(points[i]);
    if (at < found.min) {
      found.min = at;
      found.least = i;
    }
    if (at > found.max) {
      found.max = at;
      found.greatest = i;
    }
  }
  return found;
}

/// axes: unit, enclosing by at least kLeastEnclosing. points: n >= 1 finite points, scene units. O(k n) time, and
/// O(k^(Dim + 1)) for the volume.
template <int Dim, StepObserver<SlabsStep<Dim>> Observer = Ignore>
Fit<ConvexHull<double, Dim>> kdop_by_hand(PointSpan<double, Dim> points, std::span<const Vector<double, Dim>> axes,
                                          Observer&& observe = {}) {
  Fit<ConvexHull<double, Dim>> fit;
  std::vector<FreeSlab<Dim>> slabs;
  for (const auto& axis : axes) {
    SlabFound found = extremes_along<Dim>(axis, points);
    found.slab = static_cast<int>(slabs.size());
    slabs.push_back({axis, found.min, found.max});
    observe.count(Operation::kPointsTouched, points.size());
    observe.count(Operation::kDotProducts, points.size());
    observe.count(Operation::kComparisons, 2 * (std::int64_t{points.size()} - 1));
    for (const Index i : {found.least, found.greatest})
      if (std::find(fit.support.begin(), fit.support.end(), i) == fit.support.end()) fit.support.push_back(i);
    if (!kWatched<Observer> && slabs.size() < axes.size()) continue;
    const auto volume = within_slabs<Dim>(slabs, points);
    if (volume) fit.volume = *volume;
    observe(SlabsStep<Dim>{1, volume.has_value(), fit.volume, found});
  }
  observe(SlabsStep<Dim>{2, true, fit.volume, Finished{fit.support}});
  return fit;
}

}  // namespace snug::fit
