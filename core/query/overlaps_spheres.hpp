// Tests a sphere against a sphere, an axis-aligned or an oriented box, by the distance of its centre.
// Source: J. Arvo, "A simple method for box-sphere intersection testing", Graphics Gems, 1990; C. Ericson, Real-Time
// Collision Detection, 2005, 4.3.1 and 5.2.5.
#pragma once

#include "geometry/aabb.hpp"
#include "geometry/obb.hpp"
#include "geometry/sphere.hpp"
#include "geometry/tolerance.hpp"
#include "query/overlap_result.hpp"
#include "query/overlap_steps.hpp"
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

/// Exact.
template <class Scalar, int Dim, StepObserver<OverlapStep> Observer = Ignore>
[[nodiscard]] OverlapResult<Scalar, Dim> test_spheres(const Sphere<Scalar, Dim>& a, const Sphere<Scalar, Dim>& b,
                                                      Observer&& observe = {}) {
  const bool apart = apart_exactly<Scalar, Dim>(a.center, a.radius, b.center, b.radius);
  return by_distance<Scalar, Dim>(apart, "centers", a.center, b.center - a.center, a.radius + b.radius, observe);
}

/// Exact, because each coordinate of the box's point nearest to the centre is one of the box's or the centre's.
template <class Scalar, int Dim, StepObserver<OverlapStep> Observer = Ignore>
[[nodiscard]] OverlapResult<Scalar, Dim> test_sphere_box(const Sphere<Scalar, Dim>& sphere,
                                                         const Aabb<Scalar, Dim>& box, Observer&& observe = {}) {
  const Vector<Scalar, Dim> nearest = sphere.center.cwiseMax(box.min).cwiseMin(box.max);
  const bool apart = apart_exactly<Scalar, Dim>(sphere.center, sphere.radius, nearest, 0);
  return by_distance<Scalar, Dim>(apart, "closest_points", sphere.center, nearest - sphere.center, sphere.radius,
                                  observe);
}

/// Tests the sphere's centre in the box's frame, within the rounding of both extents about a common point.
template <class Scalar, int Dim, StepObserver<OverlapStep> Observer = Ignore>
[[nodiscard]] OverlapResult<Scalar, Dim> test_sphere_box(const Sphere<Scalar, Dim>& sphere, const Obb<Scalar, Dim>& box,
                                                         Observer&& observe = {}) {
  const Vector<Scalar, Dim> center = box.axes.transpose() * (sphere.center - box.center);
  const Vector<Scalar, Dim> nearest = center.cwiseMax(-box.half_extents).cwiseMin(box.half_extents);
  const Scalar size = std::max({center.cwiseAbs().maxCoeff(), box.half_extents.maxCoeff(), sphere.radius});
  const Scalar touching = tolerance::kTouching<Scalar> * size;
  const bool apart = scaled_norm<Scalar, Dim>(nearest - center) > sphere.radius + touching;
  return by_distance<Scalar, Dim>(apart, "closest_points", sphere.center, box.axes * (nearest - center), sphere.radius,
                                  observe);
}

}  // namespace snug::query
