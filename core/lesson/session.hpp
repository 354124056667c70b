// A student in a lesson: the points as edited, the runs on them, the place in the timeline, the answers given.
// The page and the desktop window are thin views of this; no rule of an exercise is written anywhere else.
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

#include "fit/catalogue.hpp"
#include "io/point_file.hpp"
#include "lesson/ask.hpp"
#include "lesson/box_tests.hpp"
#include "lesson/figures.hpp"
#include "lesson/grade.hpp"
#include "lesson/lesson.hpp"
#include "lesson/scene_runs.hpp"
#include "measure/rows.hpp"

namespace snug::lesson {

/// A mark on the timeline: a step that matters. step: the player's place that shows it, for go.
struct Mark {
  int step = 0;
  enum class Kind {
    kGrew,      // there is a ball, or it grew
    kReplaced,  // the support set was replaced
    kQuestion,  // a question stands here
    kBest,      // the ball became the best so far
  } kind = Kind::kGrew;
};

class Session {
 public:
  /// mesh: what lesson.points.mesh names, where it names one. clock: by which a scene's effects are timed. Errors:
  /// points that no set can be made of; a scene whose effects cannot take the mesh, by its line.
  [[nodiscard]] static tl::expected<Session, InputError> open(Lesson lesson, std::optional<io::PointFile> mesh = {},
                                                              scene::Clock clock = nullptr);
  // Asked points into the lesson, which a move leaves in place and a copy would not.
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;
  ~Session();  // not inline: this room has no type information, which a sanitizer would look for in other rooms

  [[nodiscard]] const Lesson& lesson() const { return lesson_; }

  // ---- the points -------------------------------------------------------------------------------------------
  [[nodiscard]] const AnyPointSet& points() const { return now_.points; }
  [[nodiscard]] int dim() const;
  [[nodiscard]] Index size() const;
  [[nodiscard]] Vector<double, 3> point(Index i) const;
  /// Triangles of the mesh that the points are vertices of; empty otherwise. Moving a vertex keeps them, adding or
  /// deleting a point drops them (undo brings them back).
  [[nodiscard]] const std::vector<std::array<Index, 3>>& triangles() const;
  [[nodiscard]] std::uint64_t seed() const { return now_.seed; }
  /// The two boxes of a lesson that has them in place of points; null otherwise. Its points are then the boxes' places
  /// (lesson/boxes.hpp), and to move one moves, turns or stretches its box.
  [[nodiscard]] const BoxPair* boxes() const { return now_.boxes ? &*now_.boxes : nullptr; }
  /// "P3", or of a box "A turn", "B2".
  [[nodiscard]] std::string name_of(Index i) const;
  /// Where the points come from: a generator's kind, a mesh's or file's name, "own" for the lesson's own list, "task"
  /// for the start of its task.
  [[nodiscard]] const std::string& source() const { return now_.source; }

  /// Edits. Each runs the algorithms anew at once and is one entry of undo; a drag is one entry from begin to end.
  /// The player stays at its step, or at the last one where the new trace is shorter; at the end it stays at the end.
  tl::expected<void, InputError> move(Index i, const Vector<double, 3>& to);
  /// Other boxes in the place of these. Errors: there are none, or of another dimension; a number that is not finite, a
  /// half extent below 0.
  tl::expected<void, InputError> set_boxes(const BoxPair& pair);
  /// Errors: more points than the main algorithm takes; boxes have no points to add.
  tl::expected<void, InputError> add(const Vector<double, 3>& at);
  /// Errors: the last point cannot be deleted; boxes have none to delete.
  tl::expected<void, InputError> remove(Index i);
  /// Points anew from a seed, of the kind that they are now; those of a mesh, file or list give way to as many of the
  /// lesson's generator as the lesson has points. The lesson's own seed brings a lesson's own list back.
  void scatter(std::uint64_t seed);
  /// Points of another kind. Errors: unknown kind, a count out of 1 … 100,000, a dimension other than 2 and 3.
  tl::expected<void, InputError> set_generator(std::string_view kind, int count, int dim, std::uint64_t seed);
  /// The lesson's own points and seed again.
  void reset();
  /// An algorithm that does not take so many points gives way to the first of the lesson's that does. Errors: as of
  /// io::to_point_set; no algorithm of the lesson takes so many.
  tl::expected<void, InputError> load(const io::PointFile& file, std::string_view name);
  /// The first points of the lesson's own, as many as the task asks for, the task's algorithm in slot 0, and its
  /// result.
  void start_task();
  void begin_drag();
  void end_drag();
  [[nodiscard]] bool can_undo() const { return !past_.empty() || drag_moved_; }
  [[nodiscard]] bool can_redo() const { return !future_.empty(); }
  void undo();
  void redo();
  /// Whether the points are other than the lesson's own for this seed (an address cannot restore them then).
  [[nodiscard]] bool edited() const { return now_.edited; }

  // ---- the algorithms ---------------------------------------------------------------------------------------
  /// slot 0 is the main one, which the timeline, sentence and pseudocode speak of; slot 1 stands beside it.
  [[nodiscard]] const fit::Algorithm* algorithm(int slot) const { return slots_[slot].algorithm; }
  /// The slot's frames, of a lesson that has a scene; null otherwise. Frame step_of(slot) is the one that stands.
  [[nodiscard]] const std::vector<SceneFrame>* frames(int slot) const;
  /// The frame of slot 0 that stands, and its bodies' shapes; null where there is none.
  [[nodiscard]] const SceneFrame* frame() const;
  [[nodiscard]] std::span<const scene::Member> members() const { return slots_[0].members; }
  /// Switches an effect of the scene off from the frame that stands, or on again for all frames. false: there is none
  /// of that name, or none has run yet (at the beginning there is nothing that what reads it could go on with). Grades
  /// know no switches.
  bool turn(std::string_view effect, bool on);
  [[nodiscard]] bool is_on(std::string_view effect) const;
  /// The step after which it was switched off; -1 where it is on, or was in the step that stands.
  [[nodiscard]] int off_since(std::string_view effect) const;
  /// What one run of an effect takes here, as effect_time_text has it, of all runs in slot 0's frames. Of no step,
  /// figure or hash: they are the same everywhere.
  [[nodiscard]] std::string time_of(std::string_view effect) const;
  /// An empty name clears slot 1; slot 0 must have one. Errors: too many points for it; unknown name.
  tl::expected<void, InputError> choose(int slot, std::string_view name);
  [[nodiscard]] const fit::Recording& recording(int slot) const { return slots_[slot].recording; }
  /// The lesson's own pseudocode of that slot's algorithm, or the catalogue's.
  [[nodiscard]] std::span<const std::string_view> pseudocode(int slot) const;
  /// The smallest volume of the points, watched: run when first asked for after an edit. Null where there are too many
  /// points for it. For the excess alone, smallest_size is cheaper.
  [[nodiscard]] const fit::Recording* optimum() const;
  /// As fit::size_of has it.
  [[nodiscard]] std::optional<double> smallest_size() const;
  /// Every algorithm that the lesson offers, with its result on the points ("In the end, beside the others"). Run when
  /// first asked for after an edit. Those that do not take so many points are left out.
  struct Rival {
    const fit::Algorithm* algorithm;
    double size;                   // as fit::size_of has it
    std::optional<double> excess;  // over the optimum, 0.1 for 10 per cent; none where that is not known
  };
  [[nodiscard]] const std::vector<Rival>& rivals() const;

  // ---- the player -------------------------------------------------------------------------------------------
  /// Steps of slot 0: 0 is before the first, steps() is after the last. step() shows the state after that many steps.
  [[nodiscard]] int step() const { return step_; }
  [[nodiscard]] int steps() const { return static_cast<int>(recording(0).steps.size()); }
  /// The step just done (null at 0), and slot 1's at the same share of its own trace.
  [[nodiscard]] const Recorder<fit::Step3>::Entry* current(int slot) const;
  [[nodiscard]] int step_of(int slot) const;
  /// The points that hold the ball as it stands: those it touches by construction, or the result's in the end.
  [[nodiscard]] std::vector<Index> support(int slot) const;
  /// Goes to a step; forward only up to the first unanswered question's gate. jump goes past gates: their questions
  /// then count as skipped (an address names a step), and are asked when the player comes to them again.
  void go(int step);
  void jump(int step);
  void first() { go(0); }
  void forward() { go(step_ + 1); }
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

  // ---- the chart of costs, of a lesson that measures --------------------------------------------------------
  /// Whether the points (boxes, bodies) and the seed are the lesson's own: what a lesson says of its own run is true
  /// then, unless an effect is off. Of a chart all questions are of these.
  [[nodiscard]] bool has_own_points() const;
  /// Takes over what was measured on the points as they stand, a row an algorithm: it decides what was predicted.
  void measured(std::vector<cost::CostRow> rows);
  /// Null where these points have not been measured.
  [[nodiscard]] const std::vector<cost::CostRow>* costs() const { return worked_.costs ? &*worked_.costs : nullptr; }

  // ---- questions and the task -------------------------------------------------------------------------------
  /// The question that stands here and has no answer yet; playing waits for it.
  [[nodiscard]] const Asked* asked() const;
  /// Every question of this trace in the timeline's order. Questions whose gate the trace does not have are left out.
  [[nodiscard]] const std::vector<Asked>& questions() const { return asked_; }
  /// Commits an answer and goes to where it is decided, so that what happened stands beside what was predicted.
  /// false: nothing is asked, or that is no answer to it (a point that is none of the choices); nothing changes then.
  bool answer(const Answer& answer);
  /// Chooses an answer without giving it yet; chosen once more, it is given. Of a question that takes many choices, one
  /// is chosen, or no longer. false: nothing is asked, or that is no answer to it: answer_says tells which are.
  bool pick(const Answer& answer);
  /// A handle by its name, as one types it ("B2", "p7").
  bool pick(std::string_view name);
  /// The answer that is chosen to the question that stands; null where none is.
  [[nodiscard]] const Answer* picked() const;
  void unpick();
  /// Gives the answer that is chosen. false: none is.
  bool commit();
  /// What there is to say of the last pick: that it is chosen, or why it cannot be the answer. Empty for nothing.
  [[nodiscard]] const std::string& answer_says() const { return answer_says_; }
  /// The handles that can be the answer to what is asked, rising; none where it is not answered on the stage.
  [[nodiscard]] std::vector<Index> targets() const;
  [[nodiscard]] std::vector<std::string> target_names() const;
  /// The last outcome, as long as the player stands on the step it speaks of; null otherwise.
  [[nodiscard]] const Outcome* outcome() const;
  [[nodiscard]] const std::vector<Outcome>& outcomes() const { return outcomes_; }
  /// How the predictions came out (score_text), once the run is through and nothing is open; else empty.
  [[nodiscard]] std::string score() const;
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
  [[nodiscard]] bool is_hidden(std::string_view figure) const;
  /// What is proven of the ball as it stands ("Proof, so far"), and in the end the result's certificate.
  [[nodiscard]] std::vector<Proof> proofs(int slot = 0) const;
  /// Changes whenever anything that a view shows has changed.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// The hash of slot 0's trace.
  [[nodiscard]] std::uint64_t trace_hash() const;

 private:
  using Triangles = std::vector<std::array<Index, 3>>;
  /// The points and what is said of them; shared triangles keep a snapshot small.
  struct Snapshot {
    AnyPointSet points;
    std::shared_ptr<const Triangles> triangles;
    std::uint64_t seed = 1;
    std::string source;
    int generated = 0;  // how many points the source's generator made; 0 where there is none
    bool edited = false;
    std::optional<BoxPair> boxes;  // points are then their places
  };
  struct Slot {
    const fit::Algorithm* algorithm = nullptr;
    fit::Recording recording;
    std::vector<std::string_view> pseudocode;
    std::vector<SceneFrame> frames;
    std::vector<scene::Member> members;
  };
  /// What is worked out when asked for, and forgotten with the next edit.
  struct Worked {
    std::optional<fit::Recording> optimum;
    std::optional<double> smallest_size;
    std::optional<std::vector<Rival>> rivals;
    std::optional<Grade> grade;
    std::optional<std::uint64_t> hash;
    std::optional<std::vector<cost::CostRow>> costs;
  };

  struct Recipe {
    std::string_view kind;
    int count = 0;
    int dim = 2;
    friend bool operator==(const Recipe&, const Recipe&) = default;
  };

  Session(Lesson lesson, Snapshot own);
  [[nodiscard]] Recipe recipe() const;
  tl::expected<void, InputError> make_room_for(Index points);
  tl::expected<void, InputError> become(Snapshot next);
  tl::expected<void, InputError> move_in(Snapshot& snapshot, Index i, const Vector<double, 3>& to) const;
  [[nodiscard]] static tl::expected<Snapshot, InputError> placed(Snapshot snapshot, BoxPair pair);
  void remember();
  void restore(std::vector<Snapshot>& from, std::vector<Snapshot>& to);
  [[nodiscard]] Snapshot generated(std::string_view kind, int count, int dim, std::uint64_t seed, bool edited) const;
  void use(int slot, const fit::Algorithm* algorithm);
  void run(int slot);
  void points_changed();
  void trace_changed(bool at_end);
  void stand(int step);
  bool refuse(std::string why);
  [[nodiscard]] bool open_question(const Asked& asked) const;
  Outcome& outcome_for(const std::string& id);
  [[nodiscard]] double size_of(const fit::Algorithm& algorithm) const;
  [[nodiscard]] const fit::Algorithm* exact() const;
  [[nodiscard]] RunView view(int slot) const;
  [[nodiscard]] Grade grade_of_costs() const;
  void decide_costs();
  [[nodiscard]] const SwitchedOff* switched_off(std::string_view effect) const;  // null where it is on

  Lesson lesson_;
  Snapshot own_;  // the lesson's own points, for reset
  Snapshot now_;
  std::vector<Snapshot> past_;
  std::vector<Snapshot> future_;
  std::optional<Snapshot> drag_;  // the points where the drag began
  bool drag_moved_ = false;
  std::array<Slot, 2> slots_;
  std::vector<SwitchedOff> off_;
  scene::Clock clock_ = nullptr;
  double clock_step_ = 0;  // ns
  mutable Worked worked_;
  int step_ = 0;
  bool previewing_ = false;
  std::vector<Mark> marks_;
  std::vector<Asked> asked_;
  std::vector<Outcome> outcomes_;
  mutable std::vector<bool> found_;  // of a task's goals, since it was begun
  std::optional<Answer> picked_;     // chosen and not given yet
  std::string answer_says_;
  int shown_outcome_ = -1;  // of outcomes_, at step shown_at_
  int shown_at_ = -1;
  std::uint64_t revision_ = 1;
};

}  // namespace snug::lesson
