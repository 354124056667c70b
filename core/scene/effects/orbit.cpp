// orbit: moves bodies around a centre, each at its own distance.
#include <numbers>

#include "geometry/random.hpp"
#include "geometry/turn.hpp"
#include "scene/effect.hpp"

namespace snug::scene {
namespace {

struct Course {
  std::size_t body;
  V3 arm;  // from the centre at the start
  V3 axis;
  double turns;  // per second
};

class Orbit final : public Effect {
 public:
  Orbit(std::vector<Course> courses, World& world, const V3& center) : courses_(std::move(courses)), center_(center) {
    for (const Course& course : courses_) world.members[course.body].driven = true;
  }

  void run(World& world) override {
    const double seconds = world.step * world.state.frame;
    for (const Course& course : courses_) {
      const Matrix<double, 3> rotation = turn(course.axis, 2 * std::numbers::pi * course.turns * seconds);
      world.place(course.body, center_ + turned<double, 3>(rotation, course.arm),
                  world.bodies[course.body].orientation);
    }
    world.state.changed(Slot::kPoses);
  }
  [[nodiscard]] bool idle(const World&) const override {
    for (const Course& course : courses_)
      if (course.turns != 0 && course.arm != V3::Zero()) return false;
    return true;
  }

 private:
  std::vector<Course> courses_;
  V3 center_;
};

}  // namespace

MadeEffect make_orbit(const EffectCall& call, World& world) {
  Settings settings(call, world);
  const auto bodies = settings.bodies();
  const V3 center = settings.vector("center", V3::Zero());
  const V3 axis = settings.vector("axis", V3::UnitY());
  const double turns = settings.number("turns_per_second", 0.05, -100, 100);
  const double vary = settings.number("vary", 0, 0, 1);  // how much speeds and axes differ between bodies, 0 to 1
  if (axis == V3::Zero()) settings.refuse("its axis has no direction");
  Random random(world.seed);
  std::vector<Course> courses;
  for (const std::size_t i : bodies) {
    V3 own = axis;
    for (int k = 0; k < 3; ++k) own[k] += vary * random.between(-1, 1);
    courses.push_back({i, world.bodies[i].position - center, own, turns * (1 + vary * random.between(-1, 1))});
  }
  return settings.make<Orbit>(std::move(courses), world, center);
}

}  // namespace snug::scene
