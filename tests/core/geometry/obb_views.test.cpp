// The oriented box's views against its working form in rational arithmetic, and the bytes of everything.
#include "geometry/obb_views.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "core/exactly.hpp"
#include "geometry/pose.hpp"
#include "geometry/random.hpp"
#include "geometry/tolerance.hpp"
#include "geometry/turn.hpp"
#include "geometry/volume_bytes.hpp"

using namespace snug;
using exact::exactly;
using exact::Rational;

namespace {

template <class Scalar, int Dim>
Rational dot(const Vector<Scalar, Dim>& a, const Vector<Scalar, Dim>& b) {
  Rational sum = 0;
  for (int i = 0; i < Dim; ++i) sum += exactly(a[i]) * exactly(b[i]);
  return sum;
}

template <class Scalar, int Dim>
Obb<Scalar, Dim> any_box(Random& random, double scale, double offset) {
  Obb<Scalar, Dim> box;
  if constexpr (Dim == 2) {
    box.axes = turn(random.between(-4, 4)).template cast<Scalar>();
  } else {
    const Vector<double, 3> axis(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    box.axes = turn(axis, random.between(-4, 4)).template cast<Scalar>();
  }
  for (int i = 0; i < Dim; ++i) {
    box.center[i] = static_cast<Scalar>(scale * (offset + random.between(-1, 1)));
    box.half_extents[i] = static_cast<Scalar>(random.below(5) == 0 ? 0 : scale * random.unit());
  }
  return box;
}

/// No vertex is farther from its exact place than rounding explains.
template <class Scalar, int Dim>
void check_vertices(const Obb<Scalar, Dim>& box) {
  const auto vertices = vertices_of(box);
  const double size = static_cast<double>(box.center.cwiseAbs().maxCoeff() + box.half_extents.sum());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    for (int j = 0; j < Dim; ++j) {
      Rational exact = exactly(box.center[j]);
      for (int i = 0; i < Dim; ++i)
        exact += (v >> i & 1 ? 1 : -1) * exactly(box.half_extents[i]) * exactly(box.axes(j, i));
      const Rational error = abs(exactly(vertices[v][j]) - exact);
      CHECK(error <= Rational(8 * tolerance::roundoff<Scalar>(size)));
    }
}

/// Each slab is the working form's own, rounded outwards by less than one step; and planes say the same.
template <class Scalar, int Dim>
void check_slabs_and_planes(const Obb<Scalar, Dim>& box, int& rounded) {
  constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();
  const auto slabs = slabs_of(box);
  const auto planes = planes_of(box);
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    const Vector<Scalar, Dim> axis = box.axes.col(static_cast<int>(i));
    const Rational middle = dot<Scalar, Dim>(box.center, axis), half = exactly(box.half_extents[static_cast<int>(i)]);
    CHECK(slabs[i].normal == axis);
    CHECK(exactly(slabs[i].max) >= middle + half);
    CHECK(exactly(std::nextafter(slabs[i].max, -kInfinity)) < middle + half);
    CHECK(exactly(slabs[i].min) <= middle - half);
    CHECK(exactly(std::nextafter(slabs[i].min, kInfinity)) > middle - half);
    rounded += exactly(slabs[i].max) != middle + half ? 1 : 0;
    CHECK(planes[2 * i].normal == axis);
    CHECK(planes[2 * i + 1].normal == -axis);
    CHECK(planes[2 * i].d == -slabs[i].max);
    CHECK(planes[2 * i + 1].d == slabs[i].min);
  }
}

}  // namespace

TEST_CASE_TEMPLATE("slabs and planes hold the box exactly and are as tight as numbers allow", Scalar, float, double) {
  Random random(1);
  int rounded = 0;
  const bool is_double = sizeof(Scalar) == 8;
  for (const double scale : {1.0, is_double ? 1e-160 : 1e-18, is_double ? 1e150 : 1e15})
    for (const double offset : {0.0, 1e5})
      for (int round = 0; round < 60; ++round) {
        const auto plane_box = any_box<Scalar, 2>(random, scale, offset);
        const auto space_box = any_box<Scalar, 3>(random, scale, offset);
        check_vertices(plane_box), check_vertices(space_box);
        check_slabs_and_planes(plane_box, rounded), check_slabs_and_planes(space_box, rounded);
      }
  CHECK(rounded > 500);
}

TEST_CASE("an upright box has the views that one expects") {
  const Obb<double, 3> box{{1, 2, 3}, Matrix<double, 3>::Identity(), {1, 2, 0}};
  const auto vertices = vertices_of(box);
  CHECK(vertices[0] == Vector<double, 3>(0, 0, 3));
  CHECK(vertices[1] == Vector<double, 3>(2, 0, 3));
  CHECK(vertices[6] == Vector<double, 3>(0, 4, 3));
  const auto slabs = slabs_of(box);
  CHECK(slabs[1].min == 0);
  CHECK(slabs[1].max == 4);
  const auto planes = planes_of(box);
  CHECK(planes[0].normal == Vector<double, 3>(1, 0, 0));
  CHECK(planes[0].d == -2);
  CHECK(signed_distance(planes[0], box.center) == -1);  // the centre is inside by a half extent
  CHECK(signed_distance(planes[1], vertices[0]) == 0);
}

TEST_CASE("bytes are those that the lectures count") {
  CHECK(bytes_of(Sphere<float, 3>{}) == 16);
  CHECK(bytes_of(Sphere<double, 2>{}) == 24);
  CHECK(bytes_of(Aabb<float, 3>{}) == 24);
  CHECK(bytes_of(AabbMinWidths<float, 3>{}) == 24);
  CHECK(bytes_of(AabbCenterExtents<double, 3>{}) == 48);
  CHECK(bytes_of(Capsule<float, 3>{}) == 28);
  CHECK(bytes_of(Lozenge<float, 3>{}) == 40);
  CHECK(bytes_of(ObbVertices<float, 3>{}) == 96);
  CHECK(bytes_of(ObbVertices<float, 2>{}) == 32);
  CHECK(bytes_of(Kdop<float, 3>{.k = 14}) == 56);  // about as much as the OBB's 60
  CHECK(bytes_of(Kdop<double, 2>{.k = 8}) == 64);
  ConvexHull<float, 3> hull;
  hull.vertices.resize(4), hull.indices.resize(4), hull.facets.resize(4);
  CHECK(bytes_of(hull) == 4 * 12 + 4 * 4 + 4 * 12);
}
