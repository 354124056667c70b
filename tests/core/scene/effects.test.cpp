// What each effect leaves behind, held against what geometry says it must be.
#include <cmath>
#include <numbers>

#include "core/point_clouds.hpp"
#include "core/scene/declared.hpp"
#include "geometry/turn.hpp"
#include "hierarchy/bounds.hpp"
#include "query/cull/classify.hpp"

using namespace snug;
using namespace snug::test;

namespace {

scene::Cloud cloud(const char* kind, int count) {
  scene::Cloud points;
  const auto generated = generate(kind, count, 3, 3);
  for (const auto& p : *generated) points.push_back(p);
  return points;
}

}  // namespace

TEST_CASE("spin turns by the angle that is asked for and stops where it must") {
  Scene scene = opened({.bodies = {named("a", ball(1, {3, 0, 0}))},
                        .effects = {call("spin", {{"turns_per_second", {0.5}, ""}, {"degrees", {90}, ""}})}});
  scene.go(10);
  CHECK((motion(scene, 0).rotation - turn(V3::UnitY(), 2 * std::numbers::pi * 0.5 * 10 / 60)).cwiseAbs().maxCoeff() <
        1e-14);
  scene.go(100);
  CHECK((motion(scene, 0).rotation - turn(V3::UnitY(), std::numbers::pi / 2)).cwiseAbs().maxCoeff() < 1e-14);
  CHECK(motion(scene, 0).position == V3(3, 0, 0));
  CHECK(scene.resting());
}

TEST_CASE("orbit keeps distances, path its places and its speed") {
  Scene scene =
      opened({.bodies = {named("a", ball(1, {3, 4, 0})), named("b", ball(1, {0, 9, 0}))},
              .effects = {call("orbit", {{"center", {1, 0, 0}, ""}}, "a"),
                          call("path",
                               {{"places", {0, 0, 0, 2, 0, 0, 2, 1, 0}, ""}, {"speed", {3}, ""}, {"then", {}, "round"}},
                               "b")}});
  for (int frame = 1; frame < 200; ++frame) {
    const V3 before = motion(scene, 1).position;
    scene.step();
    CHECK((motion(scene, 0).position - V3(1, 0, 0)).norm() == doctest::Approx(std::sqrt(20.0)));
    if (frame > 1) CHECK((motion(scene, 1).position - before).norm() <= 3.0 / 60 + 1e-12);
  }
  CHECK_FALSE(scene.resting());
}

TEST_CASE("free fall is semi-implicit Euler's, to the last bit") {
  Scene scene = opened({.bodies = {ball(1, {0, 100, 0})}, .effects = {call("fall")}});
  double y = 100, v = 0;
  for (int frame = 0; frame < 100; ++frame) {
    scene.step();
    v += -9.81 * (1.0 / 60);
    y += v * (1.0 / 60) * 1.0;
    CHECK(motion(scene, 0).position[1] == y);
  }
}

TEST_CASE("drag pulls a body to its point, without swinging past it, and to another when that moves") {
  Scene scene =
      opened({.bodies = {named("a", ball(1, {5, 0, 0}))}, .effects = {call("drag", {{"to", {1, 2, 0}, ""}}, "a")}});
  double last = 10;
  for (int frame = 0; frame < 240; ++frame) {
    scene.step();
    const double distance = (motion(scene, 0).position - V3(1, 2, 0)).norm();
    CHECK(distance <= last);
    last = distance;
  }
  CHECK(last < 1e-3);
  scene.pull_to({-3, 0, 0});
  scene.go(480);
  CHECK((motion(scene, 0).position - V3(-3, 0, 0)).norm() < 1e-3);
}

TEST_CASE("a sleeper gathers no speed from what drags it") {
  Declaration declaration{.bodies = {floor(), named("a", box({0.5, 0.5, 0.5}, {0, 0.5, 0})),
                                     fixed(box({0.2, 2, 2}, {0.71, 2, 0})), named("b", ball(0.2, {-15, 3, 0}))},
                          .effects = solid(0)};
  declaration.effects.push_back(call("drag", {{"to", {5, 0.5, 0}, ""}, {"stiffness", {1}, ""}}, "a"));
  declaration.effects.push_back(call("orbit", {{"center", {-13, 3, 0}, ""}}, "b"));
  Scene scene = opened(declaration);
  scene.go(400);
  CHECK(motion(scene, 1).asleep);
  CHECK(motion(scene, 1).velocity == V3::Zero());
}

TEST_CASE("every update of every volume keeps each point in its box, and says what it costs") {
  const scene::Cloud points = cloud("gaussian", 200);
  for (const auto& way : std::vector<std::pair<std::string, std::string>>{{"aabb", "loose"},
                                                                          {"aabb", "rebuild"},
                                                                          {"aabb", "hill_climb"},
                                                                          {"aabb", "rotated_box"},
                                                                          {"sphere", "transform"},
                                                                          {"obb", "transform"},
                                                                          {"kdop", "k14_hill_climb"}}) {
    const std::string &volume = way.first, &strategy = way.second;
    INFO(volume << " " << strategy);
    Scene scene = opened({.bodies = {Body{.shape = points}},
                          .effects = {call("spin", {{"axis", {1, 2, 3}, ""}}),
                                      call("refit", {{"volume", {}, volume}, {"strategy", {}, strategy}})}});
    for (int frame = 0; frame < 20; ++frame) {
      scene.step();
      const auto& state = scene.world().state;
      const Aabb<double, 3>& box = state.volumes[0];
      for (const V3& corner : scene.world().members[0].shape.corners) {
        const V3 at = placed<double, 3>({scene.world().bodies[0].rotation, scene.world().bodies[0].position}, corner);
        REQUIRE((at - box.min).minCoeff() >= -1e-12);
        REQUIRE((box.max - at).minCoeff() >= -1e-12);
      }
      CHECK(state.refitted.slack >= 0);
      if (strategy == "rebuild") CHECK(state.refitted.slack == 0);
      if (strategy == "rebuild") CHECK(state.refitted.cost == 200);
      if (strategy == "rotated_box") CHECK(state.refitted.cost == 0);
      if (strategy == "loose" && frame > 0) CHECK(state.refitted.slack > 0.5);
      if (strategy == "hill_climb" && frame > 0) CHECK(state.refitted.cost < 200);
    }
  }
}

TEST_CASE("the boxes of spheres, boxes and other shapes hold them") {
  std::vector<Body> bodies{ball(0.7, {1, 2, 3}), box({1, 2, 0.5}, {1e3, 0, 0})};
  bodies.push_back({.shape = scene::Volume3(Capsule<double, 3>{{-1, 0, 0}, {1, 1, 0}, 0.3}), .position = {0, 5, 0}});
  bodies.push_back(
      {.shape = scene::Volume3(Obb<double, 3>{{1, 0, 0}, turn(V3(1, 1, 0), 0.7), {1, 2, 3}}), .position = {0, 0, 9}});
  for (const char* strategy : {"rotated_box", "loose"}) {
    Scene scene =
        opened({.bodies = bodies,
                .effects = {call("spin", {{"axis", {1, 0, 2}, ""}}), call("refit", {{"strategy", {}, strategy}})}});
    scene.go(77);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const auto& shape = scene.world().members[i].shape;
      const auto& box = scene.world().state.volumes[i];
      for (const V3& corner : shape.corners) {
        const V3 at = placed<double, 3>({motion(scene, i).rotation, motion(scene, i).position}, corner);
        CHECK((at - box.min).minCoeff() >= shape.radius - 1e-9);
        CHECK((box.max - at).minCoeff() >= shape.radius - 1e-9);
      }
    }
  }
}

TEST_CASE("culling says of each box what the test of one box says") {
  std::vector<Body> bodies;
  for (int i = 0; i < 40; ++i) bodies.push_back(ball(0.3, V3(i % 8 - 4, i / 8 - 2, -i % 5)));
  Scene scene = opened({.bodies = bodies,
                        .effects = {call("orbit"), call("refit"),
                                    call("cull", {{"from", {0, 1, 6}, ""}, {"half_tangent", {0.4}, ""}})}});
  FrustumCamera<double, 3> camera{.position = {0, 1, 6}, .half_tangents = {0.4, 0.4}};
  camera.axes.col(2) = V3(0, 1, 6).normalized();
  camera.axes.col(0) = V3::UnitY().cross(camera.axes.col(2)).normalized();
  camera.axes.col(1) = camera.axes.col(2).cross(camera.axes.col(0));
  const auto frustum = frustum_of_camera(camera);
  REQUIRE(frustum.has_value());
  std::array<int, 3> seen{};
  for (const int frame : {1, 50, 200}) {
    scene.go(frame);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const auto verdict = static_cast<std::uint8_t>(query::classify(*frustum, scene.world().state.volumes[i]).verdict);
      CHECK(scene.world().state.visibility[i] == verdict);
      ++seen[verdict];
    }
  }
  CHECK(seen[0] > 0);
  CHECK(seen[2] > 0);
}

TEST_CASE("shadows are what the light leaves out, trails where bodies were, feet below them") {
  Scene scene = opened({.bodies = {named("a", box({1, 1, 1}, {0, 3, 0})), named("b", ball(0.5, {5, 2, 0}))},
                        .effects = {call("shadow", {{"light", {0, -1, 0}, ""}}), call("trail", {{"length", {5}, ""}}),
                                    call("projection_rays"), call("path", {{"places", {5, 2, 0, 9, 2, 0}, ""}}, "b")}});
  scene.go(20);
  const auto& state = scene.world().state;
  REQUIRE(state.shadows[0].size() == 4);
  for (const V3& corner : state.shadows[0]) CHECK(corner.cwiseAbs() == V3(1, 0, 1));
  CHECK(state.shadows[1].size() == 24);
  for (const V3& p : state.shadows[1])
    CHECK((p - V3(scene.world().bodies[1].position[0], 0, 0)).norm() == doctest::Approx(0.5));
  CHECK(state.trails[0].size() == 1);  // it did not move
  CHECK(state.trails[1].size() == 5);
  CHECK(state.trails[1].back() == scene.world().bodies[1].position);
  CHECK(state.rays[1].to == V3(scene.world().bodies[1].position[0], 0, 0));
}
