// Textbook algorithms: they promise little, and what they promise they keep.
#include <array>
#include <cmath>

#include "core/point_clouds.hpp"
#include "fit/catalogue.hpp"
#include "fit/sphere/rounded_circumsphere.hpp"
#include "fit/sphere/welzl_naive.hpp"

using namespace snug;

namespace {

/// Points with whole coordinates from 0 to side - 1, some of them several times.
template <class Scalar, int Dim>
test::Cloud<Scalar, Dim> on_lattice(int n, std::uint32_t side, std::uint64_t seed) {
  Random random(seed);
  test::Cloud<Scalar, Dim> points(n);
  for (auto& point : points)
    for (int axis = 0; axis < Dim; ++axis) point[axis] = static_cast<Scalar>(random.below(side));
  return points;
}

constexpr std::array kNaive{"welzl_naive", "welzl_epsilon"};

int count_of(const fit::Recording& run, std::string_view fact) {
  int count = 0;
  for (const auto& entry : run.steps) count += fit::name_of(entry.step) == fact ? 1 : 0;
  return count;
}

bool is_finite(const fit::Result& result) {
  return ball_of(result).center.allFinite() && std::isfinite(ball_of(result).radius);
}

template <class Scalar, int Dim>
void check_ends(const test::Cloud<Scalar, Dim>& points) {
  const AnyPointSet set = test::set_of<Scalar, Dim>(points);
  for (const char* name : kNaive) {
    const fit::Algorithm& naive = *fit::find_algorithm("sphere", name);
    const fit::Recording run = naive.record(set, {});
    CHECK(is_finite(run.result));
    CHECK(count_of(run, "point_examined") <= fit::kMostTestsPerPoint * (fit::count_of(set) + 1));
    CHECK(fit::name_of(run.steps.back().step) == "finished");
    CHECK(naive.fit(set, {}).support == run.result.support);
  }
}

}  // namespace

TEST_CASE_TEMPLATE("naive algorithms end with finite numbers, whatever the cloud", Scalar, float, double) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    for (const int n : {1, 2, 5, 14}) {
      for (const auto& [name, points] : test::degenerate_clouds<Scalar, 2>(seed, n)) check_ends<Scalar, 2>(points);
      for (const auto& [name, points] : test::degenerate_clouds<Scalar, 3>(seed, n)) check_ends<Scalar, 3>(points);
    }
}

TEST_CASE_TEMPLATE("on a lattice the naive algorithm leaves points outside, and the careful one none", Scalar, float,
                   double) {
  int wrong = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const AnyPointSet set = test::set_of<Scalar, 2>(on_lattice<Scalar, 2>(20, 5, seed));
    wrong += fit::find_algorithm("sphere", "welzl_naive")->record(set, {seed}).certificate.contains ? 0 : 1;
    CHECK(fit::find_algorithm("sphere", "welzl")->record(set, {seed}).certificate.contains);
  }
  CHECK(wrong > 0);
  CHECK(wrong < 40);
}

TEST_CASE("where a naive run would not end in time, it is stopped and says so") {
  int stopped = 0, failed = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const AnyPointSet set = test::set_of<double, 3>(on_lattice<double, 3>(200, 3, seed));
    const fit::Recording run = fit::find_algorithm("sphere", "welzl_naive")->record(set, {seed});
    failed += count_of(run, "circumsphere_failed");
    if (count_of(run, "tests_exhausted") == 0) continue;
    ++stopped;
    CHECK(count_of(run, "point_examined") == fit::kMostTestsPerPoint * 201);
  }
  CHECK(stopped > 0);
  CHECK(failed > 0);
}

TEST_CASE(
    "an absolute epsilon suits one size of points: far smaller ones it leaves outside, far larger ones it ignores") {
  const auto worst_of = [](double scale) {
    double worst = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const AnyPointSet set = test::set_of<double, 2>(test::generated<double, 2>("ball", 12, seed, scale));
      const fit::Recording run = fit::find_algorithm("sphere", "welzl_epsilon")->record(set, {seed});
      worst = std::max(worst, run.certificate.max_outside / ball_of(run.result).radius);
    }
    return worst;
  };
  CHECK(worst_of(1) < 2e-6);
  CHECK(worst_of(1e-6) > 0.05);
  CHECK(worst_of(1e6) < 1e-11);
}

TEST_CASE_TEMPLATE("the textbook's circumsphere is exact where its numbers are", Scalar, float, double) {
  const auto plane = test::set_of<Scalar, 2>({{0, 0}, {4, 0}, {0, 4}, {2, 0}});
  const auto sphere = fit::rounded_circumsphere(plane.span(), {0, 1, 2});
  REQUIRE(sphere);
  CHECK(sphere->center == Vector<Scalar, 2>(2, 2));
  CHECK(sphere->radius == std::sqrt(Scalar(8)));
  CHECK_FALSE(fit::rounded_circumsphere(plane.span(), {0, 1, 3}));

  const auto space = test::set_of<Scalar, 3>({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}});
  CHECK(fit::rounded_circumsphere(space.span(), {0, 1, 2, 3})->center == Vector<Scalar, 3>(1, 1, 1));
  CHECK(fit::rounded_circumsphere(space.span(), {0, 1, 2})->center == Vector<Scalar, 3>(1, 1, 0));
}

TEST_CASE("naive algorithms are marked, guarantee nothing, and are never the reference") {
  int count = 0;
  for (const fit::Algorithm& algorithm : fit::algorithms()) {
    if (!algorithm.naive) continue;
    ++count;
    CHECK_FALSE(algorithm.exact);
    CHECK(algorithm.title.ends_with("(naive)"));
    CHECK(fit::exact_algorithm(algorithm.volume) != &algorithm);
  }
  CHECK(count == 5);  // two of spheres, two of hulls, one of oriented boxes
}
