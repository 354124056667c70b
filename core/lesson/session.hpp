// A student in a lesson: what stands on the stage as edited, the runs on it, the place in the timeline, the answers
// given. The page and the desktop window are thin views of this; no rule of an exercise is written anywhere else. What
// the stage is about, its subject knows (subject.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "lesson/ask.hpp"
#include "lesson/subject.hpp"

namespace snug::lesson {

class Session {
 public:
  /// mesh: what lesson.points.mesh names, where it names one. clock: by which effects are timed. Errors: as of the
  /// subject's open; no method of the lesson takes as many points.
  [[nodiscard]] static tl::expected<Session, InputError> open(Lesson lesson, std::optional<io::PointFile> mesh = {},
                                                              Clock clock = nullptr);
  // Asked points into the lesson, which a move leaves in place and a copy would not.
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;
  ~Session();  // not inline: this room has no type information, which a sanitizer would look for in other rooms

  [[nodiscard]] const Lesson& lesson() const { return *lesson_; }
  /// What stands on the stage.
  [[nodiscard]] const Subject& subject() const { return *now_; }

  // ---- its handles ------------------------------------------------------------------------------------------
  [[nodiscard]] int dim() const { return now_->dim(); }
  [[nodiscard]] Index size() const { return now_->size(); }
  [[nodiscard]] Point3 point(Index i) const { return now_->at(i); }
  [[nodiscard]] std::string name_of(Index i) const { return now_->name_of(i); }
  [[nodiscard]] std::uint64_t seed() const { return now_->origin().seed; }
  [[nodiscard]] const std::string& source() const { return now_->origin().source; }
  /// Whether it is other than the lesson's own for this seed (an address cannot restore it then).
  [[nodiscard]] bool edited() const { return now_->origin().edited; }

  /// Edits. Each runs the methods anew at once and is one entry of undo; a drag is one entry from begin to end. The
  /// player stays at its step, or at the last one where the new run is shorter; at the end it stays at the end. Errors:
  /// as of the subject's; more points than any method of the lesson takes.
  Done move(Index i, const Point3& to);
  Done add(const Point3& at);
  Done remove(Index i);
  Done load(const io::PointFile& file, std::string_view name);
  Done set_generator(std::string_view kind, int count, int dim, std::uint64_t seed);
  Done set_boxes(const BoxPair& pair);
  void scatter(std::uint64_t seed);
  /// The lesson's own again.
  void reset();
  /// Another of the same subject.
  Done become(std::unique_ptr<Subject> next);
  /// What the task begins with, its algorithm in slot 0, and its result.
  void start_task();
  void begin_drag();
  void end_drag();
  [[nodiscard]] bool can_undo() const { return !past_.empty() || drag_moved_; }
  [[nodiscard]] bool can_redo() const { return !future_.empty(); }
  void undo();
  void redo();
  /// Whether it is the lesson's own: what a lesson says of its own run is true then, unless an effect is off.
  [[nodiscard]] bool is_own() const;
  /// Tells the subject something that changes no run, as what was measured on it: pending answers are decided anew.
  template <class Type, class Tell>
  bool inform(Tell tell) {
    if (as<Type>(*now_) == nullptr) return false;
    tell(static_cast<Type&>(*now_));
    informed();
    return true;
  }

  // ---- the methods ------------------------------------------------------------------------------------------
  /// slot 0 is the main one, which the timeline, sentence and pseudocode speak of; slot 1 stands beside it, or is null.
  [[nodiscard]] const Method* method(int slot) const { return slots_[slot].method; }
  [[nodiscard]] const Run& run(int slot) const { return *slots_[slot].run; }
  /// Of a slot that has a method.
  [[nodiscard]] View view(int slot = 0) const;
  /// An empty name clears slot 1; slot 0 must have one. Errors: too many points for it; unknown name.
  Done choose(int slot, std::string_view name);
  /// The lesson's own pseudocode of that slot's method, or the catalogue's.
  [[nodiscard]] std::span<const std::string_view> pseudocode(int slot) const { return slots_[slot].pseudocode; }
  /// Every method that the lesson offers, with its result. Run when first asked for after an edit.
  [[nodiscard]] const std::vector<Rival>& rivals() const;
  [[nodiscard]] std::vector<Switch> switches() const { return now_->switches(view()); }
  /// Switches a part off from the step that stands, or on again for all. false: that cannot be. Grades know no
  /// switches.
  bool turn(std::string_view name, bool on);

  // ---- the player -------------------------------------------------------------------------------------------
  /// Steps of slot 0: 0 is before the first, steps() is after the last. step() shows the state after that many steps.
  [[nodiscard]] int step() const { return step_; }
  [[nodiscard]] int steps() const { return run(0).steps(); }
  /// Slot 1's place is at the same share of its own run.
  [[nodiscard]] int step_of(int slot) const;
  /// The line of the pseudocode that the step just done belongs to; -1 before the first.
  [[nodiscard]] int line() const { return step_ > 0 ? run(0).line(step_ - 1) : -1; }
  /// The sentence of where it stands.
  [[nodiscard]] std::string caption() const;
  /// The volume as it stands; null where there is none.
  [[nodiscard]] const fit::Volume3* volume(int slot) const {
    return method(slot) != nullptr ? run(slot).volume(step_of(slot)) : nullptr;
  }
  /// The handles that support the volume as it stands: those it touches by construction, or the result's in the end;
  /// none where the slot has no method.
  [[nodiscard]] std::vector<Index> support(int slot) const {
    return method(slot) != nullptr ? run(slot).support(step_of(slot)) : std::vector<Index>{};
  }
  /// Goes to a step; forward only up to the first unanswered question's gate. jump goes past gates: their questions
  /// then count as skipped (an address names a step), and are asked when the player comes to them again.
  void go(int step);
  void jump(int step);
  void first() { go(0); }
  /// The next step; where an outcome is told, it is acknowledged first, and that is all.
  void forward();
  void back() { go(step_ - 1); }
  void last() { go(steps()); }
  /// Whether the result is shown before the player was used: a lesson that starts at its end. Edits keep it so. No
  /// question was passed then: to step forward (or play) shows step 1, to scrub back stops at the first gate. A
  /// question that stands before step 1 stops both.
  [[nodiscard]] bool previewing() const { return previewing_; }
  [[nodiscard]] const std::vector<Mark>& marks() const { return marks_; }
  /// The next or previous mark from here, or the end or start.
  [[nodiscard]] int next_mark() const;
  [[nodiscard]] int previous_mark() const;

  // ---- questions and the task -------------------------------------------------------------------------------
  // A question is a conversation: asked, answered (a wrong answer may have a second try), decided (what was skipped is
  // played), told, and acknowledged; only then the next one is asked.
  /// The question that stands here and has no answer yet, unless an outcome is told; playing waits for it.
  [[nodiscard]] const Asked* asked() const;
  /// Every question of this run in the timeline's order. Questions whose gate the run does not have are left out.
  [[nodiscard]] const std::vector<Asked>& questions() const { return asked_; }
  /// Gives an answer for good and goes to where it is decided, so that what happened stands beside what was predicted.
  /// false: nothing is asked, or that is no answer to it (a handle that is none of the choices); nothing changes then.
  bool answer(const Answer& answer);
  /// Whether what lies between a question and its outcome is played by who shows it, where commit and skip lead there:
  /// they then leave the player where it stands, on its way. Off: they go there at once.
  void play_answers(bool on) { play_answers_ = on; }
  /// Chooses an answer without giving it yet; chosen once more, it is given. Of a question that takes many choices, one
  /// is chosen, or no longer. false: nothing is asked, or that is no answer to it: answer_says tells which are.
  bool pick(const Answer& answer);
  /// A handle by its name, as one types it ("B2", "p7").
  bool pick(std::string_view name);
  /// The answer that is chosen to the question that stands; null where none is.
  [[nodiscard]] const Answer* picked() const;
  void unpick();
  /// Gives the answer that is chosen: a first wrong one is only told to be wrong, where there is a second try. false:
  /// none is chosen.
  bool commit();
  /// Goes on without an answer. false: nothing is asked.
  bool skip();
  /// The key that goes on, at a question: says that a second press skips it, and then skips it. false: nothing is
  /// asked.
  bool pass_by();
  /// The answer that was wrong at the first try, while the question waits for the second; null otherwise.
  [[nodiscard]] const Answer* tried() const;
  /// The outcome of an answer that was given, on the way to where it is decided; null otherwise.
  [[nodiscard]] const Outcome* deciding() const;
  /// Goes there at once.
  void decide();
  /// What there is to say of the last pick: that it is chosen, or why it cannot be the answer. Empty for nothing.
  [[nodiscard]] const std::string& answer_says() const { return answer_says_; }
  /// The handles that can be the answer to what is asked, rising; none where it is not answered on the stage.
  [[nodiscard]] std::vector<Index> targets() const;
  [[nodiscard]] std::vector<std::string> target_names() const;
  /// The outcome that is told: from where it is decided until it is acknowledged or the player is elsewhere; null
  /// otherwise.
  [[nodiscard]] const Outcome* outcome() const;
  /// That it was read. false: none is told.
  bool acknowledge();
  /// Goes back to where its question was asked, on the way to where it is decided. false: nothing lies between.
  bool watch_outcome();
  /// Tells a question's outcome again, where it is decided. false: it has none.
  bool review(std::string_view question);
  /// After a wrong answer: whether the right one can be marked, marks it, and whether it is.
  [[nodiscard]] bool can_show_answer() const;
  bool show_answer();
  [[nodiscard]] bool answer_shown() const { return answer_shown_ && outcome() != nullptr; }
  /// The choices that are right, of the outcome that is told; none where it is told of handles alone.
  [[nodiscard]] std::vector<int> right_choices() const;
  /// The question of an outcome; null where this run does not have it.
  [[nodiscard]] const Asked* question_of(const Outcome& outcome) const;
  /// The outcome of a question of this run; null for none.
  [[nodiscard]] const Outcome* outcome_of(const Asked& asked) const;
  [[nodiscard]] const std::vector<Outcome>& outcomes() const { return outcomes_; }
  /// How it stands with the questions of this run.
  [[nodiscard]] Tally tally() const { return tally_of(asked_, outcomes_); }
  /// How the predictions came out (score_text), once the run is through; else empty.
  [[nodiscard]] std::string score() const;
  /// The lesson's other methods that have questions which are still open; none of a subject that was edited, for which
  /// they may not arise.
  [[nodiscard]] std::vector<const Method*> waiting() const;
  /// Whether the lesson ends here: the run is through, no question is open and each outcome was read. It can be closed.
  [[nodiscard]] bool at_summary() const;
  void close_summary();
  /// None where the lesson has no task.
  [[nodiscard]] std::optional<Grade> grade() const;
  /// All questions anew.
  void forget_answers();
  /// The outcomes of an earlier session of this lesson; those of questions that it does not have are left out.
  void take_up_answers(std::vector<Outcome> outcomes);

  // ---- figures ----------------------------------------------------------------------------------------------
  using Figure = lesson::Figure;
  [[nodiscard]] std::vector<Figure> figures(int slot = 0) const;
  /// The key of the figure that is asked for, which is not told beside the question; empty for none.
  [[nodiscard]] std::string_view asked_figure() const;
  /// Whether a figure is not told: it is asked for, or the first question about it is still open, ahead of where one
  /// stands.
  [[nodiscard]] bool is_hidden(std::string_view figure) const { return untold().hides(figure); }
  [[nodiscard]] Untold untold() const;
  /// Whether a step's question stands here: what the whole run comes to is not shown then, in any way.
  [[nodiscard]] bool predicting() const;
  /// Whether a method's result is not told beside the others'.
  [[nodiscard]] bool hides_result(const Method& of) const {
    return predicting() || (&of == method(0) && is_hidden(kResultFigure));
  }
  /// What is proven so far, and in the end the result's certificate.
  [[nodiscard]] std::vector<Proof> proofs(int slot = 0) const;
  /// Changes whenever anything that a view shows has changed.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// The hash of slot 0's run.
  [[nodiscard]] std::uint64_t trace_hash() const;

 private:
  struct Used {
    const Method* method = nullptr;
    std::unique_ptr<Run> run;
    std::vector<std::string_view> pseudocode;
  };
  using Snapshot = std::unique_ptr<Subject>;

  Session(Lesson lesson, Snapshot own);
  [[nodiscard]] const Method* first_that_suits(const Subject& subject) const;
  Done make_room_for(const Subject& next);
  template <class Edit>
  Done edit(Edit edit);
  void remember(Snapshot before);
  void restore(std::vector<Snapshot>& from, std::vector<Snapshot>& to);
  void use(int slot, const Method* method);
  void run_again(int slot);
  void subject_changed();
  void run_changed(bool at_end);
  void informed();
  void stand(int step);
  bool refuse(std::string why);
  [[nodiscard]] bool open_question(const Asked& asked) const;
  [[nodiscard]] const Asked* standing() const;
  bool give(const Answer& answer, bool for_good);
  Outcome& outcome_for(const std::string& id);

  std::unique_ptr<const Lesson> lesson_;
  Snapshot own_;  // the lesson's own, for reset
  Snapshot now_;
  std::vector<Snapshot> past_;
  std::vector<Snapshot> future_;
  Snapshot drag_;  // where the drag began
  bool drag_moved_ = false;
  std::array<Used, 2> slots_;
  // What is worked out when asked for, and forgotten with the next edit.
  mutable std::optional<std::vector<Rival>> rivals_;
  mutable std::optional<Grade> grade_;
  mutable std::optional<std::uint64_t> hash_;
  int step_ = 0;
  bool previewing_ = false;
  std::vector<Mark> marks_;
  std::vector<Asked> asked_;
  std::vector<Outcome> outcomes_;
  mutable std::vector<bool> found_;  // of a task's goals, since it was begun
  std::optional<Answer> picked_;     // chosen and not given yet
  std::string answer_says_;
  struct Tried {
    std::string question;  // its id
    Answer answer;
  };
  std::optional<Tried> tried_;  // wrong at the first try
  bool skips_next_ = false;     // it was said that a second press skips
  bool play_answers_ = false;
  int shown_outcome_ = -1;  // of outcomes_, at step shown_at_, once that is reached
  int shown_at_ = -1;
  bool deciding_ = false;  // on the way there
  bool answer_shown_ = false;
  bool summary_closed_ = false;
  std::uint64_t revision_ = 1;
};

}  // namespace snug::lesson
