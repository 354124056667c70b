// A student in a lesson: the stage as edited, the runs on it, the place in the timeline, and the answers given. The
// page and the desktop window are thin views of this; no rule of an exercise is written anywhere else. The subject
// knows what the stage is about (subject.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "lesson/ask.hpp"
#include "lesson/sliders.hpp"
#include "lesson/subject.hpp"

namespace snug::lesson {

class Preparation;

/// An answer that was given: right or not, and at which try.
struct Given {
  std::string question;  // its id
  Answer answer;
  bool right = false;
  double seconds = 0;  // since the lesson was opened; 0 without a clock
};

/// How answers are taken. An exercise lets the student decide in the algorithm's place: choosing an answer gives it,
/// the run goes on by itself to what is decided next, and what stands on the stage cannot be changed; or it lets the
/// student build on what stands there, which nothing else can replace.
struct Conduct {
  bool decides = false;  // whether it is such an exercise; and then
  bool told = true;      // whether each answer is told at once, or all of them at the end
  bool builds = false;   // whether something is built
};

class Session {
 public:
  /// mesh: the one that lesson.points.mesh names, if any. clock: times the effects. Errors: those of the subject's
  /// open; no method of the lesson takes so many points.
  [[nodiscard]] static tl::expected<Session, InputError> open(Lesson lesson, std::optional<io::PointFile> mesh = {},
                                                              Clock clock = nullptr);
  // Asked refers to the lesson, which stays in place when it is moved but not when it is copied.
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;
  ~Session();  // not inline: a sanitizer would look for type information in other rooms, and this room has none

  [[nodiscard]] const Lesson& lesson() const { return *lesson_; }
  /// The subject as it is on the stage.
  [[nodiscard]] const Subject& subject() const { return *now_; }
  /// The subject as the lesson opens with it.
  [[nodiscard]] const Subject& own() const { return *opened().subject; }

  // ---- situations and sliders -------------------------------------------------------------------------------
  /// The name of the situation that is on the stage.
  [[nodiscard]] const std::string& situation() const { return now_->origin().situation; }
  /// Shows a situation as it was left, as one entry of undo. Errors: there is none of that name.
  Done show_situation(std::string_view name);
  /// The sliders of the situation that is on the stage.
  [[nodiscard]] std::vector<ShownSlider> sliders() const;
  /// Moves a slider, by its number among the lesson's. It is an edit like move: between begin_drag and end_drag, all of
  /// its moves are one entry of undo. Errors: there is no such slider here; those of Subject::drive.
  Done slide(std::size_t slider, double value);
  /// The same, to a place of its knob.
  Done slide_to_place(std::size_t slider, int place);
  /// The values of all of the lesson's sliders, and whether any is not where the situation begins.
  [[nodiscard]] const std::vector<double>& slider_values() const { return slid_.values; }
  [[nodiscard]] bool has_slid() const { return slid_.values != opened().slid.values; }
  /// A situation that was shown: as the lesson opens it, and as it is or was left.
  struct Visited {
    Snapshot own, now;
  };
  /// Those that were shown; the one on the stage is the last.
  [[nodiscard]] std::vector<Visited> visited() const;
  /// Moves sliders to what slider_values said, as one edit.
  Done set_sliders(std::vector<double> values);
  /// The situations that still have open questions, besides the one on the stage: as `waiting`.
  [[nodiscard]] std::vector<std::string> situations_waiting() const;

  // ---- its handles ------------------------------------------------------------------------------------------
  [[nodiscard]] int dim() const { return now_->dim(); }
  [[nodiscard]] Index size() const { return now_->size(); }
  [[nodiscard]] Point3 point(Index i) const { return now_->at(i); }
  [[nodiscard]] std::string name_of(Index i) const { return now_->name_of(i); }
  [[nodiscard]] std::uint64_t seed() const { return now_->origin().seed; }
  [[nodiscard]] const std::string& source() const { return now_->origin().source; }
  [[nodiscard]] Snapshot snapshot() const { return {now_->clone(), slid_}; }
  /// Whether it differs from the lesson's own for this seed, so that an address cannot restore it.
  [[nodiscard]] bool edited() const { return now_->origin().edited; }

  /// Edits. Each reruns the methods at once, and is one entry of undo; a whole drag is one entry. The player stays at
  /// its step, or at the last step if the new run is shorter; at the end it stays at the end. Errors: those of the
  /// subject; more points than any method of the lesson takes.
  Done move(Index i, const Point3& to);
  Done add(const Point3& at);
  Done remove(Index i);
  Done load(const io::PointFile& file, std::string_view name);
  Done set_generator(std::string_view kind, int count, int dim, std::uint64_t seed);
  Done set_numbers(std::size_t group, std::size_t row, std::span<const double> values);
  Done set_rows(const Rows& rows);
  /// Chooses the scalar of the runs, as one entry of undo (Subject::set_float).
  Done set_float(bool in_float);
  void scatter(std::uint64_t seed);
  /// Restores the lesson's own; where something is built, what the task begins with.
  void reset();
  /// Takes what stands on the stage for the lesson's own, from which tasks begin and to which reset goes back.
  void settle();
  /// Replaces the subject by another of the same kind.
  Done become(std::unique_ptr<Subject> next);
  /// Starts a task of the lesson: sets its points or boxes, its algorithm in slot 0, and shows the result.
  void start_task(std::size_t task = 0);
  /// Starts a task and places its model answer, or what it was done by before. Errors: those of the subject.
  tl::expected<Grade, InputError> solve_task(std::size_t task);
  tl::expected<Grade, InputError> solve_again(std::size_t task);
  /// Whether a handle may be moved: some tasks leave a few alone to be moved.
  [[nodiscard]] bool may_move(Index i) const;
  /// Whether only what the task in hand leaves to be moved was changed since it was started.
  [[nodiscard]] bool at_task() const { return task_started_; }
  void begin_drag();
  /// Errors: those of an edit that waited for the hand to rest.
  Done end_drag();
  [[nodiscard]] bool dragging() const { return drag_.subject != nullptr; }
  [[nodiscard]] bool can_undo() const { return !past_.empty() || drag_moved_; }
  [[nodiscard]] bool can_redo() const { return !future_.empty(); }
  void undo();
  void redo();
  /// Whether it is the lesson's own: then the lesson's words about its own run are true, unless an effect is off.
  [[nodiscard]] bool is_own() const;
  /// Whether an edit that takes long goes in pieces, between which a door draws, or at once, as a script needs it.
  /// Returns what it was before.
  bool give_way(bool on) { return std::exchange(gives_way_, on); }
  /// What is being computed for the stage, which shows what was there before until all of it is done; null for nothing.
  /// An edit returns before it is done. A new edit replaces it.
  [[nodiscard]] const Preparation* preparing() const { return waiting_.get(); }
  /// Goes on with it for about so long, ns: one piece at least. Once all is there, it is put on the stage. Errors: it
  /// would take too long, and is given up; those of the edit.
  Done go_on(double ns);
  /// Gives it up: what stands on the stage stays.
  void give_up();
  /// Gives the subject information that changes no run, such as measurements, and decides pending answers again.
  template <class Type, class Tell>
  bool inform(Tell tell) {
    if (as<Type>(*now_) == nullptr) return false;
    tell(static_cast<Type&>(*now_));
    informed();
    return true;
  }

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
  /// Every method that the lesson offers, with its result; computed when first needed after an edit.
  [[nodiscard]] const std::vector<Rival>& rivals() const;
  [[nodiscard]] std::vector<Switch> switches() const;
  /// Switches a part off from the current step on, or on again for all steps. Returns false if that is impossible.
  /// Grades ignore switches.
  bool turn(std::string_view name, bool on);
  /// What a tap on a part's control does. At the start of the run a part that is optional is added to what the subject
  /// calls for, or taken out; one that is not called for is added at any step. Else it is switched off or on. Returns
  /// false if that is impossible.
  bool toggle(const Switch& part);
  [[nodiscard]] bool can_toggle(const Switch& part) const;
  /// Adds a part to what the subject calls for, or takes it out, as one entry of undo. Errors: those of
  /// Subject::call_for.
  Done call_for(std::string_view name, bool called);
  /// Pushes what is at a handle at the current step, as one entry of undo. Returns false if that is impossible.
  bool push(Index i);
  /// Makes the stage from a text (Subject::set_file). All that is typed without another edit between, up to end_typing,
  /// is one entry of undo.
  Done set_file(std::string text);
  void end_typing() { typing_ = false; }

  // ---- the player -------------------------------------------------------------------------------------------
  /// The number of steps shown of slot 0: 0 is before the first, steps() after the last.
  [[nodiscard]] int step() const { return step_; }
  [[nodiscard]] int steps() const { return run(0).steps(); }
  /// The step of a slot: slot 1 is at the same fraction of its own run.
  [[nodiscard]] int step_of(int slot) const;
  /// The line of the pseudocode that the step just done belongs to; -1 before the first.
  [[nodiscard]] int line() const { return step_ > 0 ? run(0).line(step_ - 1) : -1; }
  /// The sentence for the current step.
  [[nodiscard]] std::string caption() const;
  /// The volume at the current step; null if there is none.
  [[nodiscard]] const fit::Volume3* volume(int slot) const {
    return method(slot) != nullptr ? run(slot).volume(step_of(slot)) : nullptr;
  }
  /// The handles that support the volume at the current step: those that it touches by construction, or the result's
  /// support set at the end. None if the slot has no method.
  [[nodiscard]] std::vector<Index> support(int slot) const {
    return method(slot) != nullptr ? run(slot).support(step_of(slot)) : std::vector<Index>{};
  }
  /// Goes to a step, but forward only up to the first unanswered question. jump goes past questions (because an address
  /// names a step): they count as skipped, and are asked when the player comes to them again. If the result is shown
  /// already, jump goes to the end only if a question was answered.
  void go(int step);
  void jump(int step);
  void first() { go(0); }
  /// Goes to the next step; if an outcome is shown, only acknowledges it.
  void forward();
  void back() { go(step_ - 1); }
  void last() { go(steps()); }
  /// Whether the result is shown before the player was used, in a lesson that starts at its end. Edits do not change
  /// that. No question counts as passed: stepping forward or playing shows step 1, and scrubbing back stops at the
  /// first question. A question before step 1 stops both.
  [[nodiscard]] bool previewing() const { return previewing_; }
  [[nodiscard]] const std::vector<Mark>& marks() const { return marks_; }
  /// The next or previous mark, or the end or start.
  [[nodiscard]] int next_mark() const;
  [[nodiscard]] int previous_mark() const;

  // ---- questions and the task -------------------------------------------------------------------------------
  // A question is asked, answered (a wrong answer may have a second try), decided (the steps up to there are played),
  // told, and acknowledged; only then is the next one asked.
  /// The open question at the current step; null while an outcome is shown. Playing waits for it. A lesson opens
  /// without one: what is seen first can be looked at, and the first step asks.
  [[nodiscard]] const Asked* asked() const;
  /// The first open question about what is measured, which belongs to no step; null for none.
  [[nodiscard]] const Asked* to_predict() const;
  /// Asks those of the situation on the stage, where they wait until measuring is wanted.
  void ask_predictions();
  /// What questions are asked on now: the seed of the points to practise on; 0: the lesson's own, whose answers hold
  /// wherever else the stage is changed by hand.
  [[nodiscard]] std::uint64_t instance() const;
  /// Whether something is asked of this run that holds on any points.
  [[nodiscard]] bool can_practise() const;
  /// Scatters to the next seed that raises a question, and asks there whatever was answered elsewhere, from the first
  /// step on, as one entry of undo. The answers given so far are kept. Returns false if none of the next hundred does.
  bool practise();
  /// Sets how answers are taken, before the first is given.
  void conduct(Conduct conduct);
  [[nodiscard]] const Conduct& conduct() const { return conduct_; }
  /// Every answer that was given, in order; those to a question that was taken back are not among them.
  [[nodiscard]] const std::vector<Given>& given() const { return given_; }
  /// The time since it was opened; 0 without a clock.
  [[nodiscard]] double seconds() const;
  /// Gives an answer as commit does: a wrong first one may have a second try. Returns false as `answer` does.
  bool propose(const Answer& answer) { return give(answer, false); }
  /// Where answers are told at the end only: takes the last one back, and goes to where it is asked.
  bool take_back();
  /// Every question of this run in the timeline's order, without those whose step the run does not have.
  [[nodiscard]] const std::vector<Asked>& questions() const { return asked_; }
  /// Gives a final answer and goes to the step that decides it, so that prediction and result can be compared. Returns
  /// false, and changes nothing, if nothing is asked or if this cannot be an answer (a handle that is no choice).
  bool answer(const Answer& answer);
  /// Whether the app plays the steps between a question and its outcome. If on, commit and skip leave the player where
  /// it is; if off, they go to the outcome at once.
  void play_answers(bool on) { play_answers_ = on; }
  /// Chooses an answer; choosing it again gives it. If a question takes many choices, selects or deselects one. Returns
  /// false if nothing is asked, or if this cannot be an answer: answer_says then tells what can.
  /// gives: whether an exercise takes it at once, as it takes a tap; a key that goes through the answers does not.
  bool pick(const Answer& answer, bool gives = true);
  /// The same for a handle by its typed name ("B2", "p7").
  bool pick(std::string_view name);
  /// The chosen answer to the open question; null if there is none.
  [[nodiscard]] const Answer* picked() const;
  void unpick();
  /// Gives the chosen answer. If there is a second try, a wrong first answer is only called wrong. Returns false if
  /// none is chosen.
  bool commit();
  /// Skips the open question. Returns false if nothing is asked.
  bool skip();
  /// The "next" key at a question: the first press announces that a second one skips the question, the second skips it.
  /// Returns false if nothing is asked.
  bool pass_by();
  /// The wrong first answer, while the question waits for the second; null otherwise.
  [[nodiscard]] const Answer* tried() const;
  /// The outcome of a given answer, while the steps up to its decision are played; null otherwise.
  [[nodiscard]] const Outcome* deciding() const;
  /// Goes at once to the step where it is decided.
  void decide();
  /// What to say about the last pick: that it is chosen, or why it cannot be the answer. Empty for nothing.
  [[nodiscard]] const std::string& answer_says() const { return answer_says_; }
  /// The handles that can be the answer to the open question, in rising order; none if it is not answered on the stage.
  [[nodiscard]] std::vector<Index> targets() const;
  [[nodiscard]] std::vector<std::string> target_names() const;
  /// The outcome that is shown: from the step where it is decided (or where it was asked, if another question is asked
  /// there as well), until it is acknowledged or the player moves away; null otherwise.
  [[nodiscard]] const Outcome* outcome() const;
  /// Marks the outcome as read. Returns false if none is shown.
  bool acknowledge();
  /// Goes back to where its question was asked, and plays on. Returns false if there are no steps between.
  bool watch_outcome();
  /// Whether the outcome that is shown has such steps. It has none where it is told before its step.
  [[nodiscard]] bool can_watch_outcome() const;
  /// Shows a question's outcome again, at the step where it was decided. Returns false if it has none.
  bool review(std::string_view question);
  /// After a wrong answer: whether the right one can be marked; marks it; whether it is marked.
  [[nodiscard]] bool can_show_answer() const;
  bool show_answer();
  [[nodiscard]] bool answer_shown() const { return answer_shown_ && outcome() != nullptr; }
  /// The right choices of the outcome that is shown; none if its answers are handles only.
  [[nodiscard]] std::vector<int> right_choices() const;
  /// The question of an outcome; null if this run does not have it.
  [[nodiscard]] const Asked* question_of(const Outcome& outcome) const;
  /// The outcome of a question of this run; null for none.
  [[nodiscard]] const Outcome* outcome_of(const Asked& asked) const;
  [[nodiscard]] const std::vector<Outcome>& outcomes() const { return outcomes_; }
  /// The state of this run's questions, counted.
  [[nodiscard]] Tally tally() const;
  /// The score of the predictions (score_text), once the run is finished; otherwise empty.
  [[nodiscard]] std::string score() const;
  /// The lesson's other methods that still have open questions; none if the subject was edited, because then the
  /// questions may not come.
  [[nodiscard]] std::vector<const Method*> waiting() const;
  /// Whether a question was neither answered nor skipped on what it is asked on now; one that a jump passed is open.
  [[nodiscard]] bool is_open(const Question& question) const;
  /// Whether the summary is shown: the run is finished, each question done and its outcome read. It can be closed.
  [[nodiscard]] bool at_summary() const;
  void close_summary();
  /// The grade of a task, as the stage is now; while results wait for the hand to rest, as it was before the drag.
  [[nodiscard]] Grade grade(std::size_t task) const;
  /// That of the task in hand; none if the lesson has no task.
  [[nodiscard]] std::optional<Grade> grade() const;
  /// The task that was started last, or the first one.
  [[nodiscard]] std::size_t task() const { return task_; }
  /// Whether a task was done since the lesson was opened.
  [[nodiscard]] bool was_done(std::size_t task) const;
  /// Whether every task of the lesson was; false if it has none.
  [[nodiscard]] bool tasks_done() const;
  /// A task that was done, by its number, and what stood on the stage when it first was (packed_rows); empty if that is
  /// not known, or too long to be kept.
  struct DoneTask {
    int task = 0;
    std::string by = {};
    bool operator==(const DoneTask&) const = default;
  };
  [[nodiscard]] std::vector<DoneTask> done_tasks() const;
  /// Whether a task is not solved now, and it is known what it was done by.
  [[nodiscard]] bool can_solve_again(std::size_t task) const;
  /// The sliders that the lesson is about (must_move) which nobody has moved yet; and those that were, by what they
  /// drive.
  [[nodiscard]] std::vector<const Slider*> sliders_to_move() const;
  [[nodiscard]] const std::vector<std::string>& moved_sliders() const { return moved_; }
  /// Forgets all answers.
  void forget_answers();
  /// Takes over the outcomes of an earlier session of this lesson, without those of unknown questions.
  void take_up_answers(std::vector<Outcome> outcomes);
  /// The tasks that were done in it; those that the lesson does not have are left out.
  void take_up_tasks(const std::vector<DoneTask>& done);
  /// The sliders that were moved in it, by what they drive.
  void take_up_moved(std::vector<std::string> drives);

  // ---- figures ----------------------------------------------------------------------------------------------
  using Figure = lesson::Figure;
  [[nodiscard]] std::vector<Figure> figures(int slot = 0) const;
  /// The figures of one of the lesson's methods at the end of its run; computed when first needed after an edit. None
  /// if it cannot take these points, or if they wait until a drag is over. Whether they are hidden is for hides_result
  /// and is_hidden to say.
  [[nodiscard]] const std::vector<Figure>& result(const Method& of) const;
  /// The key of the figure that the open question asks for, which is hidden meanwhile; empty for none.
  [[nodiscard]] std::string_view asked_figure() const;
  /// Whether a figure is hidden: it is asked for, or the first question about it is still open, further
  /// on.
  [[nodiscard]] bool is_hidden(std::string_view figure) const { return untold().hides(figure); }
  [[nodiscard]] Untold untold() const;
  /// Whether a question about a step is open: the result of the run is then hidden everywhere.
  [[nodiscard]] bool predicting() const;
  /// Whether a question that compares the lesson's methods is still open, in the run of any of them: their results are
  /// hidden until it is answered or skipped. false for a subject that was edited.
  [[nodiscard]] bool comparing() const;
  /// Whether a question about a figure of that method is still open here, in whatever run the player is; empty: any
  /// question in that method's run. false for a subject that was edited.
  [[nodiscard]] bool awaits(const Method& of, std::string_view figure) const;
  /// Whether a method's result is hidden in the comparison.
  [[nodiscard]] bool hides_result(const Method& of) const;
  /// What is proven so far; at the end, the result's certificate.
  [[nodiscard]] std::vector<Proof> proofs(int slot = 0) const;
  /// A number that changes whenever anything that a view shows has changed.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// The hash of slot 0's run.
  [[nodiscard]] std::uint64_t trace_hash() const;

 private:
  struct Used {
    const Method* method = nullptr;
    std::unique_ptr<Run> run;
    std::vector<std::string_view> pseudocode;
  };
  /// A situation.
  struct Situated {
    Snapshot own;                    // as it opens, for reset
    Snapshot left;                   // as it was when another was shown; null before that
    const Method* method = nullptr;  // slot 0's then
    int step = 0;
    bool previewing = false;
  };

  Session(Lesson lesson, std::vector<Situated> places);
  [[nodiscard]] const Snapshot& opened() const { return places_[shown_].own; }
  [[nodiscard]] const Method* first_that_suits(const Subject& subject) const;
  [[nodiscard]] const Method* method_for(int slot, const Subject& next) const;
  Done make_room_for(const Subject& next);
  /// What an edit does that may wait: it is new, or comes from the undone ones, or from the redone ones.
  enum class Way { kEdit, kUndo, kRedo };
  Done prepare(Snapshot next, Way way);
  void put_on_stage(std::unique_ptr<Preparation> ready);
  template <class Edit>
  Done edit(Edit edit);
  template <class Edit>
  Done edit_anew(Edit edit);
  Done become(Snapshot next);
  tl::expected<Grade, InputError> place_answer(std::size_t task, const Rows& answer);
  /// Whether it differs from what stands on the stage only in what the task in hand leaves to be moved.
  [[nodiscard]] bool keeps_to_task(const Subject& next) const;
  /// After an edit that keeps it whatever it changed.
  void keep_task(bool started) { (waiting_ != nullptr ? waiting_keeps_ : task_started_) = started; }
  Snapshot exchange(Snapshot next);
  void leave_situation();
  void enter_situation();
  void remember(Snapshot before);
  void restore(Way way);
  void take_over(Way way, Snapshot next);
  void use(int slot, const Method* method);
  void run_again(int slot);
  void subject_changed();
  void run_changed(bool at_end);
  void informed();
  void stand(int step);
  bool refuse(std::string why);
  void forget_grades();
  /// Whether the results at the end of runs, and grades, wait until the hand rests.
  [[nodiscard]] bool waits() const;
  [[nodiscard]] const Asked* standing() const;
  [[nodiscard]] const Asked* open_at(int step) const;
  [[nodiscard]] const Outcome* outcome_of(const std::string& question) const;
  [[nodiscard]] Outcome judged(const Asked& asked, const Answer& answer) const;
  void go_to_next_decision();
  bool give(const Answer& answer, bool for_good);
  bool pick_one_more(const Asked& question, const Answer& chosen);
  bool pick_number(const Asked& question, std::string_view typed);
  bool pick_names(const Asked& question, std::string_view typed);
  [[nodiscard]] int told_at(const Asked& own) const;
  Outcome& outcome_for(const std::string& id);

  std::unique_ptr<const Lesson> lesson_;
  Clock clock_ = nullptr;
  std::vector<Situated> places_;  // of each situation, the lesson's own first
  std::size_t shown_ = 0;         // which of them is on the stage
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
  bool waiting_keeps_ = false;          // task_started_ after it
  std::unique_ptr<Preparation> ready_;  // whose runs are taken over
  bool typing_ = false;                 // whether the last edit was typed, and
  bool types_on_ = false;               // whether this one goes on with it
  std::array<Used, 2> slots_;
  // Computed on demand, and forgotten with the next edit.
  mutable std::optional<std::vector<Rival>> rivals_;
  mutable std::map<const Method*, std::vector<Figure>> results_;
  mutable std::vector<std::optional<Grade>> grades_;  // one for each task
  mutable std::optional<std::uint64_t> hash_;
  int step_ = 0;
  bool previewing_ = false;
  bool fresh_ = true;           // the player was not used yet
  bool predicts_ = false;       // whether to_predict() is asked
  std::uint64_t practice_ = 0;  // the seed that was scattered to practise; 0 for none
  std::vector<Mark> marks_;
  std::vector<Asked> asked_;
  std::vector<std::string> moved_;
  std::vector<Outcome> outcomes_;
  Conduct conduct_;
  std::vector<Given> given_;
  double opened_at_ = 0;       // by the clock, ns
  std::size_t task_ = 0;       // the one in hand
  bool task_started_ = false;  // and whether nothing but what it leaves to be moved was changed since
  mutable std::vector<std::optional<std::string>> done_;  // by the tasks: none, or DoneTask::by
  std::optional<Answer> picked_;                          // chosen and not given yet
  std::string answer_says_;
  struct Tried {
    std::string question;  // its id
    Answer answer;
  };
  std::optional<Tried> tried_;  // the wrong first answer
  bool skips_next_ = false;     // it was announced that a second press skips
  bool play_answers_ = false;
  int shown_outcome_ = -1;  // index into outcomes_, shown once step shown_at_ is reached
  int shown_at_ = -1;
  bool deciding_ = false;  // whether the steps up to there are being played
  bool answer_shown_ = false;
  bool summary_closed_ = false;
  std::uint64_t revision_ = 1;
};

/// While it lives, edits are done at once.
class AtOnce {
 public:
  explicit AtOnce(Session& session) : session_(session), before_(session.give_way(false)) {}
  ~AtOnce() { session_.give_way(before_); }
  AtOnce(const AtOnce&) = delete;
  AtOnce& operator=(const AtOnce&) = delete;

 private:
  Session& session_;
  bool before_;
};

}  // namespace snug::lesson
