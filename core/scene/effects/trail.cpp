// trail: the centres of bodies in the last frames in which they moved.
#include <cmath>

#include "scene/effect.hpp"
#include "scene/limits.hpp"

namespace snug::scene {
namespace {

class Trail final : public Effect {
 public:
  Trail(std::vector<std::size_t> bodies, std::size_t length) : bodies_(std::move(bodies)), length_(length) {}

  void run(World& world) override {
    State& state = world.state;
    state.trails.resize(world.size());
    bool longer = false;
    for (const std::size_t i : bodies_) {
      std::vector<V3>& trail = state.trails[i];
      if (!trail.empty() && trail.back() == world.bodies[i].position) continue;
      if (trail.size() == length_) trail.erase(trail.begin());
      trail.push_back(world.bodies[i].position);
      longer = true;
    }
    if (longer) state.changed(Slot::kTrails);
  }

 private:
  std::vector<std::size_t> bodies_;
  std::size_t length_;
};

}  // namespace

MadeEffect make_trail(const EffectCall& call, World& world) {
  Settings settings(call, world);
  auto bodies = settings.bodies();
  const double length = settings.number("length", limits::kTrailPlaces, 2, 10000);  // frames
  if (length != std::floor(length)) settings.refuse("\"length\" must be a whole number");
  return settings.make<Trail>(std::move(bodies), static_cast<std::size_t>(length));
}

}  // namespace snug::scene
