#include "geometry/sphere.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "core/exact.hpp"
#include "core/point_clouds.hpp"
#include "geometry/tolerance.hpp"

using namespace snug;
using exact::Rational;

TEST_CASE_TEMPLATE("the side of a sphere is what rational arithmetic says, however grazing", Scalar, float, double) {
  Random random(7);
  int on = 0, in = 0, out = 0;
  for (int round = 0; round < 3000; ++round) {
    Vector<Scalar, 3> point, center;
    for (int i = 0; i < 3; ++i) {
      point[i] = static_cast<Scalar>(static_cast<int>(random.below(9)) - 4);
      center[i] = static_cast<Scalar>(static_cast<int>(random.below(9)) - 4);
    }
    Sphere<Scalar, 3> sphere{center, (point - center).norm()};
    if (round % 3 == 1) sphere.radius = std::nextafter(sphere.radius, Scalar(0));
    if (round % 3 == 2) sphere.radius = std::nextafter(sphere.radius, Scalar(100));
    const auto radius = Rational(static_cast<double>(sphere.radius));
    const int expected = (exact::squared_distance<Scalar, 3>(point, center) - radius * radius).sign();
    CHECK(side_of_sphere(point, sphere) == expected);
    (expected == 0 ? on : expected < 0 ? in : out) += 1;
  }
  CHECK(on > 80);
  CHECK(in > 100);
  CHECK(out > 100);
}

TEST_CASE("the side of a sphere is what rational arithmetic says, in the last of 106 bits") {
  const auto expected = [](const Vector<double, 3>& point, const Sphere<double, 3>& sphere) {
    return (exact::squared_distance<double, 3>(point, sphere.center) -
            Rational(sphere.radius) * Rational(sphere.radius))
        .sign();
  };
  Random random(11);
  std::array<int, 3> seen{};
  for (int round = 0; round < 4000; ++round) {
    const double scale = std::ldexp(1.0, 10 * (static_cast<int>(random.below(97)) - 48));
    const auto any = [&] { return (random.unit() - 0.5) * scale; };
    Vector<double, 3> center, d;
    for (int i = 0; i < 3; ++i) center[i] = any();
    for (int i = 0; i < 3; ++i) d[i] = any();
    Sphere<double, 3> sphere{center, d.norm()};
    Vector<double, 3> point = center + d;
    if (round % 4 == 1) {  // just on it
      const double k = std::floor(random.unit() * 0x1p45);
      center.setZero();
      point = {3 * k * scale, -4 * k * scale, 12 * k * scale};
      sphere = {center, 13 * k * scale};
    }
    if (round % 4 == 2) {  // nearer to it than the last of those bits: (r - t)^2 + s^2, where s^2 is about 2rt - t^2
      const double r = sphere.radius, t = std::ldexp(r * random.unit(), -53 - static_cast<int>(random.below(8)));
      center = {t, 0, 0};
      point = {r, std::sqrt(2 * r * t), 0};
      if (round % 8 == 2) point[1] = std::nextafter(point[1], 0.0);
      sphere.center = center;
    }
    if (round % 4 == 3) sphere.radius = std::nextafter(sphere.radius, round % 8 == 3 ? 0.0 : 1e300);
    const int side = expected(point, sphere);
    REQUIRE(side_of_sphere(point, sphere) == side);
    ++seen[side + 1];
  }
  for (const int count : seen) CHECK(count > 800);
}

TEST_CASE_TEMPLATE("a computed squared distance stays within its bound", Scalar, float, double) {
  Random random(8);
  Rational worst = 0;
  for (int round = 0; round < 2000; ++round) {
    Vector<Scalar, 3> a, b;
    for (int i = 0; i < 3; ++i) {
      a[i] = static_cast<Scalar>(random.between(-1, 1));
      b[i] = static_cast<Scalar>(random.between(-1, 1));
    }
    const auto exact = exact::squared_distance<Scalar, 3>(a, b);
    const Rational error = abs(Rational(static_cast<double>((a - b).squaredNorm())) - exact) / exact;
    worst = std::max(worst, error);
  }
  CHECK(worst < Rational(static_cast<double>(tolerance::kSquaredDistance<Scalar>)));
  CHECK(worst > Rational(static_cast<double>(tolerance::kRoundoff<Scalar>)));  // the bound is not idle
}

TEST_CASE_TEMPLATE("an enclosing radius holds every point exactly and is at most a few ulps too large", Scalar, float,
                   double) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const auto& cloud : test::degenerate_clouds<Scalar, 3>(seed, 40)) {
      CAPTURE(cloud.name);
      const auto set = test::set_of<Scalar, 3>(cloud.points);
      const Vector<Scalar, 3> center = set[0] / 2;
      const Scalar found = enclosing_radius(center, set.span(), farthest_points(center, set.span()));
      Rational most = 0;
      for (const auto& p : cloud.points) {
        CHECK(side_of_sphere(p, Sphere<Scalar, 3>{center, found}) <= 0);
        most = std::max(most, exact::squared_distance<Scalar, 3>(p, center));
      }
      const auto below = Rational(static_cast<double>(found * (1 - 8 * tolerance::kRoundoff<Scalar>)));
      CHECK((most == 0 ? found == 0 : below * below < most));
    }
  }
}

TEST_CASE("with too many points near the boundary the radius is widened by its bound, and holds them all") {
  const auto points = test::generated<double, 3>("sphere", 20000, 3);
  const auto set = test::set_of<double, 3>(points);
  Sphere<double, 3> sphere;
  sphere.radius = enclosing_radius(sphere.center, set.span(), farthest_points(sphere.center, set.span()));
  for (const auto& p : points) REQUIRE(side_of_sphere(p, sphere) <= 0);
  CHECK(sphere.radius < 1 + 1e-14);
}

TEST_CASE("the farthest point is named, overall and of each block") {
  auto points = test::generated<double, 2>("ball", 5000, 1);
  points[4321] = {3, 4};
  const auto far = farthest_points<double, 2>({0, 0}, test::set_of<double, 2>(points).span());
  CHECK(far.overall.point == 4321);
  CHECK(far.overall.square == 25);
  CHECK(far.block == 128);
  REQUIRE(far.of_block.size() == 40);
  CHECK(far.of_block[4321 / 128].point == 4321);
  CHECK(far.of_block[0].point < far.block);
}
