// A scene that runs: frame by frame, only what it calls for, and of that only what has something new to read.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scene/schedule.hpp"

namespace snug::scene {

/// Nanoseconds of a clock that only goes forward. This room knows no clock of its own.
using Clock = double (*)();

/// What one effect did, since the scene was opened; going back does not take it back.
struct Tally {
  std::string effect;  // its name, and the body's where it is about one
  int constructed = 0;
  std::int64_t run = 0;
  std::int64_t skipped = 0;  // its inputs had not changed
  double nanoseconds = 0;    // 0 without a clock
  bool on = true;
};

class Scene {
 public:
  /// Errors: of check, of plan, and what an effect refuses of its settings, each by name and line. kinds: catalogue(),
  /// but for tests.
  [[nodiscard]] static tl::expected<Scene, InputError> open(const Declaration& declaration, Clock clock = nullptr,
                                                            std::span<const EffectKind> kinds = catalogue());

  /// The next frame.
  void step();
  /// To a frame, 0 for the beginning: from the nearest snapshot before it, or from where the scene stands, whichever is
  /// nearer. Frames are taken again from there, to the same bits.
  void go(int frame);
  /// The frame from which go would take frames.
  [[nodiscard]] int start_of(int frame) const;
  [[nodiscard]] int frame() const { return world_.state.frame; }
  [[nodiscard]] const World& world() const { return world_; }
  [[nodiscard]] std::span<const Tally> tallies() const { return tallies_; }
  /// Whether the last frame ran nothing: the next one will not either, and none need be drawn.
  [[nodiscard]] bool resting() const { return resting_; }
  /// Whether the last frame changed anything that can be seen.
  [[nodiscard]] bool changed() const { return changed_; }
  /// From the frame that stands, an effect does not run, or runs again; what reads it sees nothing new while it is off.
  /// The scene keeps when that was, and what was to be turned in later frames is forgotten. effect: its place in
  /// tallies().
  void turn(std::size_t effect, bool on);
  /// Where drag pulls. Frames that were taken with another point are taken anew when gone back to.
  void pull_to(const V3& point);

 private:
  struct Runner {
    const EffectKind* kind;
    std::unique_ptr<Effect> effect;
    std::array<std::uint64_t, kSlots> seen{};  // revisions when it last ran
    bool ran = false;                          // ever, in this line of frames
  };
  struct Snapshot {
    physics::Moving moving;
    State state;
    std::vector<std::array<std::uint64_t, kSlots>> seen;
    std::vector<bool> ran;
    bool resting = false;
    int set = 0;  // what was set from outside when it was taken, by number
    std::size_t bytes = 0;
  };
  struct Turn {
    int frame = 0;
    std::size_t effect = 0;
    bool on = true;
  };
  Scene() = default;
  [[nodiscard]] bool has_something_new(const Runner& runner) const;
  void run(std::size_t i);
  void keep_snapshot();
  void take_snapshot();
  void set_anew();
  void turn_due();
  [[nodiscard]] std::size_t snapshot_before(int frame) const;
  void restore(const Snapshot& snapshot);

  World world_;
  std::vector<Runner> runners_;
  std::vector<Tally> tallies_;
  std::vector<Snapshot> snapshots_;  // by rising frame, the beginning first
  std::vector<Turn> turns_;          // by rising frame
  int set_ = 0;                      // how often pull_to changed something
  int every_ = 16;                   // frames between snapshots
  Clock clock_ = nullptr;
  bool resting_ = false;
  bool changed_ = true;
};

}  // namespace snug::scene
