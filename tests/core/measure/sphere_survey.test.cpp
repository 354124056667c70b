// A survey counts what the test of a sphere says of random spheres, and how many of those that it keeps touch nothing.
#include "measure/sphere_survey.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>

#include "geometry/frustum_corners.hpp"
#include "query/cull/classify.hpp"
#include "query/distance/gjk.hpp"

using namespace snug;
using cost::SurveyCounts;

namespace {

/// The cube from -1 to 1, of which distances are simple.
template <int Dim>
Vector<double, Dim> beyond_cube(const Vector<double, Dim>& p) {
  return (p.cwiseAbs().array() - 1).max(0).matrix();
}

template <int Dim>
SurveyCounts survey_of(const Frustum<double, Dim>& frustum, double radius, std::int64_t spheres, std::uint64_t seed,
                       std::int64_t portion) {
  auto survey = cost::SphereSurvey<Dim>::make(frustum, radius, seed);
  REQUIRE(survey.has_value());
  for (std::int64_t left = spheres; left > 0; left -= portion) survey->run(std::min(portion, left));
  return survey->counts();
}

/// The same counts, by the cube's own geometry.
template <int Dim>
SurveyCounts counted_around_cube(double radius, std::int64_t spheres, std::uint64_t seed) {
  Random random(seed);
  SurveyCounts counts;
  for (std::int64_t i = 0; i < spheres; ++i) {
    Vector<double, Dim> center;
    for (int axis = 0; axis < Dim; ++axis) center[axis] = random.between(-1 - radius, 1 + radius);
    ++counts.spheres;
    const auto out = (center.cwiseAbs().array() - 1).eval();
    if (out.maxCoeff() > radius) ++counts.outside;
    else if (out.maxCoeff() <= -radius) ++counts.inside;
    else ++counts.intersecting;
    if (out.maxCoeff() > radius || beyond_cube<Dim>(center).norm() <= radius) continue;
    const auto crossed = (out > -radius).count();
    ++(crossed == 2 ? counts.false_at_two : counts.false_at_more);
  }
  return counts;
}

}  // namespace

TEST_CASE("a survey around a cube counts what the cube's own geometry says") {
  for (const double radius : {0.0, 0.1, 0.6, 0.9}) {
    CAPTURE(radius);
    CHECK(survey_of<3>({}, radius, 40'000, 5, 40'000) == counted_around_cube<3>(radius, 40'000, 5));
    CHECK(survey_of<2>({}, radius, 40'000, 5, 40'000) == counted_around_cube<2>(radius, 40'000, 5));
  }
  CHECK(counted_around_cube<3>(0.6, 40'000, 5).false_at_two > 100);
  CHECK(counted_around_cube<3>(0.6, 40'000, 5).false_at_more > 100);
}

TEST_CASE("a survey gives the same counts in whatever portions it is run, and others by another seed") {
  FrustumCamera<double, 3> camera{.near = 0.4, .far = 2};
  camera.half_tangents = {0.8, 0.5};
  const auto frustum = *frustum_of_camera(camera);
  const SurveyCounts all = survey_of<3>(frustum, 0.3, 30'000, 1, 30'000);
  CHECK(all == survey_of<3>(frustum, 0.3, 30'000, 1, 777));
  CHECK_FALSE(all == survey_of<3>(frustum, 0.3, 30'000, 2, 30'000));
  CHECK(all.spheres == 30'000);
  CHECK(all.inside + all.intersecting + all.outside == all.spheres);
  CHECK(all.false_positives() > 0);
  CHECK(all.false_positives() < all.intersecting / 5);
}

TEST_CASE("a sphere that crosses a single plane of a frustum touches it") {
  FrustumCamera<double, 3> camera{.near = 0.4, .far = 2};
  camera.half_tangents = {1.3, 0.4};
  const auto frustum = *frustum_of_camera(camera);
  const auto corners = corners_of(frustum);
  REQUIRE(corners.has_value());
  ConvexHull<double, 3> hull;
  hull.vertices.assign(corners->begin(), corners->end());
  Random random(8);
  int crossing = 0;
  for (int i = 0; i < 20'000; ++i) {
    Sphere<double, 3> sphere{{}, 0.15};
    for (int axis = 0; axis < 3; ++axis) sphere.center[axis] = random.between(-3, 3);
    const query::CullResult result = query::classify(frustum, sphere);
    if (result.verdict != query::Culling::kIntersecting || std::popcount(result.crossing) != 1) continue;
    ++crossing;
    const auto apart = query::gjk(Volume<double, 3>(sphere), Volume<double, 3>(hull));
    CHECK((!apart || apart->overlap));
  }
  CHECK(crossing > 200);
}

TEST_CASE("planes that do not meet in vertices have no survey") {
  auto planes = Frustum<double, 3>().planes();
  planes[1] = planes[0];
  CHECK_FALSE(cost::SphereSurvey<3>::make(*Frustum<double, 3>::make(planes), 0.1, 1).has_value());
}
