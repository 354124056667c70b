#include "geometry/obb_views.hpp"

#include <cmath>
#include <limits>

#include "number/dyadic.hpp"

namespace snug {
namespace {

/// The least Scalar that is not below the value.
template <class Scalar>
Scalar rounded_up(const Dyadic& value) {
  constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();
  auto bound = static_cast<Scalar>(value.approximate());  // within a step or two
  while (Dyadic(static_cast<double>(bound)) < value) bound = std::nextafter(bound, kInfinity);
  for (;;) {
    const Scalar below = std::nextafter(bound, -kInfinity);
    if (Dyadic(static_cast<double>(below)) < value) return bound;
    bound = below;
  }
}

}  // namespace

template <class Scalar, int Dim>
ObbSlabs<Scalar, Dim> slabs_of(const Obb<Scalar, Dim>& box) {
  ObbSlabs<Scalar, Dim> slabs;
  for (int i = 0; i < Dim; ++i) {
    Dyadic middle;
    for (int j = 0; j < Dim; ++j)
      middle += Dyadic(static_cast<double>(box.center[j])) * Dyadic(static_cast<double>(box.axes(j, i)));
    const Dyadic half_extent(static_cast<double>(box.half_extents[i]));
    slabs[i] = {box.axes.col(i), -rounded_up<Scalar>(half_extent - middle), rounded_up<Scalar>(middle + half_extent)};
  }
  return slabs;
}

template ObbSlabs<float, 2> slabs_of(const Obb<float, 2>&);
template ObbSlabs<float, 3> slabs_of(const Obb<float, 3>&);
template ObbSlabs<double, 2> slabs_of(const Obb<double, 2>&);
template ObbSlabs<double, 3> slabs_of(const Obb<double, 3>&);

}  // namespace snug
