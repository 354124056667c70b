// What a k-DOP holds: figures worked out by hand, and cuts that must add up.
#include "geometry/kdop.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "geometry/aabb.hpp"
#include "geometry/kdop_measure.hpp"
#include "geometry/random.hpp"

using namespace snug;

namespace {

/// That k-DOP around a box from -1 to 1, its other slabs shared so wide that they just touch the box, times a factor.
template <class Scalar, int Dim>
Kdop<Scalar, Dim> around_unit_box(int k, double factor) {
  Kdop<Scalar, Dim> kdop{.k = k};
  const auto axes = kdop_axes<Dim>(k);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    int reach = 0;
    for (const int coordinate : axes[i]) reach += std::abs(coordinate);
    kdop.max[i] = static_cast<Scalar>(i < Dim ? 1 : factor * reach);
    kdop.min[i] = -kdop.max[i];
  }
  return kdop;
}

/// Random slabs that cut each other.
template <int Dim>
Kdop<double, Dim> any_kdop(int k, Random& random) {
  Kdop<double, Dim> kdop = around_unit_box<double, Dim>(k, 1);
  for (std::size_t i = 0; i < kdop_axes<Dim>(k).size(); ++i) {
    kdop.min[i] *= random.between(0.4, 1);
    kdop.max[i] *= random.between(0.4, 1);
  }
  return kdop;
}

}  // namespace

TEST_CASE_TEMPLATE("slabs that only touch a box cut nothing off", Scalar, float, double) {
  for (const int k : {4, 6, 8}) CHECK(measure(around_unit_box<Scalar, 2>(k, 1)) == doctest::Approx(4).epsilon(1e-14));
  for (const int k : {6, 14, 18, 26})
    CHECK(measure(around_unit_box<Scalar, 3>(k, 1)) == doctest::Approx(8).epsilon(1e-14));
}

TEST_CASE("what the cuts of a square's and a cube's corners leave over is known") {
  // Each corner of the square loses a right triangle of legs 2 - 2 * 0.75.
  CHECK(measure(around_unit_box<double, 2>(8, 0.75)) == doctest::Approx(4 - 4 * 0.125));
  CHECK(measure(around_unit_box<double, 2>(6, 0.75)) == doctest::Approx(4 - 2 * 0.125));
  // Each corner of the cube loses a tetrahedron of legs 3 - 3 * 0.75.
  CHECK(measure(around_unit_box<double, 3>(14, 0.75)) == doctest::Approx(8 - 8 * 0.75 * 0.75 * 0.75 / 6));
  // Cut by the edges alone at half of their reach, the cube is the rhombic dodecahedron |x| + |y| <= 1 and so on.
  CHECK(measure(around_unit_box<double, 3>(18, 0.5)) == doctest::Approx(2.0));
  // By the corners alone at a third of theirs, the octahedron.
  CHECK(measure(around_unit_box<double, 3>(14, 1.0 / 3)) == doctest::Approx(4.0 / 3));
}

TEST_CASE("the two parts of a cut k-DOP hold as much as the whole") {
  Random random(1);
  const auto check = [&]<int Dim>(const Kdop<double, Dim>& kdop, double offset) {
    for (std::size_t i = 0; i < kdop_axes<Dim>(kdop.k).size(); ++i) {
      Kdop<double, Dim> low = kdop, high = kdop;
      low.max[i] = high.min[i] = kdop.min[i] + random.unit() * (kdop.max[i] - kdop.min[i]);
      CHECK(measure(low) + measure(high) == doctest::Approx(measure(kdop)).epsilon(offset == 0 ? 1e-14 : 1e-8));
    }
  };
  for (int round = 0; round < 10; ++round) {
    for (const int k : {4, 6, 8}) check(any_kdop<2>(k, random), 0);
    for (const int k : {6, 14, 18, 26}) check(any_kdop<3>(k, random), 0);
  }
}

TEST_CASE("a k-DOP holds the same wherever it lies and at any size") {
  Random random(2);
  for (const int k : {6, 14, 18, 26}) {
    const Kdop<double, 3> kdop = any_kdop<3>(k, random);
    Kdop<double, 3> moved = kdop;
    const Vector<double, 3> offset(0x1p27, -0x1p28, 0x1p26);
    const auto axes = kdop_axes<3>(k);
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const double along = axes[i][0] * offset[0] + axes[i][1] * offset[1] + axes[i][2] * offset[2];
      moved.min[i] += along, moved.max[i] += along;
    }
    CHECK(measure(moved) == doctest::Approx(measure(kdop)).epsilon(1e-6));
    for (const double scale : {0x1p-100, 0x1p100}) {
      Kdop<double, 3> scaled = kdop;
      for (std::size_t i = 0; i < axes.size(); ++i) scaled.min[i] *= scale, scaled.max[i] *= scale;
      CHECK(measure(scaled) == measure(kdop) * scale * scale * scale);
    }
    Kdop<double, 3> huge = kdop;
    for (std::size_t i = 0; i < axes.size(); ++i) huge.min[i] *= 0x1p508, huge.max[i] *= 0x1p508;
    CHECK(std::isinf(measure(huge)));
  }
}

TEST_CASE("flat, empty and single-point k-DOPs hold nothing") {
  for (const int k : {6, 14, 18, 26}) {
    CHECK(measure(Kdop<double, 3>{.k = k}) == 0);
    Kdop<double, 3> flat = around_unit_box<double, 3>(k, 1);
    flat.min[2] = flat.max[2] = 0.5;
    CHECK(measure(flat) < 1e-14);
    Kdop<double, 3> none = around_unit_box<double, 3>(k, 1);
    none.min[0] = 2, none.max[0] = 1;
    CHECK(measure(none) == 0);
  }
  CHECK(measure(Kdop<double, 2>{.k = 8}) == 0);
  Kdop<double, 2> none = around_unit_box<double, 2>(8, 1);
  none.max[2] = -3, none.min[2] = -4;
  CHECK(measure(none) == 0);
}
