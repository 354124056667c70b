// The player of a lesson: the methods in its slots, their runs on the stage, and the place in the timeline.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/session/stage.hpp"

namespace snug::lesson {

/// What follows the player: what is asked of the run in slot 0.
class PlayerFollower {
 public:
  /// There is another run. entered: whether in another situation. Returns whether something is asked at its beginning.
  virtual bool follow(bool entered) = 0;

 protected:
  ~PlayerFollower() = default;
};

class Player final : public StageFollower {
 public:
  Player(const Lesson& lesson, Stage& stage);

  // ---- the methods ------------------------------------------------------------------------------------------
  /// Slot 0 is the main one, for the timeline, sentence and pseudocode; slot 1 is for comparison, or null.
  [[nodiscard]] const Method* method(int slot) const { return slots_[slot].method; }
  [[nodiscard]] const Run& run(int slot) const { return *slots_[slot].run; }
  /// The view of a slot that has a method.
  [[nodiscard]] View view(int slot = 0) const;
  /// An empty name clears slot 1; slot 0 must have one. Errors: too many points for it; unknown name.
  Done choose(int slot, std::string_view name);
  /// The lesson's own pseudocode of that slot's method, or the catalogue's.
  [[nodiscard]] std::span<const std::string_view> pseudocode(int slot) const { return slots_[slot].pseudocode; }
  [[nodiscard]] std::vector<Switch> switches() const;
  /// What a tap on a part's control does. At the start of the run a part that is optional is added to what the subject
  /// calls for, or taken out; one that is not called for is added at any step. Else it is switched off from the current
  /// step on, or on again for all steps; grades ignore that. Returns false if that is impossible.
  bool toggle(const Switch& part);
  [[nodiscard]] bool can_toggle(const Switch& part) const { return step_ > 0 || !part.on || part.optional; }
  /// Pushes what is at a handle at the current step, as one entry of undo. Returns false if that is impossible.
  bool push(Index i);

  // ---- the place --------------------------------------------------------------------------------------------
  /// The number of steps shown of slot 0: 0 is before the first, steps() after the last. Session::go changes it.
  [[nodiscard]] int step() const { return step_; }
  [[nodiscard]] int steps() const { return run(0).steps(); }
  /// The step of a slot: slot 1 is at the same fraction of its own run.
  [[nodiscard]] int step_of(int slot) const;
  /// Whether the result is shown before the player was used, in a lesson that starts at its end. Edits do not change
  /// that. No question counts as passed: stepping forward or playing shows step 1, and scrubbing back stops at the
  /// first question. A question before step 1 stops both.
  [[nodiscard]] bool previewing() const { return previewing_; }
  /// Whether nobody has used it yet.
  [[nodiscard]] bool fresh() const { return fresh_; }
  /// Whether the whole run has been shown.
  [[nodiscard]] bool over() const { return step_ == steps() && !previewing_; }
  /// The steps that matter, and the questions, in the timeline's order.
  [[nodiscard]] const std::vector<Mark>& marks() const { return marks_; }
  /// The next or previous mark, or the end or start.
  [[nodiscard]] int next_mark() const;
  [[nodiscard]] int previous_mark() const;
  /// A number that changes with whatever a view shows of it, besides what is asked.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

  // ---- what is there at the place ---------------------------------------------------------------------------
  /// The line of the pseudocode that the step just done belongs to; -1 before the first.
  [[nodiscard]] int line() const { return step_ > 0 ? run(0).line(step_ - 1) : -1; }
  /// The volume; null if there is none.
  [[nodiscard]] const fit::Volume3* volume(int slot) const;
  /// The handles that support the volume: those that it touches by construction, or the result's support set at the
  /// end. None if the slot has no method.
  [[nodiscard]] std::vector<Index> support(int slot) const;
  /// What is proven so far; at the end, the result's certificate.
  [[nodiscard]] std::vector<Proof> proofs(int slot = 0) const;

  // ---- results: computed when first needed after an edit ----------------------------------------------------
  /// Every method that the lesson offers, with its result.
  [[nodiscard]] const std::vector<Rival>& rivals() const;
  /// The figures of one of the lesson's methods at the end of its run. None if it cannot take these points, or if they
  /// wait until a drag is over. Whether they are hidden is for Telling to say.
  [[nodiscard]] const std::vector<Figure>& result(const Method& of) const;
  /// What a task's requirements say of the stage; while results wait for the hand to rest, as it was before the drag.
  [[nodiscard]] const Grade& judged(std::size_t task) const;
  /// The hash of slot 0's run.
  [[nodiscard]] std::uint64_t trace_hash() const;

 private:
  friend class Session;
  friend class Conversation;  // which leads it from question to question

  struct Used {
    const Method* method = nullptr;
    std::unique_ptr<Run> run;
    std::vector<std::string_view> pseudocode;
  };
  /// Where it stood in a situation when another was shown.
  struct Left {
    const Method* method = nullptr;
    int step = 0;
    bool previewing = false;
  };

  [[nodiscard]] const Method* method_for(int slot, const Subject& next) const override;
  void make_room(const Subject& next) override;
  void follow(bool entered, Preparation* ready) override;
  void begin_task(const Task& task) override;
  void rest() override;
  Done begin();
  void enter(const Left& left);
  void use(int slot, const Method* method);
  void run_again(int slot, Preparation* ready = nullptr);
  bool run_changed(bool at_end, bool entered = false);
  /// Stands at a step. Returns false if it stands there already.
  bool set_step(int step);
  /// Marks the run up to a step, and these places of questions.
  void mark(const std::vector<int>& questions, int last);
  void forget_grades() { grades_.assign(grades_.size(), std::nullopt); }
  /// Whether the results at the end of runs, and grades, wait until the hand rests.
  [[nodiscard]] bool waits() const;

  const Lesson* lesson_;
  Stage* stage_;
  PlayerFollower* questions_ = nullptr;
  std::array<Used, 2> slots_;
  std::vector<Left> left_;  // by situations
  int step_ = 0;
  bool previewing_ = false;
  bool fresh_ = true;
  std::vector<Mark> marks_;
  mutable std::optional<std::vector<Rival>> rivals_;
  mutable std::map<const Method*, std::vector<Figure>> results_;
  mutable std::vector<std::optional<Grade>> grades_;  // one for each task
  mutable std::optional<std::uint64_t> hash_;
  std::uint64_t revision_ = 0;
};

}  // namespace snug::lesson
