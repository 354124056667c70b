#include "query/cull/vertices_along.hpp"

#include "query/distance/support_function.hpp"

namespace snug::query {
namespace {

/// The vertex, and every other one joined to it by edges along which the plane's value is constant within rounding.
template <class Scalar, int Dim, class Box>
int corners_like(int corner, const Plane<Scalar, Dim>& plane, const Vector<Scalar, Dim>& normal, const Box& box) {
  const Scalar error_bound = error_bound_of(plane, magnitude_of(box));
  int ties = 0;
  for (int i = 0; i < Dim; ++i)
    if (std::abs(normal[i]) * (corner_of(box, 1 << i) - corner_of(box, 0)).norm() <= error_bound) ties |= 1 << i;
  int corners = 0;
  for (int bits = 0; bits < 1 << Dim; ++bits)
    if (((bits ^ corner) & ~ties) == 0) corners |= 1 << bits;
  return corners;
}

}  // namespace

template <class Scalar, int Dim, class Shape>
PlaneTested<Scalar, Dim> vertices_along(const Plane<Scalar, Dim>& plane, const Shape& volume) {
  PlaneTested<Scalar, Dim> fact;
  fact.normal = normal_in_frame(plane, volume);
  for (int i = 0; i < Dim; ++i)
    if (fact.normal[i] >= 0) fact.signs |= 1 << i;
  if constexpr (requires { corner_of(volume, 0); }) {
    fact.p_vertex = fact.signs;
    fact.n_vertex = (1 << Dim) - 1 - fact.signs;
    fact.p_corners = corners_like<Scalar, Dim>(fact.p_vertex, plane, fact.normal, volume);
    fact.n_corners = corners_like<Scalar, Dim>(fact.n_vertex, plane, fact.normal, volume);
    fact.p_point = corner_of(volume, fact.p_vertex);
    fact.n_point = corner_of(volume, fact.n_vertex);
  } else if constexpr (std::is_same_v<Shape, Vector<Scalar, Dim>>) {
    fact.p_point = fact.n_point = volume;
  } else {
    fact.p_point = support(volume, plane.normal);
    fact.n_point = support(volume, Vector<Scalar, Dim>(-plane.normal));
  }
  return fact;
}

#define SNUG_SHAPE(Scalar, Dim, Shape)                                                                                 \
  template PlaneTested<Scalar, Dim> vertices_along(const Plane<Scalar, Dim>&, const Shape<Scalar, Dim>&);
#define SNUG_INSTANTIATE(Scalar, Dim)                                                                                  \
  SNUG_SHAPE(Scalar, Dim, Vector)                                                                                      \
  SNUG_SHAPE(Scalar, Dim, AabbCenterExtents)                                                                           \
  SNUG_EACH_VOLUME(SNUG_SHAPE, Scalar, Dim)
SNUG_INSTANTIATE(float, 2)
SNUG_INSTANTIATE(float, 3)
SNUG_INSTANTIATE(double, 2)
SNUG_INSTANTIATE(double, 3)
#undef SNUG_INSTANTIATE
#undef SNUG_SHAPE

}  // namespace snug::query
