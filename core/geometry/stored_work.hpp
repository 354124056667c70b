// What it costs to move, to turn and to grow a volume in the representation that it is stored in: each update as a
// program does it, with its additions and multiplications counted.
// Source: C. Ericson, Real-Time Collision Detection, 2005, 4.2 to 4.6.
//
// There is no overload where the numbers alone do not tell the result: an axis-aligned box or a k-DOP that turns has to
// be fitted anew, and a box that is stored as its vertices knows no axes to grow along.
#pragma once

#include <cmath>

#include "geometry/aabb_forms.hpp"
#include "geometry/capsule.hpp"
#include "geometry/kdop.hpp"
#include "geometry/lozenge.hpp"
#include "geometry/obb_views.hpp"
#include "geometry/pose.hpp"
#include "geometry/sphere.hpp"

namespace snug {

/// Adds and multiplies, and counts both.
struct Work {
  int additions = 0, multiplications = 0;
  [[nodiscard]] int all() const { return additions + multiplications; }

  double add(double a, double b) {
    ++additions;
    return a + b;
  }
  template <int Dim>
  Vector<double, Dim> add(const Vector<double, Dim>& a, const Vector<double, Dim>& b) {
    additions += Dim;
    return a + b;
  }
  template <int Dim>
  double dot(const Vector<double, Dim>& a, const Vector<double, Dim>& b) {
    multiplications += Dim, additions += Dim - 1;
    return a.dot(b);
  }
  template <int Dim>
  Vector<double, Dim> product(const Matrix<double, Dim>& m, const Vector<double, Dim>& v) {
    Vector<double, Dim> image;
    for (int i = 0; i < Dim; ++i) image[i] = dot<Dim>(m.row(i).transpose(), v);
    return image;
  }
};

// ---- moved by a vector ------------------------------------------------------------------------------------------

template <int Dim>
[[nodiscard]] Aabb<double, Dim> moved(Work& work, const Aabb<double, Dim>& box, const Vector<double, Dim>& by) {
  return {work.add<Dim>(box.min, by), work.add<Dim>(box.max, by)};
}
template <int Dim>
[[nodiscard]] AabbMinWidths<double, Dim> moved(Work& work, const AabbMinWidths<double, Dim>& box,
                                               const Vector<double, Dim>& by) {
  return {work.add<Dim>(box.min, by), box.widths};
}
template <int Dim>
[[nodiscard]] AabbCenterExtents<double, Dim> moved(Work& work, const AabbCenterExtents<double, Dim>& box,
                                                   const Vector<double, Dim>& by) {
  return {work.add<Dim>(box.center, by), box.half_extents};
}
template <int Dim>
[[nodiscard]] ObbVertices<double, Dim> moved(Work& work, ObbVertices<double, Dim> vertices,
                                             const Vector<double, Dim>& by) {
  for (auto& vertex : vertices) vertex = work.add<Dim>(vertex, by);
  return vertices;
}
template <int Dim>
[[nodiscard]] ObbPlanes<double, Dim> moved(Work& work, ObbPlanes<double, Dim> planes, const Vector<double, Dim>& by) {
  for (auto& plane : planes) plane.d = work.add(plane.d, -work.dot<Dim>(plane.normal, by));
  return planes;
}
template <int Dim>
[[nodiscard]] ObbSlabs<double, Dim> moved(Work& work, ObbSlabs<double, Dim> slabs, const Vector<double, Dim>& by) {
  for (auto& slab : slabs) {
    const double along = work.dot<Dim>(slab.normal, by);
    slab.min = work.add(slab.min, along), slab.max = work.add(slab.max, along);
  }
  return slabs;
}
template <int Dim>
[[nodiscard]] Obb<double, Dim> moved(Work& work, const Obb<double, Dim>& box, const Vector<double, Dim>& by) {
  return {work.add<Dim>(box.center, by), box.axes, box.half_extents};
}
template <int Dim>
[[nodiscard]] Sphere<double, Dim> moved(Work& work, const Sphere<double, Dim>& ball, const Vector<double, Dim>& by) {
  return {work.add<Dim>(ball.center, by), ball.radius};
}
template <int Dim>
[[nodiscard]] Capsule<double, Dim> moved(Work& work, const Capsule<double, Dim>& capsule,
                                         const Vector<double, Dim>& by) {
  return {work.add<Dim>(capsule.a, by), work.add<Dim>(capsule.b, by), capsule.radius};
}
template <int Dim>
[[nodiscard]] Lozenge<double, Dim> moved(Work& work, const Lozenge<double, Dim>& lozenge,
                                         const Vector<double, Dim>& by) {
  return {work.add<Dim>(lozenge.origin, by), lozenge.edges, lozenge.radius};
}
/// The axes' entries are -1, 0 and 1: a projection onto one takes additions alone.
template <int Dim>
[[nodiscard]] Kdop<double, Dim> moved(Work& work, Kdop<double, Dim> kdop, const Vector<double, Dim>& by) {
  const auto axes = kdop_axes<Dim>(kdop.k);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    double along = 0;
    int terms = 0;
    for (int j = 0; j < Dim; ++j) {
      if (axes[i][j] == 0) continue;
      const double term = axes[i][j] > 0 ? by[j] : -by[j];
      along = terms++ == 0 ? term : work.add(along, term);
    }
    kdop.min[i] = work.add(kdop.min[i], along), kdop.max[i] = work.add(kdop.max[i], along);
  }
  return kdop;
}

// ---- turned about the origin ------------------------------------------------------------------------------------

template <int Dim>
[[nodiscard]] ObbVertices<double, Dim> turned(Work& work, ObbVertices<double, Dim> vertices,
                                              const Matrix<double, Dim>& rotation) {
  for (auto& vertex : vertices) vertex = work.product<Dim>(rotation, vertex);
  return vertices;
}
template <int Dim>
[[nodiscard]] ObbPlanes<double, Dim> turned(Work& work, ObbPlanes<double, Dim> planes,
                                            const Matrix<double, Dim>& rotation) {
  for (auto& plane : planes) plane.normal = work.product<Dim>(rotation, plane.normal);
  return planes;
}
template <int Dim>
[[nodiscard]] ObbSlabs<double, Dim> turned(Work& work, ObbSlabs<double, Dim> slabs,
                                           const Matrix<double, Dim>& rotation) {
  for (auto& slab : slabs) slab.normal = work.product<Dim>(rotation, slab.normal);
  return slabs;
}
template <int Dim>
[[nodiscard]] Obb<double, Dim> turned(Work& work, Obb<double, Dim> box, const Matrix<double, Dim>& rotation) {
  box.center = work.product<Dim>(rotation, box.center);
  for (int i = 0; i < Dim; ++i) box.axes.col(i) = work.product<Dim>(rotation, Vector<double, Dim>(box.axes.col(i)));
  return box;
}
template <int Dim>
[[nodiscard]] Sphere<double, Dim> turned(Work& work, const Sphere<double, Dim>& ball,
                                         const Matrix<double, Dim>& rotation) {
  return {work.product<Dim>(rotation, ball.center), ball.radius};
}
template <int Dim>
[[nodiscard]] Capsule<double, Dim> turned(Work& work, const Capsule<double, Dim>& capsule,
                                          const Matrix<double, Dim>& rotation) {
  return {work.product<Dim>(rotation, capsule.a), work.product<Dim>(rotation, capsule.b), capsule.radius};
}
template <int Dim>
[[nodiscard]] Lozenge<double, Dim> turned(Work& work, const Lozenge<double, Dim>& lozenge,
                                          const Matrix<double, Dim>& rotation) {
  return {work.product<Dim>(rotation, lozenge.origin),
          {work.product<Dim>(rotation, lozenge.edges[0]), work.product<Dim>(rotation, lozenge.edges[1])},
          lozenge.radius};
}

/// Turned about the origin and then moved, as a body's pose moves the body's volume.
template <class Form, int Dim>
requires requires(Work& work, const Form& form, const Matrix<double, Dim>& rotation) {
  turned<Dim>(work, form, rotation);
}
[[nodiscard]] Form placed(Work& work, const Form& form, const Pose<double, Dim>& pose) {
  return moved<Dim>(work, turned<Dim>(work, form, pose.rotation), pose.translation);
}

// ---- grown by a margin on every side ----------------------------------------------------------------------------

template <int Dim>
[[nodiscard]] Vector<double, Dim> every_side(double value) {
  return Vector<double, Dim>::Constant(value);
}

template <int Dim>
[[nodiscard]] Aabb<double, Dim> grown(Work& work, const Aabb<double, Dim>& box, double by) {
  return {work.add<Dim>(box.min, every_side<Dim>(-by)), work.add<Dim>(box.max, every_side<Dim>(by))};
}
template <int Dim>
[[nodiscard]] AabbMinWidths<double, Dim> grown(Work& work, const AabbMinWidths<double, Dim>& box, double by) {
  const double twice = work.add(by, by);
  return {work.add<Dim>(box.min, every_side<Dim>(-by)), work.add<Dim>(box.widths, every_side<Dim>(twice))};
}
template <int Dim>
[[nodiscard]] AabbCenterExtents<double, Dim> grown(Work& work, const AabbCenterExtents<double, Dim>& box, double by) {
  return {box.center, work.add<Dim>(box.half_extents, every_side<Dim>(by))};
}
template <int Dim>
[[nodiscard]] ObbPlanes<double, Dim> grown(Work& work, ObbPlanes<double, Dim> planes, double by) {
  for (auto& plane : planes) plane.d = work.add(plane.d, -by);
  return planes;
}
template <int Dim>
[[nodiscard]] ObbSlabs<double, Dim> grown(Work& work, ObbSlabs<double, Dim> slabs, double by) {
  for (auto& slab : slabs) slab.min = work.add(slab.min, -by), slab.max = work.add(slab.max, by);
  return slabs;
}
template <int Dim>
[[nodiscard]] Obb<double, Dim> grown(Work& work, const Obb<double, Dim>& box, double by) {
  return {box.center, box.axes, work.add<Dim>(box.half_extents, every_side<Dim>(by))};
}
template <int Dim>
[[nodiscard]] Sphere<double, Dim> grown(Work& work, const Sphere<double, Dim>& ball, double by) {
  return {ball.center, work.add(ball.radius, by)};
}
template <int Dim>
[[nodiscard]] Capsule<double, Dim> grown(Work& work, const Capsule<double, Dim>& capsule, double by) {
  return {capsule.a, capsule.b, work.add(capsule.radius, by)};
}
template <int Dim>
[[nodiscard]] Lozenge<double, Dim> grown(Work& work, const Lozenge<double, Dim>& lozenge, double by) {
  return {lozenge.origin, lozenge.edges, work.add(lozenge.radius, by)};
}
/// The axes are not unit: along one of two terms the bounds move by sqrt(2) times as much, of three by sqrt(3).
template <int Dim>
[[nodiscard]] Kdop<double, Dim> grown(Work& work, Kdop<double, Dim> kdop, double by) {
  const auto axes = kdop_axes<Dim>(kdop.k);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    double square = 0;
    for (const int entry : axes[i]) square += entry * entry;
    if (square > 1) ++work.multiplications;
    const double along = by * std::sqrt(square);
    kdop.min[i] = work.add(kdop.min[i], -along), kdop.max[i] = work.add(kdop.max[i], along);
  }
  return kdop;
}

}  // namespace snug
