// What a declaration comes to: the order of effects, what is refused and in which words, and how often each runs.
#include <limits>

#include "core/scene/declared.hpp"

using namespace snug;
using namespace snug::test;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<std::string> order_of(const std::vector<EffectCall>& calls) {
  const auto planned = scene::plan(calls, scene::catalogue());
  REQUIRE(planned.has_value());
  std::vector<std::string> names;
  for (const scene::Planned& one : *planned) names.emplace_back(one.kind->name);
  return names;
}

std::int64_t constructed = 0;

/// An effect that does nothing, for catalogues of the tests' own.
class Nothing final : public scene::Effect {
 public:
  Nothing() { ++constructed; }
  void run(scene::World&) override {}
};
scene::MadeEffect make_nothing(const EffectCall&, scene::World&) {
  return std::unique_ptr<scene::Effect>(std::make_unique<Nothing>());
}

double ticks = 0;
double ticking() { return ticks += 5; }

}  // namespace

TEST_CASE("the order of effects follows from what they read and write, not from how they were declared") {
  const std::vector<std::string> wanted{"fall",        "bounce",       "move", "refit",
                                        "broad_phase", "narrow_phase", "cull", "trail"};
  CHECK(order_of({call("trail"), call("cull"), call("bounce"), call("narrow_phase"), call("broad_phase"), call("refit"),
                  call("fall")}) == wanted);
  CHECK(order_of({call("fall"), call("refit"), call("broad_phase"), call("narrow_phase"), call("bounce"), call("cull"),
                  call("trail")}) == wanted);
  CHECK(order_of({call("shadow"), call("spin", {}, "a"), call("spin", {}, "b")}) ==
        std::vector<std::string>{"spin", "spin", "shadow"});
  CHECK(order_of({call("drag", {}, "a")}) == std::vector<std::string>{"drag", "move"});
}

TEST_CASE("an effect whose inputs nobody makes is refused, with its line") {
  const auto message = [](std::vector<EffectCall> calls) {
    calls.back().line = 12;
    const auto planned = scene::plan(calls, scene::catalogue());
    return planned ? "" : planned.error().message();
  };
  CHECK(message({call("broad_phase")}) ==
        "line 12: broad_phase reads volumes, which no effect of the scene makes: refit would");
  CHECK(message({call("refit"), call("narrow_phase")}) ==
        "line 12: narrow_phase reads pairs, which no effect of the scene makes: broad_phase would");
  CHECK(message({call("refit"), call("broad_phase"), call("bounce")}) ==
        "line 12: bounce reads contacts, which no effect of the scene makes: narrow_phase would");
  CHECK(message({call("cull")}) == "line 12: cull reads volumes, which no effect of the scene makes: refit would");
  CHECK(message({call("explode")}) == "line 12: there is no effect called \"explode\"");
  CHECK(message({call("fall"), call("fall")}) == "line 12: fall is called for twice");
  CHECK(message({call("spin"), call("spin")}) == "");
}

TEST_CASE("effects that wait for each other are refused") {
  using scene::Slot, scene::slots;
  const scene::EffectKind kinds[] = {
      {"hen", "", slots(Slot::kPairs), 0, 0, slots(Slot::kContacts), "", false, make_nothing},
      {"egg", "", slots(Slot::kContacts), 0, 0, slots(Slot::kPairs), "", false, make_nothing},
  };
  const std::vector<EffectCall> calls{call("hen"), call("egg")};
  const auto planned = scene::plan(calls, kinds);
  REQUIRE_FALSE(planned.has_value());
  CHECK(planned.error().message() == "hen waits for an effect that waits for it");
}

TEST_CASE("what a scene does not declare is never constructed, and what it does once") {
  using scene::Slot, scene::slots;
  const scene::EffectKind kinds[] = {
      {"one", "", slots(Slot::kTime), 0, 0, slots(Slot::kPairs), "", false, make_nothing},
      {"two", "", slots(Slot::kPoses), 0, 0, 0, "", false, make_nothing},
  };
  constructed = 0;
  auto scene = Scene::open({.bodies = {ball(1, V3::Zero())}, .effects = {call("two")}}, nullptr, kinds);
  REQUIRE(scene.has_value());
  scene->go(10);
  CHECK(constructed == 1);
  CHECK(scene->tallies().size() == 1);
  CHECK(scene->tallies()[0].constructed == 1);
  CHECK(scene->tallies()[0].run == 1);
  CHECK(scene->tallies()[0].skipped == 9);
  CHECK(scene->resting());
}

TEST_CASE("masses, poses, steps and shapes that make no sense are refused by name") {
  const auto with = [](Body body) { return refusal({.bodies = {named("bob", body)}}); };
  CHECK(with(ball(1, V3::Zero(), 0)) == "bob: its mass is 0: call it fixed instead");
  CHECK(with(ball(1, V3::Zero(), -1)) == "bob: its mass is negative");
  CHECK(with(ball(1, V3::Zero(), kInfinity)) == "bob: its mass is infinite: call it fixed instead");
  CHECK(with(ball(1, V3::Zero(), kNaN)) == "bob: its mass is not a number");
  CHECK(with(fixed(ball(1, V3::Zero()))) == "");
  CHECK(with(fixed(ball(1, V3::Zero(), 0))) == "bob: its mass is 0 or infinite: a body that is fixed needs none");
  CHECK(with(fixed(ball(1, V3::Zero(), kInfinity))) ==
        "bob: its mass is 0 or infinite: a body that is fixed needs none");
  CHECK(with(fixed(ball(1, V3::Zero(), -3))) == "bob: its mass is negative");
  CHECK(with(fixed(ball(1, V3::Zero(), kNaN))) == "bob: its mass is not a number");
  CHECK(with(ball(1, {0, kNaN, 0})) == "bob: its position is not finite, or too large");
  Body turned = ball(1, V3::Zero());
  turned.orientation = {0, 0, 0, 0};
  CHECK(with(turned) == "bob: its orientation is not a rotation");
  turned.orientation = {1, kNaN, 0, 0};
  CHECK(with(turned) == "bob: its orientation is not finite");
  CHECK(with(moving(ball(1, V3::Zero()), {kInfinity, 0, 0})) == "bob: its velocity is not finite, or too large");
  CHECK(with(ball(-1, V3::Zero())) == "bob: its shape is empty, not finite, or too large");
  CHECK(with(ball(1, V3::Zero(), 1e-308)) == "bob: its mass is too small");
  CHECK(with(ball(1e-160, V3::Zero())) == "bob: its shape is too small");
  CHECK(with(box({1, 1e-160, 1}, V3::Zero())) == "bob: its shape is too small");
  CHECK(with(ball(1e-12, V3::Zero(), 1e-12)) == "");
  CHECK(with(Body{.shape = scene::Cloud{}}) == "bob: its shape is empty, not finite, or too large");
  CHECK(refusal({}) == "the scene has no body");
  CHECK(refusal({.bodies = {ball(1, V3::Zero())}, .step = 0}) == "the scene's step must be above 0");
  CHECK(refusal({.bodies = {ball(1, V3::Zero())}, .step = -1}) == "the scene's step must be above 0");
  CHECK(refusal({.bodies = {ball(1, V3::Zero())}, .step = kNaN}) == "the scene's step is not a number");
  CHECK(refusal({.bodies = {ball(1, V3::Zero())}, .step = 1e-10}) == "the scene's step must be at least 1e-9 seconds");
  CHECK(refusal({.bodies = {ball(1, V3::Zero())}, .step = 2}) == "the scene's step must be at most 1 second");
  CHECK(refusal({.bodies = {named("a", floor()), named("a", floor())}}) == "there is another body called a");
}

TEST_CASE("of two effects that drive one body neither undoes the other") {
  const auto with = [](std::vector<EffectCall> effects) {
    return refusal(
        {.bodies = {named("a", ball(1, V3::Zero())), named("b", ball(1, {5, 0, 0}))}, .effects = std::move(effects)});
  };
  const auto path = [](const char* body) { return call("path", {{"places", {0, 0, 0, 1, 0, 0}, ""}}, body); };
  CHECK(with({call("spin"), call("orbit")}) == "");  // one turns it, the other moves it
  CHECK(with({call("spin", {}, "a"), path("a")}) == "");
  CHECK(with({call("spin", {}, "a"), call("spin", {}, "b"), path("a"), path("b")}) == "");
  CHECK(with({call("drag", {}, "a"), call("fall"), path("b")}) == "");
  CHECK(with({call("spin"), call("spin")}) == "spin and spin would both drive every body: one undoes the other");
  CHECK(with({call("spin"), call("spin", {}, "b")}) == "spin and spin would both drive b: one undoes the other");
  CHECK(with({call("spin"), call("fall")}) == "fall: nothing falls: other effects drive every body that is not fixed");
  CHECK(with({call("spin", {}, "a"), call("fall")}) == "");
  CHECK(with({path("a"), path("a")}) == "path and path would both drive a: one undoes the other");
  CHECK(with({call("orbit"), path("a")}) == "orbit and path would both drive a: one undoes the other");
  CHECK(with({call("orbit", {}, "a"), call("orbit", {}, "a")}) ==
        "orbit and orbit would both drive a: one undoes the other");
  CHECK(with({call("drag", {}, "a"), path("a")}) == "drag and path would both drive a: one undoes the other");
  CHECK(with({call("drag", {}, "a"), call("spin", {}, "a")}) ==
        "drag and spin would both drive a: one undoes the other");
}

TEST_CASE("settings that an effect does not know, or cannot use, are refused by name") {
  const auto with = [](EffectCall effect) {
    Declaration declaration{.bodies = {named("a", ball(1, V3::Zero())), named("floor", floor())}, .effects = {effect}};
    if (effect.name == "bounce")
      declaration.effects = {call("refit"), call("broad_phase"), call("narrow_phase"), effect};
    return refusal(declaration);
  };
  CHECK(with(call("spin", {{"speed", {1}, ""}})) == "spin: has no setting \"speed\"");
  CHECK(with(call("spin", {{"axis", {0, 0, 0}, ""}})) == "spin: its axis has no direction");
  CHECK(with(call("spin", {{"axis", {0, 1}, ""}})) == "spin: \"axis\" must be three numbers");
  CHECK(with(call("spin", {}, "nobody")) == "spin: there is no body called nobody");
  CHECK(with(call("spin", {}, "floor")) == "spin: floor is fixed");
  CHECK(with(call("spin", {{"turns_per_second", {kNaN}, ""}})) == "spin: \"turns_per_second\" is out of range");
  CHECK(with(call("path", {}, "a")) == "path: \"places\" must be a list of places");
  CHECK(with(call("drag")) == "drag: needs a \"body\"");
  CHECK(with(call("refit", {{"strategy", {}, "guess"}})) ==
        "refit: \"strategy\" is none of rotated_box, loose, rebuild, hill_climb");
  CHECK(with(call("shadow", {{"light", {0, 1, 0}, ""}})) == "shadow: the light does not come from above");
  CHECK(with(call("shadow", {{"light", {0, -1e-200, 0}, ""}})) == "shadow: the light does not come from above");
  CHECK(with(call("trail", {{"length", {2.5}, ""}})) == "trail: \"length\" must be a whole number");
  CHECK(with(call("trail", {{"length", {-4}, ""}})) == "trail: \"length\" is out of range");
  CHECK(with(call("trail", {{"length", {kNaN}, ""}})) == "trail: \"length\" is out of range");
  CHECK(with(call("bounce", {{"restitution", {1.5}, ""}})) == "bounce: \"restitution\" is out of range");
  Body capsule{.name = "c", .shape = scene::Volume3(Capsule<double, 3>{V3::Zero(), V3::UnitX(), 1})};
  CHECK(refusal({.bodies = {capsule},
                 .effects = {call("refit"), call("broad_phase"), call("narrow_phase"), call("bounce")}}) ==
        "bounce: has impulses for spheres and boxes alone; give c such a shape");
}

TEST_CASE("all that is wrong with a scene is told at once, each in its line") {
  Declaration broken{
      .bodies = {named("a", ball(1, V3::Zero(), -1)), named("b", ball(1, {5, 0, 0}))},
      .effects = {call("spin", {{"axis", {1}, "", 21}, {"speed", {1}, "", 22}, {"degrees", {-1}, "", 23}}, "a"),
                  call("explode"), call("shadow", {{"ground", {kNaN}, "", 0}}), call("fall"), call("fall")}};
  for (EffectCall& effect : broken.effects) effect.line = 12;
  std::vector<std::string> says;
  for (const InputError& fault : scene::faults_in(broken)) says.push_back(fault.message());
  CHECK(says == std::vector<std::string>{
                    "a: its mass is negative", "line 12: there is no effect called \"explode\"",
                    "line 12: fall is called for twice", "line 21: spin: \"axis\" must be three numbers",
                    "line 23: spin: \"degrees\" is out of range", "line 22: spin: has no setting \"speed\"",
                    "line 12: shadow: \"ground\" is out of range"});
  const Declaration sound{.bodies = {named("a", ball(1, V3::Zero()))}, .effects = {call("spin")}};
  CHECK(scene::faults_in(sound).empty());
  CHECK(scene::faults_in({.effects = {call("cull"), call("bounce")}}).size() >= 3);
}

TEST_CASE("an effect runs when its inputs changed, and is skipped when not") {
  Declaration declaration{.bodies = {named("a", ball(1, V3::Zero())), named("b", ball(1, {5, 0, 0}))},
                          .effects = {call("path", {{"places", {0, 0, 0, 1, 0, 0}, ""}, {"speed", {6}, ""}}, "a"),
                                      call("refit"), call("broad_phase"), call("narrow_phase"),
                                      call("projection_rays")}};
  Scene scene = opened(declaration);
  scene.go(100);  // it arrives after ten frames; the last run finds it there
  const std::int64_t runs = tally(scene, "path a").run;
  CHECK(runs >= 10);
  CHECK(runs <= 12);
  for (const char* reader : {"refit", "broad_phase", "narrow_phase", "projection_rays"}) {
    CHECK(tally(scene, reader).constructed == 1);
    CHECK(tally(scene, reader).run == runs);
    CHECK(tally(scene, reader).skipped == 100 - runs);
  }
  CHECK(scene.resting());
  CHECK_FALSE(scene.changed());
}

TEST_CASE("an effect that is off changes nothing but its own row and what reads it") {
  Declaration declaration{.bodies = {named("a", ball(1, V3::Zero()))},
                          .effects = {call("spin"), call("refit"), call("trail"), call("shadow")}};
  Scene scene = opened(declaration), without = opened(declaration);
  without.turn(1, false);
  scene.go(30), without.go(30);
  for (const char* name : {"spin", "trail", "shadow"}) {
    CHECK(tally(scene, name).run == tally(without, name).run);
    CHECK(tally(scene, name).skipped == tally(without, name).skipped);
  }
  CHECK(tally(scene, "refit").run == 30);
  CHECK(tally(without, "refit").run == 0);
  CHECK(tally(without, "refit").skipped == 0);
  CHECK(scene.world().hash() == without.world().hash());
  without.turn(0, false);
  without.go(60);
  CHECK(tally(without, "shadow").run == 30);
  CHECK(without.resting());
}

TEST_CASE("time is taken with the clock that is passed in") {
  Declaration declaration{.bodies = {ball(1, V3::Zero())}, .effects = {call("spin")}};
  Scene timed = opened(declaration, ticking), untimed = opened(declaration);
  timed.go(4), untimed.go(4);
  CHECK(tally(timed, "spin").nanoseconds == 20);
  CHECK(tally(untimed, "spin").nanoseconds == 0);
}
