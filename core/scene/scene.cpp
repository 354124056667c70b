#include "scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "scene/bytes.hpp"

namespace snug::scene {
namespace {

// Enough for a snapshot every 16 frames with 2,000 bodies and 2,000 frames, if bodies do not bounce.
constexpr std::size_t kMostSnapshotBytes = 80 << 20;

std::size_t bytes_of(const physics::Moving& moving, const State& state) {
  return bytes_in(moving.bodies) + bytes_in(moving.contacts) + bytes_in(moving.impulses) + bytes_in(state.volumes) +
         bytes_in(state.pairs) + bytes_in(state.near) + bytes_in(state.visibility) + bytes_in(state.shadows) +
         bytes_in(state.trails) + bytes_in(state.rays) + bytes_in(state.sweep.bodies);
}

/// The slots that velocities and contacts depend on.
constexpr SlotSet kLoop = slots(Slot::kVelocities, Slot::kVolumes, Slot::kPairs, Slot::kContacts);

/// The velocity at which a body rises by half its reach; without gravity, by twice its reach in a second.
V3 hop_of(const World& world, std::size_t body) {
  const double reach = world.members[body].shape.reach, pull = world.gravity.norm();
  if (pull == 0) return V3::UnitY() * (2 * reach);
  return -world.gravity * (std::sqrt(pull * reach) / pull);
}

SlotSet made_by(const EffectKind& kind) { return kind.writes | kind.revises; }

/// Whether an effect runs in a round of a frame. Effects that velocities and contacts depend on run in every round,
/// those that move bodies by time alone in the first, and those that only read in the last.
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
    if (!effect) return tl::unexpected(std::move(effect.error().front()));
    scene.runners_.push_back({one.kind, *std::move(effect)});
    scene.tallies_.push_back(
        {.effect = one.call.name + (one.call.body.empty() ? "" : " " + one.call.body), .constructed = 1});
  }
  scene.keep_snapshot();
  return scene;
}

std::vector<InputError> faults_in(const Declaration& declaration, std::span<const EffectKind> kinds) {
  std::vector<InputError> all = declaration_faults(declaration);
  const auto add = [&](std::vector<InputError> more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  add(plan_faults(declaration.effects, kinds));
  World world = world_of(with_sound_bodies(declaration));
  for (const Planned& one : known_calls(declaration.effects, kinds))
    if (auto effect = one.kind->make(one.call, world); !effect) add(std::move(effect.error()));
  return all;
}

/// Whether there is something new for an effect, and what.
Deed Scene::look_at(const Runner& runner) const {
  const EffectKind& kind = *runner.kind;
  const SlotSet all = kind.reads | kind.reads_last | kind.revises;
  if (!runner.ran) return {Deed::Kind::kRan, true, all};
  Deed deed{Deed::Kind::kSkipped};
  for (std::size_t i = 0; i < kSlots; ++i) {
    const auto slot = static_cast<Slot>(i);
    if (has(all, slot) && slot != Slot::kTime && world_.state.revisions[i] != runner.seen[i]) deed.news |= bit(slot);
  }
  if (has(all, Slot::kTime) && !runner.effect->idle(world_)) deed.news |= bit(Slot::kTime);
  if (deed.news != 0) deed.kind = Deed::Kind::kRan;
  return deed;
}

void Scene::run(std::size_t i) {
  const double start = clock_ != nullptr ? clock_() : 0;
  runners_[i].effect->run(world_);
  if (clock_ != nullptr) tallies_[i].nanoseconds += clock_() - start;
  runners_[i].seen = world_.state.revisions;
  runners_[i].ran = true;
}

/// Applies the switches that are due in the current frame.
void Scene::turn_due() {
  for (const Turn& turn : turns_) {
    if (turn.frame != world_.state.frame) continue;
    tallies_[turn.effect].on = turn.on;
    // A sleeping body may rest on something that this effect moved, or no longer reports.
    if ((made_by(*runners_[turn.effect].kind) & (kLoop | bit(Slot::kPoses))) != 0)
      for (Motion& motion : world_.bodies) motion.wake();
  }
}

void Scene::step() {
  turn_due();
  State& state = world_.state;
  const auto before = state.revisions;
  ++state.frame;
  state.changed(Slot::kTime);
  push_due();
  run_rounds();
  const auto ran = [](const Deed& deed) { return deed.kind == Deed::Kind::kRan; };
  for (std::size_t i = 0; i < runners_.size(); ++i)
    if (tallies_[i].on) ++(ran(deeds_[i]) ? tallies_[i].run : tallies_[i].skipped);
  resting_ = std::none_of(deeds_.begin(), deeds_.end(), ran);
  changes_ = 0;
  for (std::size_t i = 0; i < kSlots; ++i)
    if (const auto slot = static_cast<Slot>(i); slot != Slot::kTime && state.revisions[i] != before[i])
      changes_ |= bit(slot);
  changed_ = changes_ != 0;
  keep_snapshot();
}

/// Runs the effects with changed inputs, in every round of the frame, and records what each did.
void Scene::run_rounds() {
  deeds_.assign(runners_.size(), {});
  for (int round = 0; round < world_.rounds; ++round)
    for (std::size_t i = 0; i < runners_.size(); ++i) {
      Deed& whole = deeds_[i];
      if (!tallies_[i].on) whole.kind = Deed::Kind::kOff;
      if (!tallies_[i].on || !is_of_round(*runners_[i].kind, round, world_.rounds)) continue;
      const Deed deed = look_at(runners_[i]);
      whole = {std::max(whole.kind, deed.kind), whole.first || deed.first, whole.news | deed.news};
      if (deed.kind == Deed::Kind::kRan) run(i);
    }
}

void Scene::take_snapshot() {
  Snapshot snapshot{world_.moving(), world_.state, {}, {}, resting_, set_, bytes_of(world_.moving(), world_.state)};
  for (const Runner& runner : runners_) {
    snapshot.seen.push_back(runner.seen);
    snapshot.ran.push_back(runner.ran);
  }
  snapshots_.push_back(std::move(snapshot));
}

/// Called when something was set from outside: the frames from here on change, and this frame is their start.
void Scene::set_anew() {
  ++set_;
  resting_ = false;
  std::erase_if(snapshots_, [&](const Snapshot& one) {
    return one.state.frame >= world_.state.frame || one.state.frame % every_ != 0;
  });
  take_snapshot();
}

/// Takes a snapshot every `every_` frames. If snapshots take too much memory, drops every other one.
void Scene::keep_snapshot() {
  const int frame = world_.state.frame;
  if (frame % every_ != 0 || (!snapshots_.empty() && snapshots_.back().state.frame >= frame)) return;
  take_snapshot();
  std::size_t bytes = 0;
  for (const Snapshot& one : snapshots_) bytes += one.bytes;
  if (bytes <= kMostSnapshotBytes) return;
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
  for (EffectTally& tally : tallies_) tally.on = true;
  for (const Turn& turn : turns_)
    if (turn.frame <= world_.state.frame) tallies_[turn.effect].on = turn.on;
  changed_ = true;
}

std::size_t Scene::snapshot_before(int frame) const {
  const auto after = std::upper_bound(snapshots_.begin(), snapshots_.end(), frame,
                                      [](int wanted, const Snapshot& one) { return wanted < one.state.frame; });
  return after - snapshots_.begin() - 1;
}

int Scene::start_of(int frame) const {
  const int snapshot = snapshots_[snapshot_before(frame)].state.frame, now = world_.state.frame;
  return now <= frame ? std::max(snapshot, now) : snapshot;
}

void Scene::go(int frame) {
  frame = std::max(frame, 0);
  const std::size_t i = snapshot_before(frame);
  if (start_of(frame) != world_.state.frame) {
    if (snapshots_[i].set != set_) {  // the frames after it no longer follow from it
      snapshots_.erase(snapshots_.begin() + static_cast<std::ptrdiff_t>(i) + 1, snapshots_.end());
      snapshots_.back().set = set_;
    }
    restore(snapshots_[i]);
  }
  while (world_.state.frame < frame) step();
}

void Scene::turn(std::size_t effect, bool on) {
  if (tallies_[effect].on == on) return;
  const int now = world_.state.frame;
  tallies_[effect].on = on;
  std::erase_if(turns_, [&](const Turn& one) { return one.frame > now; });
  turns_.push_back({now, effect, on});
  forget_after_now();
}

/// The frames after this one will be others.
void Scene::forget_after_now() {
  std::erase_if(snapshots_, [&](const Snapshot& one) { return one.state.frame > world_.state.frame; });
  resting_ = false;
}

std::vector<const EffectKind*> Scene::kinds() const {
  std::vector<const EffectKind*> kinds;
  for (const Runner& runner : runners_) kinds.push_back(runner.kind);
  return kinds;
}

bool Scene::push(std::size_t body) {
  const auto moves_bodies = [](const Runner& runner) { return has(runner.kind->reads, Slot::kVelocities); };
  if (!world_.members[body].moves() || std::none_of(runners_.begin(), runners_.end(), moves_bodies)) return false;
  std::erase_if(pushes_, [&](const Push& one) { return one.frame > world_.state.frame; });
  pushes_.push_back({world_.state.frame, body});
  forget_after_now();
  return true;
}

/// Gives each body that was pushed in the frame before this one its speed.
void Scene::push_due() {
  for (const Push& push : pushes_) {
    if (push.frame + 1 != world_.state.frame) continue;
    world_.bodies[push.body].wake();
    world_.bodies[push.body].velocity += hop_of(world_, push.body);
    world_.state.changed(Slot::kVelocities);
  }
}

void Scene::pull_to(const V3& point) {
  world_.pulled_to = point;
  for (Motion& motion : world_.bodies) motion.wake();
  set_anew();
}

}  // namespace snug::scene
