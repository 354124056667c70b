// A running scene: in each frame, only the effects that it calls for, and of these only those with changed inputs.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scene/schedule.hpp"

namespace snug::scene {

/// Nanoseconds of a clock that never goes back. This room has no clock itself.
using Clock = double (*)();

/// What one effect did since the scene was opened; going back to an earlier frame does not reset it.
struct EffectTally {
  std::string effect;  // its name, and the body's if it is about one
  int constructed = 0;
  std::int64_t run = 0;
  std::int64_t skipped = 0;  // frames in which its inputs had not changed
  double nanoseconds = 0;    // 0 without a clock
  bool on = true;
};

/// What an effect did in a frame, and what was new of all that it reads.
struct Deed {
  enum class Kind : std::uint8_t { kNone, kOff, kSkipped, kRan } kind = Kind::kNone;
  bool first = false;  // it had not run before, so that everything was new
  SlotSet news = 0;
};

class Scene {
 public:
  /// Errors: those of check and plan, and settings that an effect refuses, each with name and line. kinds: catalogue(),
  /// except in tests.
  [[nodiscard]] static tl::expected<Scene, InputError> open(const Declaration& declaration, Clock clock = nullptr,
                                                            std::span<const EffectKind> kinds = catalogue());

  /// Runs the next frame.
  void step();
  /// Goes to a frame; 0 is the start. Runs frames again from the nearest snapshot before it, or from the current frame,
  /// whichever is nearer, with the same bits.
  void go(int frame);
  /// The frame from which go(frame) would start.
  [[nodiscard]] int start_of(int frame) const;
  [[nodiscard]] int frame() const { return world_.state.frame; }
  [[nodiscard]] const World& world() const { return world_; }
  [[nodiscard]] std::span<const EffectTally> tallies() const { return tallies_; }
  /// The effects in the order in which a frame runs them, which is that of tallies() and deeds().
  [[nodiscard]] std::vector<const EffectKind*> kinds() const;
  /// What each effect did in the last step.
  [[nodiscard]] std::span<const Deed> deeds() const { return deeds_; }
  /// The slots whose content the last step changed. Time is not counted.
  [[nodiscard]] SlotSet changes() const { return changes_; }
  /// Whether the last frame ran nothing. Then the next ones will not either, and need not be drawn.
  [[nodiscard]] bool resting() const { return resting_; }
  /// Whether the last frame changed anything visible.
  [[nodiscard]] bool changed() const { return changed_; }
  /// Switches an effect off or on from the current frame; while it is off, its readers see no changes.
  /// The scene remembers the frame, and forgets switches in later frames. effect: its index in
  /// tallies().
  void turn(std::size_t effect, bool on);
  /// Lets a body hop, at the start of the next frame: it gets the speed against gravity that takes it up by half its
  /// reach, and wakes. The scene remembers the frame, and forgets pushes in later frames. Returns false if velocities
  /// do not move the body.
  bool push(std::size_t body);
  /// Sets the point that drag pulls to. Frames computed with another point are computed again when gone back to.
  void pull_to(const V3& point);

 private:
  struct Runner {
    const EffectKind* kind;
    std::unique_ptr<Effect> effect;
    std::array<std::uint64_t, kSlots> seen{};  // revisions when it last ran
    bool ran = false;                          // whether it has run in this sequence of frames
  };
  struct Snapshot {
    physics::Moving moving;
    State state;
    std::vector<std::array<std::uint64_t, kSlots>> seen;
    std::vector<bool> ran;
    bool resting = false;
    int set = 0;  // the value of Scene::set_ when it was taken
    std::size_t bytes = 0;
  };
  struct Turn {
    int frame = 0;
    std::size_t effect = 0;
    bool on = true;
  };
  struct Push {
    int frame = 0;
    std::size_t body = 0;
  };
  Scene() = default;
  [[nodiscard]] Deed look_at(const Runner& runner) const;
  void run_rounds();
  void forget_after_now();
  void run(std::size_t i);
  void keep_snapshot();
  void take_snapshot();
  void set_anew();
  void turn_due();
  void push_due();
  [[nodiscard]] std::size_t snapshot_before(int frame) const;
  void restore(const Snapshot& snapshot);

  World world_;
  std::vector<Runner> runners_;
  std::vector<EffectTally> tallies_;
  std::vector<Snapshot> snapshots_;  // by rising frame, the start first
  std::vector<Turn> turns_;          // by rising frame
  std::vector<Push> pushes_;         // by rising frame
  std::vector<Deed> deeds_;          // in the last step
  SlotSet changes_ = 0;
  int set_ = 0;     // how often pull_to changed something
  int every_ = 16;  // frames between snapshots
  Clock clock_ = nullptr;
  bool resting_ = false;
  bool changed_ = true;
};

/// All for which Scene::open refuses a declaration, and not only the first of it.
[[nodiscard]] std::vector<InputError> faults_in(const Declaration& declaration,
                                                std::span<const EffectKind> kinds = catalogue());

}  // namespace snug::scene
