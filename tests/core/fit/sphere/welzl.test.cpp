// Welzl's algorithm and whatever else finds the smallest ball, against an oracle in rational arithmetic and results
// worked out by hand.
#include <doctest/doctest.h>

#include "core/exact.hpp"
#include "core/point_clouds.hpp"
#include "fit/catalogue.hpp"
#include "fit/sphere/certify_sphere.hpp"
#include "geometry/tolerance.hpp"

using namespace snug;
using exact::Rational;

namespace {

const fit::Algorithm& welzl() { return *fit::find_algorithm("sphere", "welzl"); }

/// Whether radius is at least the exact one, and at most it plus what certificates allow.
template <class Scalar, int Dim>
void check_against_brute_force(const std::string& name, const test::Cloud<Scalar, Dim>& points) {
  INFO(name << ", " << points.size() << " points, dim " << Dim << ", " << sizeof(Scalar) << " bytes");
  const Rational exact = exact::smallest_square(points);
  const auto set = test::set_of<Scalar, Dim>(points);
  for (const char* algorithm : {"welzl", "pivot", "brute_force", "welzl_recursive"}) {
    CAPTURE(algorithm);
    const auto fit = fit::find_algorithm("sphere", algorithm)->fit(set, {});
    const Rational radius(ball_of(fit).radius);
    CHECK(radius * radius >= exact);
    double size = ball_of(fit).radius;
    for (const auto& p : points)
      size = std::max(size, static_cast<double>(p.cwiseAbs().maxCoeff()) + ball_of(fit).radius);
    const Rational slack(tolerance::kOptimalityRoundoffs * static_cast<double>(tolerance::kRoundoff<Scalar>) * size);
    const Rational lower = radius - slack;
    CHECK((lower <= 0 || lower * lower <= exact));
  }
}

}  // namespace

TEST_CASE_TEMPLATE("the smallest ball is as small as the exact one on degenerate clouds", Scalar, float, double) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    for (const auto& [name, points] : test::degenerate_clouds<Scalar, 2>(seed, 7))
      check_against_brute_force<Scalar, 2>(name, points);
    for (const auto& [name, points] : test::degenerate_clouds<Scalar, 3>(seed, 6))
      check_against_brute_force<Scalar, 3>(name, points);
  }
}

TEST_CASE("the smallest ball is as small as the exact one on random clouds") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    for (const char* kind : {"cube", "gaussian", "sphere", "stick"}) {
      check_against_brute_force<double, 2>(kind, test::generated<double, 2>(kind, 9, seed));
      check_against_brute_force<double, 3>(kind, test::generated<double, 3>(kind, 7, seed));
    }
}

TEST_CASE("Welzl's recursion and pivoting end with the same ball, and prove it, however many points there are") {
  for (const char* kind : {"gaussian", "cube", "ball", "sphere", "lattice", "clusters", "line"})
    for (const int n : {1, 2, 14, 256, 257, 3000}) {
      const auto set = test::set_of<double, 3>(test::generated<double, 3>(kind, n, 5));
      const auto pivot = fit::find_algorithm("sphere", "pivot")->watch(set, {}, {});
      const double radius = ball_of(pivot.result).radius;
      CHECK(pivot.certificate.optimal == true);
      for (const std::uint64_t seed : {1, 2, 3}) {
        CAPTURE(kind);
        CAPTURE(n);
        CAPTURE(seed);
        const auto run = welzl().watch(set, {seed}, {});
        CHECK(run.certificate.contains);
        CHECK(run.certificate.optimal == true);
        CHECK(std::abs(ball_of(run.result).radius - radius) <= 1e-14 * radius);
      }
    }
}

TEST_CASE("the optimum is worked out by pivoting; in the catalogue it stands between Welzl and brute force") {
  CHECK(fit::exact_algorithm("sphere")->name == "pivot");
  const auto rows = fit::algorithms_of("sphere");
  REQUIRE(rows.size() == 11);
  CHECK(rows[4].name == "welzl");
  CHECK(rows[5].name == "pivot");
  CHECK(rows[6].name == "brute_force");
}

TEST_CASE("a regular tetrahedron's smallest ball has its four corners as support") {
  const auto set = test::set_of<double, 3>({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
  const auto run = welzl().record(set, {});
  CHECK(ball_of(run.result).radius == doctest::Approx(std::sqrt(3.0)).epsilon(1e-15));
  CHECK(ball_of(run.result).center.norm() < 1e-15);
  CHECK(run.result.support.size() == 4);
}

TEST_CASE("an obtuse triangle is held by its longest side") {
  const auto run = welzl().record(test::set_of<double, 2>({{-2, 0}, {2, 0}, {0, 1}}), {});
  CHECK(ball_of(run.result).radius == 2);
  CHECK(run.result.support.size() == 2);
}

TEST_CASE("a certificate does not call a ball smallest that is not, nor holding that does not hold") {
  const auto set = *PointSet<double, 2>::make({{-1, 0}, {1, 0}, {0, 0.5}});
  using Ball = fit::Fit<Sphere<double, 2>>;
  CHECK(*certify(Ball{{{0, 0}, 1}, {0, 1}}, set.span(), true).optimal);
  const auto larger = certify(Ball{{{0, 0}, 1.0000001}, {0, 1}}, set.span(), true);
  CHECK(larger.contains);
  CHECK_FALSE(*larger.optimal);
  CHECK_FALSE(larger.on_boundary);
  const auto smaller = certify(Ball{{{0, 0}, std::nextafter(1.0, 0.0)}, {0, 1}}, set.span(), true);
  CHECK_FALSE(smaller.contains);
  CHECK_FALSE(*smaller.optimal);
  CHECK(smaller.outside == 2);
  CHECK(smaller.max_outside > 0);
  // The ball of the two lower points with the wrong support: its bound proves nothing.
  CHECK_FALSE(*certify(Ball{{{0, 0}, 1}, {2}}, set.span(), true).optimal);
}

TEST_CASE("the order of its points changes the smallest ball by no more than rounding") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    auto points = test::generated<double, 3>("gaussian", 60, seed);
    const double radius = ball_of(welzl().fit(test::set_of<double, 3>(points), {})).radius;
    Random random(seed);
    for (std::size_t i = points.size() - 1; i > 0; --i)
      std::swap(points[i], points[random.below(static_cast<std::uint32_t>(i + 1))]);
    CHECK(ball_of(welzl().fit(test::set_of<double, 3>(points), {})).radius == doctest::Approx(radius).epsilon(1e-15));
  }
}

TEST_CASE("Welzl holds no more points on the boundary than Dim + 1, however many there are") {
  for (const int n : {10, 100, 1000, 20000}) {
    const auto run = fit::find_algorithm("sphere", "welzl")
                         ->record(test::set_of<double, 3>(test::generated<double, 3>("ball", n, 2)), {});
    int deepest = 0;
    for (const auto& entry : run.steps)
      if (const auto* forced = std::get_if<fit::BoundaryForced>(&entry.step.fact))
        deepest = std::max(deepest, forced->depth);
    CHECK(deepest >= 2);
    CHECK(deepest <= 4);
  }
}

TEST_CASE("Welzl touches each of a hundred thousand points a few times; pivoting passes over them a few times") {
  constexpr int kMany = 100'000;
  const auto touched = [](const char* algorithm, const AnyPointSet& set) {
    const auto run = fit::find_algorithm("sphere", algorithm)->watch(set, {}, {});
    CHECK(run.certificate.optimal == true);
    return run.counts[static_cast<std::size_t>(Operation::kPointsTouched)];
  };
  for (const char* kind : {"gaussian", "sphere", "cube"}) {
    const AnyPointSet set = test::set_of<double, 3>(test::generated<double, 3>(kind, kMany, 3));
    CHECK(touched("welzl", set) < 40 * kMany);
    CHECK(touched("pivot", set) < 20 * kMany);
  }
}
