#include "scene/scene.hpp"

#include <algorithm>

namespace snug::scene {
namespace {

constexpr std::size_t kMostSnapshots = 64;  // of 2,000 bodies, about 1 MB each

/// What velocities and contacts come from.
constexpr SlotSet kLoop = slots(Slot::kVelocities, Slot::kVolumes, Slot::kPairs, Slot::kContacts);

SlotSet made_by(const EffectKind& kind) { return kind.writes | kind.revises; }

/// Whether it runs in that round of a frame: what velocities and contacts come from in each, what leads bodies by time
/// alone in the first, and what only looks at them in the last.
bool is_of_round(const EffectKind& kind, int round, int rounds) {
  const SlotSet made = made_by(kind);
  if ((made & kLoop) != 0 || has(kind.reads, Slot::kVelocities)) return true;
  return has(made, Slot::kPoses) ? round == 0 : round == rounds - 1;
}

}  // namespace

tl::expected<Scene, InputError> Scene::open(const Declaration& declaration, Clock clock,
                                            std::span<const EffectKind> kinds) {
  if (auto sound = check(declaration); !sound) return tl::unexpected(std::move(sound.error()));
  auto planned = plan(declaration.effects, kinds);
  if (!planned) return tl::unexpected(std::move(planned.error()));
  Scene scene;
  scene.world_ = world_of(declaration);
  scene.clock_ = clock;
  for (const Planned& one : *planned) {
    auto effect = one.kind->make(one.call, scene.world_);
    if (!effect) return tl::unexpected(std::move(effect.error()));
    scene.runners_.push_back({one.kind, *std::move(effect)});
    scene.tallies_.push_back(
        {.effect = one.call.name + (one.call.body.empty() ? "" : " " + one.call.body), .constructed = 1});
  }
  scene.keep_snapshot();
  return scene;
}

bool Scene::has_something_new(const Runner& runner) const {
  if (!runner.ran) return true;
  const EffectKind& kind = *runner.kind;
  const SlotSet all = kind.reads | kind.reads_last | kind.revises;
  for (std::size_t i = 0; i < kSlots; ++i) {
    const auto slot = static_cast<Slot>(i);
    if (has(all, slot) && slot != Slot::kTime && world_.state.revisions[i] != runner.seen[i]) return true;
  }
  return has(all, Slot::kTime) && !runner.effect->idle(world_);
}

void Scene::run(std::size_t i) {
  const double start = clock_ != nullptr ? clock_() : 0;
  runners_[i].effect->run(world_);
  if (clock_ != nullptr) tallies_[i].nanoseconds += clock_() - start;
  runners_[i].seen = world_.state.revisions;
  runners_[i].ran = true;
}

void Scene::step() {
  State& state = world_.state;
  const auto before = state.revisions;
  ++state.frame;
  state.changed(Slot::kTime);
  std::vector<bool> ran(runners_.size(), false);
  for (int round = 0; round < world_.rounds; ++round)
    for (std::size_t i = 0; i < runners_.size(); ++i)
      if (tallies_[i].on && is_of_round(*runners_[i].kind, round, world_.rounds) && has_something_new(runners_[i]))
        run(i), ran[i] = true;
  for (std::size_t i = 0; i < runners_.size(); ++i)
    if (tallies_[i].on) ++(ran[i] ? tallies_[i].run : tallies_[i].skipped);
  resting_ = std::find(ran.begin(), ran.end(), true) == ran.end();
  changed_ = !std::equal(before.begin() + 1, before.end(), state.revisions.begin() + 1);  // but for time
  keep_snapshot();
}

void Scene::take_snapshot() {
  Snapshot snapshot{world_.moving(), world_.state, {}, {}, resting_, set_};
  for (const Runner& runner : runners_) snapshot.seen.push_back(runner.seen), snapshot.ran.push_back(runner.ran);
  snapshots_.push_back(std::move(snapshot));
}

/// Something was set from outside: the frames from here on are others, and this one is what they begin from.
void Scene::set_anew() {
  ++set_;
  resting_ = false;
  std::erase_if(snapshots_, [&](const Snapshot& one) {
    return one.state.frame >= world_.state.frame || one.state.frame % every_ != 0;
  });
  take_snapshot();
}

/// Every so many frames, and where there are too many, every other one is dropped.
void Scene::keep_snapshot() {
  const int frame = world_.state.frame;
  if (frame % every_ != 0 || (!snapshots_.empty() && snapshots_.back().state.frame >= frame)) return;
  take_snapshot();
  if (snapshots_.size() <= kMostSnapshots) return;
  every_ *= 2;
  std::erase_if(snapshots_, [&](const Snapshot& one) { return one.state.frame % every_ != 0; });
}

void Scene::restore(const Snapshot& snapshot) {
  world_.restore(snapshot.moving);
  world_.state = snapshot.state;
  resting_ = snapshot.resting;
  for (std::size_t i = 0; i < runners_.size(); ++i) {
    runners_[i].seen = snapshot.seen[i];
    runners_[i].ran = snapshot.ran[i];
    runners_[i].effect->restored(world_);
  }
}

void Scene::go(int frame) {
  frame = std::max(frame, 0);
  if (frame < world_.state.frame) {
    const auto after = std::upper_bound(snapshots_.begin(), snapshots_.end(), frame,
                                        [](int wanted, const Snapshot& one) { return wanted < one.state.frame; });
    if ((after - 1)->set != set_) {  // what was taken after it does not follow from it any more
      snapshots_.erase(after, snapshots_.end());
      snapshots_.back().set = set_;
      restore(snapshots_.back());
    } else {
      restore(*(after - 1));
    }
    changed_ = true;
  }
  while (world_.state.frame < frame) step();
}

void Scene::turn(std::size_t effect, bool on) {
  if (tallies_[effect].on == on) return;
  tallies_[effect].on = on;
  // What it led away, or no longer tells of, may have held up a sleeper.
  if ((made_by(*runners_[effect].kind) & (kLoop | bit(Slot::kPoses))) != 0)
    for (Motion& motion : world_.bodies) motion.wake();
  set_anew();
}

void Scene::pull_to(const V3& point) {
  world_.pulled_to = point;
  for (Motion& motion : world_.bodies) motion.wake();
  set_anew();
}

}  // namespace snug::scene
