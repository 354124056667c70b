// Balls and points against a frustum: their tests, their handles, and what the lesson about spheres counts.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "geometry/random.hpp"
#include "lesson/subjects/frustum/frustum.hpp"

using namespace snug;
using namespace snug::lesson;
using query::Culling;
using V3 = Vector<double, 3>;

namespace {

/// The frustum of the lesson frustum-sphere, in 3-D as high as it is wide, and a body at a place.
BoxPair pair_of(int dim, Form form, const V3& center, double radius) {
  BoxPair pair{.dim = dim, .form = form, .taper = 0.3};
  V3 half = V3::Zero();
  half.head(dim).setConstant(radius);
  pair.boxes[0] = {center, Matrix<double, 3>::Identity(), half};
  pair.boxes[1] = {{0.55, 0, 0}, Matrix<double, 3>::Identity(), {1.05, 1.15, dim == 3 ? 1.15 : 0.0}};
  pair.boxes[1] = turned_by(pair.boxes[1], 2, -4 * 3.14159265358979323846 / 180);
  return pair;
}

V3 random_place(Random& random, int dim) {
  V3 place = V3::Zero();
  for (int axis = 0; axis < dim; ++axis) place[axis] = random.between(-2, 3);
  return place;
}

}  // namespace

TEST_CASE("a ball outside shares no point with the frustum, and one inside sticks out of no plane") {
  Random random(3);
  for (const int dim : {2, 3}) {
    int seen[3] = {};
    for (int i = 0; i < 3000; ++i) {
      const BoxPair pair = pair_of(dim, Form::kBall, random_place(random, dim), random.between(0, 0.6));
      const Culling says = verdict_of("grown_planes", pair);
      ++seen[static_cast<int>(says)];
      if (says == Culling::kOutside) CHECK(share_a_point(pair) == false);
      if (says == Culling::kInside) CHECK(share_a_point(pair) == true);
      for (const auto& entry : record_frustum("grown_planes", pair))
        if (const auto* plane = std::get_if<query::PlaneTested<double, 3>>(&entry.step.fact)) {
          CHECK(plane->p_distance - plane->n_distance == doctest::Approx(2 * pair.boxes[0].half_extents[0]));
          if (says == Culling::kInside) CHECK(plane->p_distance <= 0);
        }
    }
    for (const int count : seen) CHECK(count > 20);
  }
}

TEST_CASE("the slide's sign loses just the balls that stick out of a plane") {
  Random random(4);
  int lost = 0;
  for (int i = 0; i < 3000; ++i) {
    const BoxPair pair = pair_of(2, Form::kBall, random_place(random, 2), random.between(0, 0.6));
    const bool sticks_out = verdict_of("grown_planes", pair) != Culling::kInside;
    CHECK((verdict_of("wrong_sign", pair) == Culling::kOutside) == sticks_out);
    const FrustumSubject subject(pair, 1);
    CHECK(subject.reaches("wrong_sign") == (sticks_out && share_a_point(pair) == true));
    CHECK_FALSE(subject.reaches("corners_outside"));
    lost += subject.reaches("wrong_sign") ? 1 : 0;
  }
  CHECK(lost > 300);
}

TEST_CASE("a point is a ball of radius 0") {
  Random random(5);
  for (const int dim : {2, 3})
    for (int i = 0; i < 1000; ++i) {
      const V3 place = random_place(random, dim);
      const BoxPair point = pair_of(dim, Form::kPoint, place, 0), ball = pair_of(dim, Form::kBall, place, 0);
      CHECK(verdict_of("half_spaces", point) == verdict_of("grown_planes", ball));
      CHECK(share_a_point(point) == (verdict_of("half_spaces", point) != Culling::kOutside));
    }
}

TEST_CASE("the numbers of all planes are those that the test finds, plane by plane") {
  Random random(6);
  for (const int dim : {2, 3})
    for (int i = 0; i < 300; ++i) {
      const BoxPair pair = pair_of(dim, Form::kPoint, random_place(random, dim), 0);
      const std::vector<double> all = center_distances(pair);
      REQUIRE(all.size() == static_cast<std::size_t>(planes_of_frustum(dim)));
      for (const auto& entry : record_frustum("half_spaces", pair))
        if (const auto* plane = std::get_if<query::PlaneTested<double, 3>>(&entry.step.fact))
          CHECK(all[plane->plane] == doctest::Approx(center_distance(*plane)));
      const bool outside = std::any_of(all.begin(), all.end(), [](double one) { return one > 0; });
      CHECK((verdict_of("half_spaces", pair) == Culling::kOutside) == outside);
    }
  BoxPair behind = pair_of(3, Form::kPoint, V3(-2, 0, 0), 0);  // straight behind the camera
  const std::vector<double> all = center_distances(behind);
  CHECK(std::count_if(all.begin(), all.end(), [](double one) { return one > 0; }) == 5);
  behind.boxes[1].half_extents[0] = 0;
  CHECK(center_distances(behind).empty());
}

TEST_CASE("a ball has its centre and its radius to be dragged, a point itself") {
  FrustumSubject ball(pair_of(2, Form::kBall, {0.3, 0.2, 0}, 0.25), 1);
  CHECK(ball.name_of(0) == "Circle");
  CHECK(ball.name_of(1) == "Circle radius");
  CHECK(ball.name_of(2) == "Frustum");
  CHECK(ball.size() == 2 + places_of_box(2));
  CHECK((ball.at(1) - V3(0.55, 0.2, 0)).norm() < 1e-15);
  REQUIRE(ball.move(1, {0.3, 0.7, 0}));
  CHECK(ball.boxes().boxes[0].half_extents[0] == doctest::Approx(0.5));
  REQUIRE(ball.move(0, {0, 0, 0}));
  CHECK(ball.boxes().boxes[0].half_extents[0] == doctest::Approx(0.5));
  const std::array<double, 1> radius{0.125};
  REQUIRE(ball.set_numbers(0, 1, radius));
  CHECK(ball.boxes().boxes[0].half_extents[1] == 0.125);
  const std::array<double, 1> negative{-1};
  CHECK_FALSE(ball.set_numbers(0, 1, negative));
  CHECK_FALSE(ball.set_numbers(0, 2, radius));
  const Rows rows = ball.rows();
  REQUIRE(ball.move(2, {1, 1, 0}));  // the frustum
  CHECK(ball.boxes().boxes[1].center == V3(1, 1, 0));
  REQUIRE(ball.set_rows(rows));
  CHECK(ball.boxes().boxes[1].center == V3(0.55, 0, 0));

  FrustumSubject point(pair_of(3, Form::kPoint, {0.3, 0.2, 0.1}, 0), 1);
  CHECK(point.name_of(0) == "Point");
  CHECK(point.size() == 1 + places_of_box(3));
  CHECK_FALSE(point.set_numbers(0, 1, radius));
  CHECK(FrustumSubject(pair_of(3, Form::kBall, V3::Zero(), 1), 1).name_of(0) == "Sphere");
}

TEST_CASE("moved planes keep few circles that touch nothing") {
  BoxPair pair = pair_of(2, Form::kBall, V3::Zero(), 0.3);
  Random random(1);
  int kept = 0, false_positives = 0;
  for (int i = 0; i < 100'000; ++i) {
    for (const int axis : {0, 1}) pair.boxes[0].center[axis] = pair.boxes[1].center[axis] + random.between(-2, 2);
    if (verdict_of("grown_planes", pair) != Culling::kIntersecting) continue;
    ++kept;
    false_positives += share_a_point(pair).value_or(true) ? 0 : 1;
  }
  INFO(kept << " intersecting, " << false_positives << " of them false");
  CHECK(std::lround(kept / 1000.0) == 28);
  CHECK(std::lround(1000.0 * false_positives / kept) == 23);
}
