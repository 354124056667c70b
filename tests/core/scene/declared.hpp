// Scenes for tests, declared in a line or two.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "scene/scene.hpp"

namespace snug::test {

using scene::Body;
using scene::Declaration;
using scene::EffectCall;
using scene::Scene;
using V3 = scene::V3;

inline Body box(const V3& half, const V3& position, double mass = 1) {
  return {.shape = scene::Volume3(Aabb<double, 3>{-half, half}), .position = position, .mass = mass};
}
inline Body ball(double radius, const V3& position, double mass = 1) {
  return {.shape = scene::Volume3(Sphere<double, 3>{V3::Zero(), radius}), .position = position, .mass = mass};
}
inline Body fixed(Body body) {
  body.fixed = true;
  return body;
}
inline Body named(std::string name, Body body) {
  body.name = std::move(name);
  return body;
}
inline Body moving(Body body, const V3& velocity, const V3& angular_velocity = V3::Zero()) {
  body.velocity = velocity;
  body.angular_velocity = angular_velocity;
  return body;
}
/// Its top at y = 0.
inline Body floor() { return fixed(box({20, 0.5, 20}, {0, -0.5, 0})); }

inline EffectCall call(std::string name, std::vector<scene::Setting> settings = {}, std::string body = {}) {
  return {.name = std::move(name), .body = std::move(body), .settings = std::move(settings)};
}
/// Gravity, and bodies that push each other.
inline std::vector<EffectCall> solid(double restitution, bool sleep = true, double friction = 0.5) {
  return {
      call("fall"), call("refit"), call("broad_phase"), call("narrow_phase"),
      call("bounce",
           {{"restitution", {restitution}, ""}, {"friction", {friction}, ""}, {"sleep", {}, sleep ? "yes" : "no"}})};
}

inline Scene opened(const Declaration& declaration, scene::Clock clock = nullptr) {
  auto scene = Scene::open(declaration, clock);
  INFO((scene ? "" : scene.error().message()));
  REQUIRE(scene.has_value());
  return *std::move(scene);
}
inline std::string refusal(const Declaration& declaration) {
  const auto scene = Scene::open(declaration);
  return scene ? "" : scene.error().message();
}

inline const scene::EffectTally& tally(const Scene& scene, std::string_view effect) {
  for (const scene::EffectTally& one : scene.tallies())
    if (one.effect == effect) return one;
  FAIL("no effect " << effect);
  return scene.tallies().front();
}
inline const scene::Motion& motion(const Scene& scene, std::size_t i) { return scene.world().bodies[i]; }

}  // namespace snug::test
