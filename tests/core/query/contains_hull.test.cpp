// Whether a hull holds a point, against the definition in rational arithmetic.
#include "query/contain/contains_hull.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "core/exact_hull.hpp"
#include "core/point_clouds.hpp"
#include "fit/hull/quickhull.hpp"

using namespace snug;

namespace {

struct HullSeen {
  int inside = 0, outside = 0, flat = 0;
};

/// Vertices, points inside, on edges and faces, those a last digit off, and what lies well outside.
template <class Scalar, int Dim>
test::Cloud<Scalar, Dim> questions(const test::Cloud<Scalar, Dim>& cloud, Random& random) {
  test::Cloud<Scalar, Dim> asked;
  const auto any = [&] { return cloud[random.below(static_cast<std::uint32_t>(cloud.size()))]; };
  for (int i = 0; i < 6; ++i) {
    const Vector<Scalar, Dim> p = any(), q = any(), r = any();
    asked.push_back(p);
    asked.push_back(p / 2 + q / 2);
    asked.push_back(p + (q - p) / 4 + (r - p) / 4);
    asked.push_back(p + (p - q));
  }
  for (std::size_t i = 0; i < 24; ++i) {
    Vector<Scalar, Dim> p = asked[i];
    const int axis = static_cast<int>(random.below(Dim));
    p[axis] = std::nextafter(p[axis], random.below(2) == 0 ? -std::numeric_limits<Scalar>::max()
                                                           : std::numeric_limits<Scalar>::max());
    asked.push_back(p);
  }
  return asked;
}

template <class Scalar, int Dim>
void check_hull(const std::string& name, const test::Cloud<Scalar, Dim>& cloud, Random& random, HullSeen& seen) {
  INFO(name << ", " << cloud.size() << " points, dim " << Dim << ", " << sizeof(Scalar) << " bytes");
  const auto hull = fit::quickhull(test::set_of<Scalar, Dim>(cloud).span()).volume;
  double largest = 0;
  for (const auto& p : cloud) largest = std::max(largest, static_cast<double>(p.cwiseAbs().maxCoeff()));
  for (const auto& p : questions(cloud, random)) {
    const bool held = exact::in_hull(p, hull.vertices);
    CHECK(query::contains(hull, p) == held);
    const double outside = query::outside_by(hull, p);
    CHECK((outside == 0) == held);
    // No farther than the nearest vertex, but for rounding.
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& v : hull.vertices)
      nearest = std::min(nearest, scaled_norm<double, Dim>(p.template cast<double>() - v.template cast<double>()));
    CHECK(outside <= nearest + 0x1p-48 * (largest + nearest) + 8 * std::numeric_limits<double>::denorm_min());
    (held ? seen.inside : seen.outside) += 1;
    seen.flat += hull.affine_dim < Dim && held;
  }
}

}  // namespace

TEST_CASE_TEMPLATE("a hull holds a point just where it is a convex combination of the vertices", Scalar, float,
                   double) {
  Random random(11);
  HullSeen seen;
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    for (const int n : {2, 6, 12})
      for (const auto& [name, points] : test::degenerate_clouds<Scalar, 2>(seed, n))
        check_hull<Scalar, 2>(name, points, random, seen);
    for (const int n : {2, 7})
      for (const auto& [name, points] : test::degenerate_clouds<Scalar, 3>(seed, n))
        check_hull<Scalar, 3>(name, points, random, seen);
  }
  CHECK(seen.inside > 300);
  CHECK(seen.outside > 300);
  CHECK(seen.flat > 100);
}

TEST_CASE("how far outside a cube, a square, a segment and a point") {
  test::Cloud<double, 3> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({i & 1 ? 1.0 : 0.0, i & 2 ? 1.0 : 0.0, i & 4 ? 1.0 : 0.0});
  const auto cube = fit::quickhull(test::set_of<double, 3>(corners).span()).volume;
  CHECK(query::outside_by(cube, {0.5, 0.5, 0.5}) == 0);
  CHECK(query::outside_by(cube, {1, 1, 1}) == 0);
  CHECK(query::outside_by(cube, {3, 0.5, 0.5}) == doctest::Approx(2));
  CHECK(query::outside_by(cube, {3, 4, 0.5}) == doctest::Approx(3));
  corners.resize(4);
  const auto square = fit::quickhull(test::set_of<double, 3>(corners).span()).volume;
  CHECK(query::outside_by(square, {0.5, 0.5, 0}) == 0);
  CHECK(query::outside_by(square, {0.5, 0.5, -2}) == doctest::Approx(2));
  CHECK(query::outside_by(square, {0.5, 3, 0}) == doctest::Approx(2));
  corners.resize(2);
  const auto segment = fit::quickhull(test::set_of<double, 3>(corners).span()).volume;
  CHECK(query::outside_by(segment, {0.25, 0, 0}) == 0);
  CHECK(query::outside_by(segment, {3, 0, 0}) == doctest::Approx(2));
  CHECK(query::outside_by(segment, {0.5, 3, 4}) == doctest::Approx(5));
  corners.resize(1);
  const auto place = fit::quickhull(test::set_of<double, 3>(corners).span()).volume;
  CHECK(query::outside_by(place, {0, 0, 0}) == 0);
  CHECK(query::outside_by(place, {0, 3, 4}) == doctest::Approx(5));
}

TEST_CASE("a polygon of many corners holds its points, found by halving") {
  test::Cloud<double, 2> parabola;
  for (int i = -500; i <= 500; ++i) parabola.push_back({double(i), double(i) * i});
  const auto hull = fit::quickhull(test::set_of<double, 2>(parabola).span()).volume;
  REQUIRE(hull.vertices.size() == 1001);
  for (int i = -500; i < 500; ++i) {
    CHECK(query::contains(hull, parabola[i + 500]));
    const double middle = i + 0.5, chord = (double(i) * i + double(i + 1) * (i + 1)) / 2;
    CHECK(query::contains(hull, {middle, chord}));
    CHECK_FALSE(query::contains(hull, {middle, std::nextafter(chord, -1.0)}));
  }
  CHECK_FALSE(query::contains(hull, {0, 250001}));
  CHECK(query::contains(hull, {0, 250000}));
}
