// What a fit in float says of the points before they were rounded.
#include "fit/rounded.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/point_clouds.hpp"
#include "fit/catalogue.hpp"
#include "geometry/convert.hpp"
#include "query/contain/contains.hpp"
#include "query/contain/contains_hull.hpp"

using namespace snug;

namespace {

template <int Dim>
void check_cloud(const test::Cloud<double, Dim>& cloud) {
  test::Cloud<float, Dim> floats;
  std::vector<Vector<double, 3>> given;
  double by = 0;
  for (const auto& p : cloud) {
    floats.push_back(p.template cast<float>());
    given.push_back(Vector<double, 3>::Zero());
    given.back().template head<Dim>() = p;
    by = std::max(by, scaled_norm<double, Dim>(floats.back().template cast<double>() - p));
  }
  const AnyPointSet points = test::set_of<float, Dim>(floats);
  for (const fit::Algorithm& algorithm : fit::algorithms()) {
    if (!fit::takes(algorithm, Dim) || fit::count_of(points) > algorithm.max_points) continue;
    INFO(algorithm.volume << " " << algorithm.name << ", dim " << Dim);
    const fit::Watched run = algorithm.watch(points, {}, {});
    const fit::Rounded rounded = fit::rounded(run.result, run.certificate, points, given);
    CHECK(rounded.by == by);
    double most = 0;
    std::visit(
        [&](const auto& own) {
          for (const auto& p : cloud) most = std::max(most, query::outside_by(converted<double, Dim>(own), p));
        },
        run.result.volume);
    CHECK(rounded.max_outside == doctest::Approx(most).epsilon(1e-6));
    CHECK(rounded.max_outside <= (by + run.certificate.max_outside) * (1 + 1e-9));
  }
}

}  // namespace

TEST_CASE("points that float moves far lie as far outside as each is tested to, of every algorithm") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    auto space = test::generated<double, 3>("gaussian", 30, seed);
    auto plane = test::generated<double, 2>("gaussian", 30, seed);
    for (auto& p : space) p += Vector<double, 3>(1e7, -1e6, 3e5);
    for (auto& p : plane) p += Vector<double, 2>(1e7, -1e6);
    check_cloud<3>(space);
    check_cloud<2>(plane);
  }
}
