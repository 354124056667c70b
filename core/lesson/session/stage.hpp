// The stage of a lesson: what stands on it, as the student has edited it, in each situation, with sliders and undo.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lesson/session/log.hpp"
#include "lesson/sliders.hpp"
#include "lesson/subject.hpp"

namespace snug::lesson {

class Preparation;

/// How answers are taken. An exercise lets the student decide in the algorithm's place: choosing an answer gives it,
/// the run goes on by itself to what is decided next, and what stands on the stage cannot be changed; or it lets the
/// student build on what stands there, which nothing else can replace.
struct Conduct {
  bool decides = false;  // whether it is such an exercise; and then
  bool told = true;      // whether each answer is told at once, or all of them at the end
  bool builds = false;   // whether something is built
};

/// What follows the stage: the runs on it.
class StageFollower {
 public:
  /// The method that a slot would have with the next subject: one that cannot take it gives way. Null for none.
  [[nodiscard]] virtual const Method* method_for(int slot, const Subject& next) const = 0;
  /// The next subject is about to come: the slots get those methods.
  virtual void make_room(const Subject& next) = 0;
  /// It stands there. entered: whether in another situation. ready: what was computed of it; null for nothing.
  virtual void follow(bool entered, Preparation* ready) = 0;
  virtual void begin_task(const Task& task) = 0;
  /// A drag is over.
  virtual void rest() = 0;

 protected:
  ~StageFollower() = default;
};

class Stage {
 public:
  /// A situation: as the lesson opens it, and as it was left; null before that.
  struct Situated {
    Snapshot own, left;
  };
  /// situations: the lesson's own first.
  Stage(const Lesson& lesson, std::vector<Situated> situations, Log& log, Clock clock);
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
  ~Stage();

  /// The subject as it is on the stage, and as the lesson opens with it.
  [[nodiscard]] const Subject& subject() const { return *now_; }
  [[nodiscard]] const Subject& own() const { return *opened().subject; }
  [[nodiscard]] Snapshot snapshot() const { return {now_->clone(), slid_}; }
  /// Whether it differs from the lesson's own for this seed, so that an address cannot restore it.
  [[nodiscard]] bool edited() const { return now_->origin().edited; }
  /// Whether it is the lesson's own: then the lesson's words about its own run are true, unless an effect is off.
  [[nodiscard]] bool is_own() const { return now_->origin() == own().origin(); }
  [[nodiscard]] const Conduct& conduct() const { return conduct_; }
  /// A number that changes with whatever a view shows of it, besides what follows it.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

  // ---- situations and sliders -------------------------------------------------------------------------------
  /// The name of the situation that is on the stage.
  [[nodiscard]] const std::string& situation() const { return now_->origin().situation; }
  /// Shows a situation as it was left, as one entry of undo. Errors: there is none of that name.
  Done show_situation(std::string_view name);
  /// Those that were shown, as the lesson opens them, and as they are or were left; the one on the stage is the last.
  [[nodiscard]] std::vector<Situated> visited() const;
  /// The sliders of the situation that is on the stage.
  [[nodiscard]] std::vector<ShownSlider> sliders() const;
  /// The values of all of the lesson's sliders.
  [[nodiscard]] const std::vector<double>& slider_values() const { return slid_.values; }
  [[nodiscard]] bool has_slid() const { return slid_.values != opened().slid.values; }
  /// Moves a slider, by its number among the lesson's. It is an edit like move: between begin_drag and end_drag, all of
  /// its moves are one entry of undo. Errors: there is no such slider here; those of Subject::drive.
  Done slide(std::size_t slider, double value);
  /// The same, to a place of its knob.
  Done slide_to_place(std::size_t slider, int place);
  /// Moves sliders to what slider_values said, as one edit.
  Done set_sliders(std::vector<double> values);

  // ---- edits ------------------------------------------------------------------------------------------------
  // Each reruns the methods at once, and is one entry of undo; a whole drag is one entry. The player stays at its step,
  // or at the last step if the new run is shorter; at the end it stays at the end. Errors: those of the subject; more
  // points than any method of the lesson takes.
  Done move(Index i, const Point3& to);
  Done add(const Point3& at);
  Done remove(Index i);
  Done load(const io::PointFile& file, std::string_view name);
  Done set_generator(std::string_view kind, int count, int dim, std::uint64_t seed);
  Done set_numbers(std::size_t group, std::size_t row, std::span<const double> values);
  Done set_rows(const Rows& rows);
  /// Chooses the scalar of the runs (Subject::set_float).
  Done set_float(bool in_float);
  /// Adds a part to what the subject calls for, or takes it out. Errors: those of Subject::call_for.
  Done call_for(std::string_view name, bool called);
  /// Makes the stage from a text (Subject::set_file). All that is typed without another edit between, up to end_typing,
  /// is one entry of undo.
  Done set_file(std::string text);
  void end_typing() { typing_ = false; }
  Done scatter(std::uint64_t seed);
  /// What that would put on the stage.
  [[nodiscard]] tl::expected<Snapshot, InputError> scattered(std::uint64_t seed) const;
  /// Replaces the subject by another of the same kind.
  Done become(std::unique_ptr<Subject> next);
  /// Restores the lesson's own; where something is built, what the task begins with.
  Done reset();
  /// Takes what stands there for the lesson's own, from which tasks begin and to which reset goes back.
  void settle();
  void begin_drag();
  /// Errors: those of an edit that waited for the hand to rest.
  Done end_drag();
  [[nodiscard]] bool dragging() const { return drag_.subject != nullptr; }
  [[nodiscard]] bool can_undo() const { return !past_.empty() || drag_moved_; }
  [[nodiscard]] bool can_redo() const { return !future_.empty(); }
  void undo() { restore(Way::kUndo); }
  void redo() { restore(Way::kRedo); }

  // ---- the task in hand -------------------------------------------------------------------------------------
  /// Starts a task of the lesson: sets its points or boxes, its algorithm in slot 0, and shows the result.
  void start_task(std::size_t task = 0);
  /// The task that was started last, or the first one.
  [[nodiscard]] std::size_t task() const { return task_; }
  /// Whether only what it leaves to be moved was changed since it was started.
  [[nodiscard]] bool at_task() const { return task_started_; }
  /// Whether a handle may be moved: some tasks leave a few alone to be moved.
  [[nodiscard]] bool may_move(Index i) const;

  // ---- edits that take long ---------------------------------------------------------------------------------
  /// Whether such an edit goes in pieces, between which a door draws, or at once, as a script needs it. Returns what it
  /// was before.
  bool give_way(bool on) { return std::exchange(gives_way_, on); }
  /// What is being computed for the stage, which shows what was there before until all of it is done; null for nothing.
  /// An edit returns before it is done. A new edit replaces it.
  [[nodiscard]] const Preparation* preparing() const { return waiting_.get(); }
  /// Goes on with it for about so long, ns: one piece at least. Once all is there, it is put on the stage. Errors: it
  /// would take too long, and is given up; those of the edit.
  Done go_on(double ns);
  /// Gives it up: what stands on the stage stays.
  void give_up();

 private:
  friend class Session;  // which connects the parts, and informs the subject
  friend class Player;   // which switches parts of the subject off

  /// What an edit does that may wait: it is new, or comes from the undone ones, or from the redone ones.
  enum class Way { kEdit, kUndo, kRedo };
  [[nodiscard]] const Snapshot& opened() const { return places_[shown_].own; }
  [[nodiscard]] tl::unexpected<InputError> refusal(const Subject& next) const;
  [[nodiscard]] const std::vector<std::string>& only() const { return lesson_->tasks[task_].only; }
  Done edit(auto edit);
  Done keeping_task(auto edit);
  [[nodiscard]] tl::expected<Snapshot, InputError> anew(auto edit) const;
  Done become(Snapshot next);
  Done become(tl::expected<Snapshot, InputError> next);
  /// Whether it differs from what stands on the stage only in what the task in hand leaves to be moved.
  [[nodiscard]] bool keeps_to_task(const Subject& next) const;
  Done prepare(Snapshot next, Way way);
  void take_over(Way way, Snapshot next, Preparation* ready = nullptr);
  Snapshot exchange(Snapshot next, Preparation* ready = nullptr);
  void remember(Snapshot before);
  void forget_undo() { past_.clear(), future_.clear(); }
  void restore(Way way);

  const Lesson* lesson_;
  Log* log_;
  Clock clock_;
  StageFollower* runs_ = nullptr;
  Conduct conduct_;
  std::vector<Situated> places_;
  std::size_t shown_ = 0;  // which of them is on the stage
  std::unique_ptr<Subject> now_;
  Slid slid_;
  std::vector<Snapshot> past_;
  std::vector<Snapshot> future_;
  Snapshot drag_;  // the subject when the drag began
  bool drag_moved_ = false;
  std::optional<Snapshot> at_rest_;  // what sliders lead to once the hand rests
  bool gives_way_ = false;
  std::unique_ptr<Preparation> waiting_;
  Way waiting_way_ = Way::kEdit;
  bool waiting_keeps_ = false;  // task_started_ after it
  bool typing_ = false;         // whether the last edit was typed, and
  bool types_on_ = false;       // whether this one goes on with it
  std::size_t task_ = 0;        // the one in hand
  bool task_started_ = false;   // and whether nothing but what it leaves to be moved was changed since
  std::uint64_t revision_ = 0;
};

/// While it lives, edits are done at once.
class AtOnce {
 public:
  explicit AtOnce(Stage& stage) : stage_(stage), before_(stage.give_way(false)) {}
  ~AtOnce() { stage_.give_way(before_); }
  AtOnce(const AtOnce&) = delete;
  AtOnce& operator=(const AtOnce&) = delete;

 private:
  Stage& stage_;
  bool before_;
};

}  // namespace snug::lesson
