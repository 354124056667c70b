// refit: updates each body's AABB in the world frame, by one of the updates of fit/. Bodies declared as points can use
// any update, and its cost and looseness are figures of the scene.
#include <algorithm>

#include "fit/update/update_rotated_box.hpp"
#include "fit/update/update_sphere.hpp"
#include "fit/update/updates.hpp"
#include "hierarchy/bounds.hpp"
#include "scene/effect.hpp"

namespace snug::scene {
namespace {

/// The AABB of a sphere, a box or vertices with a radius, in constant time.
Aabb<double, 3> plain_box(const Shape& shape, const Pose<double, 3>& pose, bool loose) {
  if (loose || shape.kind == Shape::Kind::kSphere) {
    const V3 reach = V3::Constant(shape.kind == Shape::Kind::kSphere ? shape.radius : shape.reach);
    return {pose.translation - reach, pose.translation + reach};
  }
  return fit::update_rotated_box(Aabb<double, 3>{-shape.half_extents, shape.half_extents}, pose).volume;
}

class Refit final : public Effect {
 public:
  Refit(const World& world, const fit::UpdateStrategy& strategy)
      : loose_(strategy.name == "loose"), updates_(world.size()) {
    for (std::size_t i = 0; i < world.size(); ++i)
      if (const auto& cloud = world.members[i].shape.cloud) {
        updates_[i] = fit::start_updates(strategy, *cloud);
        watched_ = true;
      }
  }

  void run(World& world) override {
    State& state = world.state;
    double measure = 0, tightest = 0;
    if (watched_) state.refitted.cost = 0;
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (done_ > 0 && world.bodies[i].moved <= done_ && !updates_[i]) continue;
      const Pose<double, 3> pose = pose_of(world.bodies[i]);
      if (!updates_[i]) {
        state.volumes[i] = plain_box(world.members[i].shape, pose, loose_);
        continue;
      }
      const fit::UpdatedFrame frame = updates_[i](pose, {});
      state.volumes[i] = std::visit([](const auto& volume) { return bounds_of(volume); }, frame.volume);
      if (measure == 0) state.refitted.first = frame.volume;
      measure += frame.measure;
      tightest += frame.tightest;
      state.refitted.cost += static_cast<double>(frame.counts[static_cast<std::size_t>(Operation::kPointsTouched)]);
    }
    state.refitted.slack = fit::slack(measure, tightest);
    done_ = world.moves;
    state.changed(Slot::kVolumes);
  }

  /// A climb begins where the last one ended, so it must be reset.
  void restored(World& world) override {
    done_ = 0;
    for (std::size_t i = 0; i < world.size(); ++i)
      if (updates_[i]) updates_[i](pose_of(world.bodies[i]), {});
  }

 private:
  bool loose_, watched_ = false;
  std::vector<fit::UpdateBody> updates_;  // by body; none if the shape is simple
  std::uint64_t done_ = 0;                // World::moves at the last update; 0: none yet
};

}  // namespace

MadeEffect make_refit(const EffectCall& call, World& world) {
  Settings settings(call, world);
  std::vector<std::string_view> volumes, names;
  for (const fit::UpdateStrategy& strategy : fit::update_strategies()) {
    if (!strategy.space) continue;
    if (std::find(volumes.begin(), volumes.end(), strategy.volume) == volumes.end()) volumes.push_back(strategy.volume);
  }
  std::rotate(volumes.begin(), std::find(volumes.begin(), volumes.end(), "aabb"), volumes.end());
  const std::string_view volume = volumes[settings.word("volume", volumes)];
  for (const fit::UpdateStrategy& strategy : fit::update_strategies())
    if (strategy.volume == volume && strategy.space) names.push_back(strategy.name);
  if (volume == "aabb") std::rotate(names.begin(), names.end() - 1, names.end());  // rotated_box first, the cheapest
  const std::string_view name = names[settings.word("strategy", names)];
  return settings.make<Refit>(world, *fit::find_update(volume, name));
}

}  // namespace snug::scene
