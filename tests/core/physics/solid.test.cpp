// Bodies that push each other: stacks stand, walls hold, energy is never made of nothing.
#include <array>
#include <cmath>
#include <numbers>

#include "core/scene/declared.hpp"
#include "geometry/random.hpp"
#include "query/overlap/obb_sat.hpp"

using namespace snug;
using namespace snug::test;

namespace {

constexpr int kTenMinutes = 10 * 60 * 60;

Declaration stack(bool sleep) {
  Declaration declaration{.bodies = {floor()}, .effects = solid(0, sleep)};
  for (int i = 0; i < 10; ++i)
    declaration.bodies.push_back(box({0.5, 0.5, 0.5}, {0.02 * (i % 3 - 1), 0.51 + 1.01 * i, 0.02 * (i % 2)}));
  return declaration;
}

void check_standing(const Scene& scene, double most_aside) {
  for (std::size_t i = 1; i <= 10; ++i) {
    const V3& at = motion(scene, i).position;
    CHECK(std::abs(at[1] - (static_cast<double>(i) - 0.5)) < 0.02);
    CHECK(std::hypot(at[0], at[2]) < most_aside);
    CHECK(motion(scene, i).rotation(1, 1) > 0.9999);
  }
}

/// By how much at most the energy rose in a frame, in parts of what there was at the start above the lowest place.
double most_gained(Scene& scene, int frames, double scale) {
  double most = -1, before = scene.world().energy();
  for (int frame = 0; frame < frames; ++frame) {
    scene.step();
    const double after = scene.world().energy();
    most = std::max(most, (after - before) / scale);
    before = after;
  }
  return most;
}

/// Balls have nothing that would stop them rolling.
Declaration tumble(double restitution, bool balls) {
  Declaration declaration{.bodies = {floor()}, .effects = solid(restitution)};
  Random random(7);
  for (int i = 0; i < 24; ++i) {
    const V3 at(random.between(-1, 1), 1 + 0.6 * i, random.between(-1, 1));
    Body body = balls && i % 3 == 0 ? ball(0.3, at) : box({0.3, 0.15 + 0.01 * i, 0.25}, at, 1 + i % 4);
    body.orientation = normalized({random.unit(), random.unit(), random.unit(), random.unit()});
    declaration.bodies.push_back(moving(body, V3(random.normal(), random.normal(), random.normal()),
                                        V3(3 * random.normal(), 3 * random.normal(), 3 * random.normal())));
  }
  return declaration;
}

/// Ten cubes exactly on each other.
Declaration cubes(double half) {
  Declaration declaration{.bodies = {floor()}, .effects = solid(0)};
  for (int i = 0; i < 10; ++i) declaration.bodies.push_back(box({half, half, half}, {0, half * (2 * i + 1), 0}));
  return declaration;
}

/// A box from 3 above the floor, turned about z and then x, in degrees.
Declaration falling(const V3& half, double about_x, double about_z) {
  const auto radians = [](double degrees) { return degrees * std::numbers::pi / 180; };
  Body body = box(half, {0, 3, 0});
  body.orientation =
      normalized(quaternion_about(V3::UnitX(), radians(about_x)) * quaternion_about(V3::UnitZ(), radians(about_z)));
  return {.bodies = {floor(), body}, .effects = solid(0)};
}

}  // namespace

TEST_CASE("ten boxes come to rest and stay for ten minutes") {
  Scene scene = opened(stack(true));
  scene.go(600);
  check_standing(scene, 0.05);
  CHECK(scene.resting());
  const auto before = scene.world().hash();
  const std::vector<scene::Motion> bodies = scene.world().bodies;
  const std::int64_t runs = tally(scene, "bounce").run;
  scene.go(kTenMinutes);
  CHECK(scene.resting());
  CHECK(tally(scene, "bounce").run == runs);
  CHECK(scene.world().hash() != before);  // the frame's number is part of it
  for (std::size_t i = 0; i < bodies.size(); ++i) CHECK(motion(scene, i).position == bodies[i].position);
}

TEST_CASE("ten boxes stand without sleep too") {
  Scene scene = opened(stack(false));
  scene.go(1800);
  check_standing(scene, 0.06);
  CHECK_FALSE(scene.resting());
}

TEST_CASE("without restitution energy never grows") {
  for (Declaration declaration : {tumble(0, true), stack(true), stack(false)}) {
    Scene scene = opened(declaration);
    CHECK(most_gained(scene, 900, std::abs(scene.world().energy())) < 1e-9);
  }
}

TEST_CASE("without restitution energy never grows in small bodies, thin ones and long frames") {
  std::vector<Declaration> all;
  for (const double half : {0.02, 0.01, 0.005}) all.push_back(cubes(half));
  for (const double half : {0.05, 0.1}) all.push_back(falling({2, half, 2}, 5, 9));
  for (const double step : {0.03, 0.1, 0.5, 1.0}) all.push_back(stack(true)), all.back().step = step;
  for (const Declaration& declaration : all) {
    Scene scene = opened(declaration);
    const int frames = static_cast<int>(std::min(600.0, 10 / declaration.step));
    INFO("half thickness " << scene.world().members.back().shape.thinnest << ", step " << declaration.step);
    CHECK(most_gained(scene, frames, std::abs(scene.world().energy())) < 1e-9);
  }
}

TEST_CASE("small bodies stand as large ones do") {
  for (const double half : {0.5, 0.1, 0.05, 0.02, 0.01, 0.005}) {
    Scene scene = opened(cubes(half));
    scene.go(1200);
    INFO("half " << half);
    CHECK(scene.resting());
    for (std::size_t i = 1; i <= 10; ++i) {
      CHECK(std::abs(motion(scene, i).position[1] / half - (2 * static_cast<double>(i) - 1)) < 0.05);
      CHECK(motion(scene, i).rotation(1, 1) > 0.999);
    }
  }
}

TEST_CASE("a heavy body stands on light ones") {
  for (const double mass : {20.0, 100.0}) {
    Declaration declaration = cubes(0.5);
    declaration.bodies.back().mass = mass;
    Scene scene = opened(declaration);
    scene.go(900);
    INFO("mass " << mass);
    CHECK(scene.resting());
    for (std::size_t i = 1; i <= 10; ++i) {
      CHECK(std::abs(motion(scene, i).position[1] - (static_cast<double>(i) - 0.5)) < 0.15);
      CHECK(motion(scene, i).rotation(1, 1) > 0.999);
    }
  }
}

TEST_CASE("a frame may be a second") {
  for (const double step : {0.1, 0.5, 1.0}) {
    Declaration declaration = stack(true);
    declaration.step = step;
    Scene scene = opened(declaration);
    scene.go(static_cast<int>(20 / step));
    check_standing(scene, 0.06);
  }
}

TEST_CASE("a body too thin for so long a frame is refused by name") {
  Declaration declaration = falling({1, 1e-6, 1}, 0, 0);
  declaration.bodies.back().name = "leaf";
  declaration.step = 1;
  CHECK(refusal(declaration).find("leaf is too thin for so long a step") != std::string::npos);
}

TEST_CASE("a body too fast for its thickness is refused by name") {
  const auto with = [](Body body) { return refusal({.bodies = {floor(), named("dart", body)}, .effects = solid(0)}); };
  CHECK(with(moving(ball(0.1, {0, 3, 0}), {2000, 0, 0})) == "");
  CHECK(with(moving(box({0.1, 0.05, 0.2}, {0, 3, 0}), {2000, 0, 0})) == "");
  CHECK(with(moving(ball(0.1, {0, 3, 0}), {0, 0, 0}, {1e9, 0, 0})) == "");  // a ball crosses nothing by turning
  const std::string fault =
      "bounce: dart is too fast: it would cross more than 1000 times its own thickness in a frame";
  CHECK(with(moving(ball(0.1, {0, 3, 0}), {1e9, 0, 0})) == fault);
  CHECK(with(moving(box({0.05, 0.002, 0.05}, {0, 3, 0}), {0, 0, 0}, {1e9, 0, 0})) == fault);
}

TEST_CASE("slender bodies fall over in their own time") {
  struct Case {
    V3 half;
    double tilt, roll;
  };
  for (const Case& one : {Case{{2, 0.1, 0.1}, 0, 30},
                          {{2, 0.1, 2}, 5, 9},
                          {{1.5, 0.03, 0.1}, 3, 15},
                          {{2, 0.001, 2}, 5, 9},
                          {{3, 0.2, 0.2}, 0, 20}}) {
    Scene scene = opened(falling(one.half, one.tilt, one.roll));
    int frame = 0;
    while (!scene.resting() && frame < 400) scene.go(++frame);
    INFO("half extents " << one.half.transpose() << " at frame " << frame);
    CHECK(scene.resting());
    CHECK(frame > 45);
    CHECK(std::abs(motion(scene, 1).position[1] - one.half.minCoeff()) < 0.01 * one.half.minCoeff());
  }
}

TEST_CASE("a heavy body does not push a light one through a wall, nor into it") {
  for (const double mass : {1.0, 100.0, 1e4})
    for (const double speed : {20.0, 200.0})
      for (const double gap : {0.0, 0.05})
        for (const double thickness : {0.04, 1.0})
          for (const bool balls : {false, true}) {
            const auto body = [&](double x, double weight) {
              return balls ? ball(0.2, {x, 0, 0}, weight) : box({0.2, 0.2, 0.2}, {x, 0.01, 0.01}, weight);
            };
            Declaration declaration{.bodies = {fixed(box({thickness / 2, 50, 50}, {5, 0, 0})),
                                               body(4.8 - thickness / 2 - gap, 1),
                                               moving(body(2, mass), {speed, 0, 0})},
                                    .effects = solid(0)};
            declaration.effects.erase(declaration.effects.begin());  // no gravity
            Scene scene = opened(declaration);
            for (int frame = 0; frame < 90; ++frame) {
              scene.step();
              INFO("mass " << mass << ", speed " << speed << ", gap " << gap << ", thickness " << thickness
                           << ", balls " << balls << ", frame " << frame);
              REQUIRE(motion(scene, 1).position[0] < 5 - thickness / 2);
              REQUIRE(motion(scene, 2).position[0] < 5 - thickness / 2);
            }
          }
}

TEST_CASE("what pushes a body does not push it into what is fixed") {
  for (const double mass : {1e3, 1e6})
    for (const double speed : {50.0, 200.0, 2000.0})
      for (const double thickness : {0.001, 1.0})
        for (const double gap : {0.0, 0.05}) {
          const Declaration declaration{.bodies = {fixed(box({20, thickness / 2, 20}, {0, -thickness / 2, 0})),
                                                   box({0.2, 0.2, 0.2}, {0, 0.2 + gap, 0}),
                                                   moving(box({0.5, 0.5, 0.5}, {0.05, 3, 0.02}, mass), {0, -speed, 0})},
                                        .effects = solid(0)};
          Scene scene = opened(declaration);
          for (int frame = 0; frame < 100; ++frame) {
            scene.step();
            INFO("mass " << mass << ", speed " << speed << ", thickness " << thickness << ", gap " << gap << ", frame "
                         << frame);
            REQUIRE(motion(scene, 1).position[1] > 0.1);
            REQUIRE(motion(scene, 2).position[1] > 0.4);
          }
        }
  for (const double thickness : {0.01, 1.0})
    for (const bool is_ball : {true, false}) {
      Declaration declaration{.bodies = {floor(), is_ball ? ball(0.5, {0, 0.5, 0}) : box({0.5, 0.5, 0.5}, {0, 0.5, 0}),
                                         named("pusher", box({0.3, 0.4, 0.4}, {-5, 0.5, 0})),
                                         fixed(box({thickness / 2, 5, 5}, {1 + thickness / 2, 5, 0}))},
                              .effects = solid(0)};
      declaration.effects.push_back(call("path", {{"places", {-5, 0.5, 0, 10, 0.5, 0}, ""}}, "pusher"));
      Scene scene = opened(declaration);
      for (int frame = 0; frame < 900; ++frame) {
        scene.step();
        INFO("a driven body pushes it against a wall of " << thickness << ", ball " << is_ball << ", frame " << frame);
        REQUIRE(motion(scene, 1).position[0] < 0.52);
      }
    }
}

TEST_CASE("with restitution a ball comes back as high as it must, and no higher") {
  for (const double restitution : {0.0, 0.5, 0.9, 1.0}) {
    Declaration declaration{.bodies = {floor(), ball(0.25, {0, 2.25, 0})}, .effects = solid(restitution, true, 0)};
    Scene scene = opened(declaration);
    while (motion(scene, 1).velocity[1] <= 0 && scene.frame() < 120) scene.step();
    double highest = 0;
    for (int i = 0; i < 60; ++i) scene.step(), highest = std::max(highest, motion(scene, 1).position[1] - 0.25);
    INFO("restitution " << restitution << ", came back to " << highest);
    CHECK(highest < 2 * restitution * restitution + 1e-9);
    CHECK(highest > 2 * restitution * restitution - 0.2);
  }
}

TEST_CASE("with restitution there is never more energy than there was") {
  const auto spinning = [](double tilt, double angular_velocity, double restitution) {
    Body body = box({0.5, 0.1, 0.5}, {0, 1.5, 0});
    body.orientation = quaternion_about(V3::UnitZ(), tilt * std::numbers::pi / 180);
    return Declaration{.bodies = {floor(), moving(body, {0, -1, 0}, {0, 0, angular_velocity})},
                       .effects = solid(restitution, true, 0)};
  };
  std::vector<Declaration> all{tumble(0.6, false), tumble(0.9, true), tumble(1, false)};
  for (const double restitution : {0.5, 0.6, 0.7, 0.9, 1.0})
    for (int tilt = 0; tilt < 90; tilt += 17)
      for (const double angular_velocity : {-9.0, -3.0, 5.0, 12.0})
        all.push_back(spinning(tilt, angular_velocity, restitution));
  for (const Declaration& declaration : all)
    for (const bool gravity : {true, false}) {
      Declaration own = declaration;
      if (!gravity) own.effects.erase(own.effects.begin());
      Scene scene = opened(own);
      const double start = scene.world().energy();
      INFO("restitution " << own.effects.back().settings[0].numbers[0] << ", gravity " << gravity << ", bodies "
                          << own.bodies.size());
      for (int frame = 0; frame < 90; ++frame) {
        scene.step();
        REQUIRE(scene.world().energy() <= start + 1e-9 * std::abs(start));
      }
    }
}

TEST_CASE("a body at 200 metres a second does not end up inside a wall, nor behind it") {
  for (const double thickness : {0.5, 0.05, 0.004})
    for (const double restitution : {0.0, 0.6}) {
      Body wall = fixed(box({thickness / 2, 5, 5}, {0, 0, 0}));
      for (const bool is_ball : {true, false}) {
        Body body = is_ball ? ball(0.1, {-7.3, 0.2, 0.1}) : box({0.1, 0.05, 0.2}, {-7.3, 0.2, 0.1});
        body.orientation = normalized({1, 0.1, 0.2, 0.3});
        Declaration declaration{.bodies = {wall, moving(body, {200, 3, 1})}, .effects = solid(restitution)};
        declaration.effects.erase(declaration.effects.begin());  // no gravity
        Scene scene = opened(declaration);
        for (int frame = 0; frame < 60; ++frame) {
          scene.step();
          INFO("thickness " << thickness << ", frame " << frame << ", x " << motion(scene, 1).position[0]);
          REQUIRE(motion(scene, 1).position[0] < 0);
          REQUIRE(motion(scene, 1).position[0] < -thickness / 2 - 0.02);
        }
        CHECK(motion(scene, 1).position[0] > -7.3 - 200);
        if (is_ball && restitution > 0) CHECK(motion(scene, 1).velocity[0] == doctest::Approx(-120));
        if (is_ball && restitution == 0) CHECK(std::abs(motion(scene, 1).velocity[0]) < 1e-9);
        if (is_ball) CHECK(motion(scene, 1).position[0] < -thickness / 2 - 0.1 + 0.002);
        else CHECK(motion(scene, 1).velocity[0] < 100);
      }
    }
}

TEST_CASE("a slender body flung into the corner of two walls stays before both") {
  for (const double half : {0.1, 0.03, 0.01})
    for (const double degrees : {90.0, 60.0, 35.0}) {
      const double angle = degrees * std::numbers::pi / 180;
      // The walls' faces meet along z; into is the way into each.
      const std::array<V3, 2> into{V3(0, -1, 0), V3(std::sin(angle), std::cos(angle), 0)};
      const V3 open(-std::cos(angle / 2), std::sin(angle / 2), 0);
      Random random(9);
      for (int i = 0; i < 12; ++i) {
        Declaration declaration{.bodies = {}, .effects = solid(0)};
        declaration.effects.erase(declaration.effects.begin());  // no gravity
        for (const V3& way : into) {
          declaration.bodies.push_back(fixed(box({0.25, 60, 60}, way * 0.25)));
          declaration.bodies.back().orientation = quaternion_about(V3::UnitZ(), std::atan2(way[1], way[0]));
        }
        const auto any = [&](double most) {
          return V3(random.between(-most, most), random.between(-most, most), random.between(-most, most));
        };
        Body rod = box({1, half, half}, open * (1.3 / std::sin(angle / 2) + 0.5));
        rod.orientation =
            normalized({random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
        declaration.bodies.push_back(moving(rod, (any(0.3) - open).normalized() * 200, any(i % 2 == 0 ? 0 : 30)));
        Scene scene = opened(declaration);
        for (int frame = 0; frame < 60; ++frame) {
          scene.step();
          INFO("half thickness " << half << ", corner of " << degrees << ", rod " << i << ", frame " << frame);
          const scene::Motion& at = motion(scene, 2);
          for (const V3& way : into)
            REQUIRE(way.dot(at.position) + (at.rotation.transpose() * way).cwiseAbs().dot(V3(1, half, half)) < half);
        }
      }
    }
}

TEST_CASE("a body that starts deep in what is fixed is refused by name") {
  const auto with = [](double height) {
    return refusal({.bodies = {named("ground", floor()), named("crate", box({0.5, 0.2, 0.5}, {0, height, 0}))},
                    .effects = solid(0)});
  };
  CHECK(with(0.2) == "");
  CHECK(with(0.197) == "");
  CHECK(with(0.19) == "bounce: crate starts inside ground: move it out, or call it fixed too");
  CHECK(with(-0.5).find("crate starts inside ground") != std::string::npos);
}

TEST_CASE("two fast bodies meet head on") {
  Declaration declaration{
      .bodies = {moving(ball(0.1, {-9, 0, 0}), {200, 0, 0}), moving(ball(0.1, {9.1, 0, 0}), {-200, 0, 0})},
      .effects = solid(1)};
  declaration.effects.erase(declaration.effects.begin());
  Scene scene = opened(declaration);
  scene.go(20);
  CHECK(motion(scene, 0).velocity[0] == doctest::Approx(-200).epsilon(0.01));
  CHECK(motion(scene, 1).velocity[0] == doctest::Approx(200).epsilon(0.01));
  CHECK(motion(scene, 0).position[0] < motion(scene, 1).position[0]);
}

TEST_CASE("a pile comes to rest with no two bodies deep in each other") {
  Scene scene = opened(tumble(0.2, false));
  scene.go(1500);
  CHECK(scene.resting());
  for (std::size_t i = 1; i < scene.world().size(); ++i) CHECK(motion(scene, i).position[1] > 0.1);
  for (const auto& contact : scene.world().contacts) {
    const auto a = static_cast<std::size_t>(contact.pair.a), b = static_cast<std::size_t>(contact.pair.b);
    const auto& members = scene.world().members;
    if (members[a].shape.kind != physics::Shape::Kind::kBox || members[b].shape.kind != scene::Shape::Kind::kBox)
      continue;
    const auto obb = [&](std::size_t k) {
      return Obb<double, 3>{motion(scene, k).position, motion(scene, k).rotation,
                            members[k].shape.half_extents - V3::Constant(0.006)};
    };
    CHECK_FALSE(query::obb_sat(obb(a), obb(b)).overlap);
  }
}

TEST_CASE("friction holds a box on a slope that is not too steep") {
  for (const double friction : {0.1, 0.8}) {
    Body slope = fixed(box({10, 0.5, 10}, {0, 0, 0}));
    slope.orientation = quaternion_about(V3::UnitZ(), 0.35);  // its tangent is 0.365
    Body body = box({0.3, 0.3, 0.3}, quaternion_about(V3::UnitZ(), 0.35).w * V3::Zero() +
                                         V3(-0.8 * std::sin(0.35), 0.8 * std::cos(0.35), 0));
    body.orientation = slope.orientation;
    Scene scene = opened({.bodies = {slope, body}, .effects = solid(0, true, friction)});
    const double start = motion(scene, 1).position[0];
    scene.go(120);
    if (friction > 0.365) CHECK(std::abs(motion(scene, 1).position[0] - start) < 0.02);
    else CHECK(motion(scene, 1).position[0] < start - 1);
  }
}

TEST_CASE("friction is the same in every direction") {
  for (int degrees = 0; degrees <= 90; degrees += 15) {
    const double angle = degrees * std::numbers::pi / 180;
    const V3 way(std::cos(angle), 0, std::sin(angle));
    INFO("at " << degrees << " degrees");
    Scene sliding = opened(
        {.bodies = {floor(), moving(box({0.3, 0.3, 0.3}, {0, 0.3, 0}), way * 4)}, .effects = solid(0, true, 0.4)});
    sliding.go(120);
    CHECK(motion(sliding, 1).position.dot(way) == doctest::Approx(16 / (2 * 0.4 * 9.81)).epsilon(0.02));
    CHECK(std::abs(motion(sliding, 1).position.dot(way.cross(V3::UnitY()))) < 1e-3);
    for (const double steepness : {0.97, 1.03}) {
      const double lean = std::atan(0.5 * steepness);
      Body slope = fixed(box({50, 0.5, 50}, {0, 0, 0}));
      slope.orientation = quaternion_about(way, lean);
      Body body = box({0.5, 0.2, 0.5}, turned<double, 3>(matrix_of(slope.orientation), V3(0, 0.7, 0)));
      body.orientation = slope.orientation;
      Scene scene = opened({.bodies = {slope, body}, .effects = solid(0)});
      scene.go(300);
      const double moved = (motion(scene, 1).position - body.position).norm();
      if (steepness < 1) CHECK(moved < 1e-3);
      else CHECK(moved > 1);
    }
  }
}

TEST_CASE("what is driven does not knock a body into a floor that is still out of reach") {
  Declaration declaration{.bodies = {floor(), ball(0.156, {0.0324, 0.3126, -0.3343}, 0.115),
                                     named("bar", box({1.5, 0.1, 0.2}, {0, 0.3, 0}))},
                          .effects = solid(0)};
  declaration.effects.push_back(call("spin", {{"axis", {0, 1, 0}, ""}, {"turns_per_second", {5}, ""}}, "bar"));
  Scene scene = opened(declaration);
  for (int frame = 0; frame < 120; ++frame) {
    scene.step();
    INFO("frame " << frame);
    REQUIRE(motion(scene, 1).position[1] > 0.15);
  }
}

TEST_CASE("a sleeper wakes when what drives its support is switched on again far away") {
  Declaration declaration{.bodies = {named("lift", box({1, 0.1, 1}, {0, 0, 0})), box({0.3, 0.3, 0.3}, {0, 0.4, 0})},
                          .effects = solid(0)};
  declaration.effects.push_back(call("path", {{"places", {0, 0, 0, 0, -50, 0}, ""}, {"speed", {5}, ""}}, "lift"));
  Scene scene = opened(declaration);
  const auto path = [&] {
    std::size_t i = 0;
    while (scene.tallies()[i].effect != "path lift") ++i;
    return i;
  }();
  scene.turn(path, false);
  scene.go(300);
  CHECK(motion(scene, 1).asleep);
  scene.turn(path, true);
  scene.go(600);
  CHECK(motion(scene, 1).position[1] < -40);
}

TEST_CASE("a stack stands on a floor as thin as paper") {
  for (const double half : {0.0, 1e-6, 0.5}) {
    Declaration declaration{.bodies = {fixed(box({20, half, 20}, {0, -half, 0}))}, .effects = solid(0)};
    for (int i = 0; i < 10; ++i) {
      declaration.bodies.push_back(box({0.25, 0.25, 0.25}, {0, 0.25 + 0.5 * i, 0}));
      declaration.bodies.back().orientation = quaternion_about(V3::UnitY(), 0.23 * i);
    }
    Scene scene = opened(declaration);
    scene.go(600);
    INFO("half thickness " << half);
    CHECK(scene.resting());
    for (std::size_t i = 1; i <= 10; ++i)
      CHECK((motion(scene, i).position - V3(0, 0.25 + 0.5 * (static_cast<double>(i) - 1), 0)).norm() < 0.01);
  }
}

TEST_CASE("a smooth slope does not brake, however flat") {
  for (const double degrees : {0.05, 0.5, 5.0})
    for (const double half : {0.5, 0.05, 0.005}) {
      const double angle = degrees * std::numbers::pi / 180;
      Body slope = fixed(box({50, 0.5, 50}, {0, 0, 0}));
      slope.orientation = quaternion_about(V3::UnitZ(), angle);
      Body body = box({0.5, half, 0.5}, V3(-(0.5 + half) * std::sin(angle), (0.5 + half) * std::cos(angle), 0));
      body.orientation = slope.orientation;
      Scene scene = opened({.bodies = {slope, body}, .effects = solid(0, true, 0)});
      scene.go(300);
      INFO("a slope of " << degrees << " degrees, half thickness " << half);
      CHECK((motion(scene, 1).position - body.position).norm() ==
            doctest::Approx(0.5 * 9.81 * std::sin(angle) * 25).epsilon(0.01));
    }
}

TEST_CASE("what stands at the start stands as it is") {
  for (const double half : {0.5, 0.05, 0.002}) {
    Scene scene = opened(cubes(half));
    for (int frame = 0; frame < 60; ++frame) {
      scene.step();
      INFO("half " << half << ", frame " << frame);
      for (std::size_t i = 1; i <= 10; ++i)
        REQUIRE(std::abs(motion(scene, i).position[1] / half - (2 * static_cast<double>(i) - 1)) < 1e-3);
    }
    CHECK(scene.resting());
  }
}

TEST_CASE("a free body keeps its momentum, and tumbling makes no energy") {
  Declaration declaration{.bodies = {moving(box({0.5, 0.2, 0.1}, {0, 0, 0}), {1, 0, 0}, {0.1, 5, 0.1})},
                          .effects = {call("move")}};
  Scene scene = opened(declaration);
  CHECK(most_gained(scene, 2000, scene.world().energy()) < 1e-12);
  CHECK(scene.world().energy() > 0.5);
  CHECK(motion(scene, 0).position[0] == doctest::Approx(2000.0 / 60));
}

TEST_CASE("a sleeper wakes when another body comes") {
  Declaration declaration{
      .bodies = {floor(), box({0.5, 0.5, 0.5}, {0, 0.5, 0}), moving(ball(0.2, {-30, 0.5, 0}), {0, 0, 0})},
      .effects = solid(0)};
  declaration.bodies[2] = ball(0.2, {0, 40, 0}, 3);
  Scene scene = opened(declaration);
  scene.go(120);
  CHECK(motion(scene, 1).asleep);
  bool woke = false;
  for (int i = 0; i < 300; ++i) scene.step(), woke = woke || !motion(scene, 1).asleep;
  CHECK(woke);
  scene.go(900);
  CHECK(scene.resting());
}

TEST_CASE("what is driven against a sleeper wakes it, whatever else is driven") {
  for (const bool first : {true, false}) {
    Declaration declaration{.bodies = {floor(), box({0.5, 0.5, 0.5}, {0, 0.5, 0}),
                                       named("pusher", box({0.3, 0.4, 0.4}, {-8, 0.5, 0})),
                                       named("other", ball(0.1, {0, 30, 0}))},
                            .effects = solid(0)};
    const EffectCall push = call("path", {{"places", {-8, 0.5, 0, 4, 0.5, 0}, ""}, {"speed", {4}, ""}}, "pusher");
    const EffectCall fly = call("path", {{"places", {0, 30, 0, 500, 30, 0}, ""}, {"speed", {0.3}, ""}}, "other");
    for (const EffectCall& one : first ? std::vector{push, fly} : std::vector{fly, push})
      declaration.effects.push_back(one);
    Scene scene = opened(declaration);
    scene.go(80);
    CHECK(motion(scene, 1).asleep);
    scene.go(200);
    INFO("the pusher is driven " << (first ? "first" : "last") << "; x " << motion(scene, 1).position[0]);
    CHECK(motion(scene, 1).position[0] > 4);
    scene.go(600);
    CHECK(motion(scene, 1).asleep);
  }
}

TEST_CASE("what has no support, or is about to move, does not sleep") {
  const auto after = [](Declaration declaration, bool gravity, int frames) {
    if (!gravity) declaration.effects.erase(declaration.effects.begin());
    Scene scene = opened(declaration);
    scene.go(frames);
    return scene.world().bodies.back();
  };
  for (const double speed : {0.04, 0.001})
    CHECK(
        after({.bodies = {moving(ball(0.5, {0, 0, 0}), {speed, 0, 0})}, .effects = solid(0)}, false, 600).position[0] ==
        doctest::Approx(10 * speed));
  for (const double degrees : {0.3, 0.5}) {
    const double slope = degrees * std::numbers::pi / 180;
    for (const bool is_ball : {true, false}) {
      Body plane = fixed(box({50, 0.5, 50}, {0, 0, 0})),
           body = is_ball ? ball(0.3, {0, 0, 0}) : box({0.3, 0.3, 0.3}, {0, 0, 0});
      plane.orientation = body.orientation = quaternion_about(V3::UnitZ(), slope);
      body.position = V3(-std::sin(slope), std::cos(slope), 0) * 0.8;
      const V3 at = after({.bodies = {plane, body}, .effects = solid(0, true, is_ball ? 0.5 : 0)}, true, 600).position;
      INFO(degrees << " degrees, ball " << is_ball);
      CHECK((at - body.position).norm() ==
            doctest::Approx(50 * 9.81 * std::sin(slope) * (is_ball ? 5.0 / 7 : 1)).epsilon(0.1));
    }
  }
  for (const double half : {0.01, 0.002, 0.0005})
    for (const double degrees : {0.3, 1.0, 2.0}) {
      const double lean =
          degrees * std::numbers::pi / 180 + std::atan(half / 2);  // past where it would stand on its edge
      Body plate = box({half, 2, 2}, {0, 2 * std::cos(lean) + half * std::sin(lean), 0});
      plate.orientation = quaternion_about(V3::UnitZ(), lean);
      const scene::Motion fallen = after({.bodies = {floor(), plate}, .effects = solid(0)}, true, 600);
      INFO("a plate " << half << " half thick, leaning " << degrees << " degrees too far");
      CHECK(std::abs(fallen.position[1] - half) < 0.1 * half);
      CHECK(fallen.asleep);
    }
  Declaration dragged{.bodies = {named("a", ball(0.5, {0.5, 0, 0}))}, .effects = solid(0)};
  dragged.effects.push_back(call("drag", {{"stiffness", {0.005}, ""}}, "a"));
  CHECK(after(dragged, false, 6000).position.norm() < 0.01);
}
