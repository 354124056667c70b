// Tests a sphere against a sphere, an axis-aligned or an oriented box, by the distance of its centre.
// Source: J. Arvo, "A simple method for box-sphere intersection testing", Graphics Gems, 1990; C. Ericson, Real-Time
// Collision Detection, 2005, 4.3.1 and 5.2.5.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/aabb.hpp"
#include "geometry/obb.hpp"
#include "geometry/sphere.hpp"
#include "geometry/tolerance.hpp"
#include "query/overlap/overlap_result.hpp"
#include "query/overlap/overlap_steps.hpp"
#include "trace/observer.hpp"

namespace snug::query {

/// Whether |a - b| > radius_a + radius_b, in exact arithmetic on the numbers as they are. 1 <= dim <= 3; all finite.
[[nodiscard]] bool apart_exactly(const double* a, double radius_a, const double* b, double radius_b, int dim) noexcept;

template <class Scalar, int Dim>
[[nodiscard]] bool apart_exactly(const Vector<Scalar, Dim>& a, Scalar radius_a, const Vector<Scalar, Dim>& b,
                                 Scalar radius_b) {
  const Vector<double, Dim> p = a.template cast<double>();
  const Vector<double, Dim> q = b.template cast<double>();
  return apart_exactly(p.data(), static_cast<double>(radius_a), q.data(), static_cast<double>(radius_b), Dim);
}

/// Whether a squared distance exceeds a squared radius, from their difference; none within the error bound. Underflow
/// of a square is far below the least normal number, and where one overflows nothing is certain.
template <class Scalar>
[[nodiscard]] std::optional<bool> if_certain(Scalar excess, Scalar error_bound) {
  if (std::abs(excess) > error_bound + std::numeric_limits<Scalar>::min()) return excess > 0;
  return std::nullopt;
}

// ---- The filters: whether a pair is apart; none where rounding could change the answer. All of it is inlined, even
// where the compiler optimizes for size: a call for each coordinate would cost more than the test.

template <class Scalar, int Dim>
[[nodiscard, gnu::flatten]] std::optional<bool> apart_filter(const Sphere<Scalar, Dim>& a,
                                                             const Sphere<Scalar, Dim>& b) {
  const Scalar radii = a.radius + b.radius, square = radii * radii;
  return if_certain((b.center - a.center).squaredNorm() - square, tolerance::kSquaresCompared<Scalar> * square);
}

template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> nearest_of(const Aabb<Scalar, Dim>& box, const Vector<Scalar, Dim>& p) {
  return p.cwiseMax(box.min).cwiseMin(box.max);
}

template <class Scalar, int Dim>
[[nodiscard, gnu::flatten]] std::optional<bool> apart_filter(const Sphere<Scalar, Dim>& sphere,
                                                             const Aabb<Scalar, Dim>& box) {
  Scalar square = 0;
  for (int i = 0; i < Dim; ++i) {
    const Scalar beyond = std::max(std::max(box.min[i] - sphere.center[i], sphere.center[i] - box.max[i]), Scalar(0));
    square += beyond * beyond;
  }
  const Scalar radius_square = sphere.radius * sphere.radius;
  return if_certain(square - radius_square, tolerance::kSquaresCompared<Scalar> * radius_square);
}

template <class Scalar, int Dim>
[[nodiscard, gnu::flatten]] std::optional<bool> apart_filter(const Sphere<Scalar, Dim>& sphere,
                                                             const Obb<Scalar, Dim>& box) {
  const Vector<Scalar, Dim> between = sphere.center - box.center;
  Scalar square = 0;
  for (int i = 0; i < Dim; ++i) {
    const Scalar beyond = std::max(std::abs(box.axes.col(i).dot(between)) - box.half_extents[i], Scalar(0));
    square += beyond * beyond;
  }
  const Scalar radius_square = sphere.radius * sphere.radius;
  const Scalar sizes = square + box.half_extents.squaredNorm() + radius_square;
  return if_certain(square - radius_square, tolerance::kDistanceFilter<Scalar> * sizes);
}

// ---- The verdicts.

/// Exact.
template <class Scalar, int Dim>
[[nodiscard, gnu::always_inline]] inline bool spheres_overlap(const Sphere<Scalar, Dim>& a,
                                                              const Sphere<Scalar, Dim>& b) {
  if (const auto apart = apart_filter(a, b)) [[likely]]
    return !*apart;
  return !apart_exactly<Scalar, Dim>(a.center, a.radius, b.center, b.radius);
}

/// Exact, because each coordinate of the box's point nearest to the centre is one of the box's or the centre's.
template <class Scalar, int Dim>
[[nodiscard, gnu::always_inline]] inline bool sphere_box_overlap(const Sphere<Scalar, Dim>& sphere,
                                                                 const Aabb<Scalar, Dim>& box) {
  if (const auto apart = apart_filter(sphere, box)) [[likely]]
    return !*apart;
  return !apart_exactly<Scalar, Dim>(sphere.center, sphere.radius, nearest_of(box, sphere.center), 0);
}

/// From a sphere's centre to an oriented box's nearest point, in the box's frame.
template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> way_to_box(const Sphere<Scalar, Dim>& sphere, const Obb<Scalar, Dim>& box) {
  const Vector<Scalar, Dim> center = box.axes.transpose() * (sphere.center - box.center);
  return center.cwiseMax(-box.half_extents).cwiseMin(box.half_extents) - center;
}

template <class Scalar, int Dim>
[[gnu::cold, gnu::noinline]] bool sphere_box_overlap_closely(const Sphere<Scalar, Dim>& sphere,
                                                             const Obb<Scalar, Dim>& box) {
  const Vector<Scalar, Dim> center = box.axes.transpose() * (sphere.center - box.center);
  const Scalar size = std::max({center.cwiseAbs().maxCoeff(), box.half_extents.maxCoeff(), sphere.radius});
  return scaled_norm<Scalar, Dim>(way_to_box(sphere, box)) <= sphere.radius + tolerance::kTouching<Scalar> * size;
}

/// Within the rounding of both extents about a common point.
template <class Scalar, int Dim>
[[nodiscard, gnu::always_inline]] inline bool sphere_box_overlap(const Sphere<Scalar, Dim>& sphere,
                                                                 const Obb<Scalar, Dim>& box) {
  if (const auto apart = apart_filter(sphere, box)) [[likely]]
    return !*apart;
  return sphere_box_overlap_closely(sphere, box);
}

// ---- The whole tests.

/// Compares the distance between two points, one on each volume's core, with the radii around them. A gap that only
/// exact arithmetic sees is the least positive value of the scalar. between: from on_a to the other point.
template <class Scalar, int Dim, class Observer>
[[nodiscard]] OverlapResult<Scalar, Dim> by_distance(bool apart, std::string_view kind, const Vector<Scalar, Dim>& on_a,
                                                     const Vector<Scalar, Dim>& between, Scalar radii,
                                                     Observer& observe) {
  OverlapResult<Scalar, Dim> result{.overlap = !apart, .distance = Scalar(0), .tests = 1};
  observe.count(Operation::kDistanceTests, 1);
  if constexpr (kWatched<Observer>) {
    const auto from = in_space<Scalar, Dim>(on_a), way = in_space<Scalar, Dim>(between);
    observe(OverlapStep{2, CoresCompared{from, from + way, way.stableNorm(), static_cast<double>(radii), apart}});
  }
  if (!apart) return result;
  const Scalar length = scaled_norm<Scalar, Dim>(between);
  const Scalar gap = std::max(length - radii, std::nextafter(radii, std::numeric_limits<Scalar>::infinity()) - radii);
  result.distance = gap;
  const Vector<Scalar, Dim> reduced = between / between.cwiseAbs().maxCoeff();
  result.separating_axis = {kind, reduced / reduced.norm(), gap};
  return result;
}

template <class Scalar, int Dim, StepObserver<OverlapStep> Observer = Ignore>
[[nodiscard]] OverlapResult<Scalar, Dim> test_spheres(const Sphere<Scalar, Dim>& a, const Sphere<Scalar, Dim>& b,
                                                      Observer&& observe = {}) {
  const bool apart = !spheres_overlap(a, b);
  return by_distance<Scalar, Dim>(apart, "centers", a.center, b.center - a.center, a.radius + b.radius, observe);
}

template <class Scalar, int Dim, StepObserver<OverlapStep> Observer = Ignore>
[[nodiscard]] OverlapResult<Scalar, Dim> test_sphere_box(const Sphere<Scalar, Dim>& sphere,
                                                         const Aabb<Scalar, Dim>& box, Observer&& observe = {}) {
  const Vector<Scalar, Dim> nearest = nearest_of(box, sphere.center);
  const bool apart = !sphere_box_overlap(sphere, box);
  return by_distance<Scalar, Dim>(apart, "closest_points", sphere.center, nearest - sphere.center, sphere.radius,
                                  observe);
}

template <class Scalar, int Dim, StepObserver<OverlapStep> Observer = Ignore>
[[nodiscard]] OverlapResult<Scalar, Dim> test_sphere_box(const Sphere<Scalar, Dim>& sphere, const Obb<Scalar, Dim>& box,
                                                         Observer&& observe = {}) {
  const bool apart = !sphere_box_overlap(sphere, box);
  return by_distance<Scalar, Dim>(apart, "closest_points", sphere.center, box.axes * way_to_box(sphere, box),
                                  sphere.radius, observe);
}

}  // namespace snug::query
