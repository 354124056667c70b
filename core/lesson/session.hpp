// A student in a lesson: the points as edited, the runs on them, the place in the timeline, the answers given.
// The page and the desktop window are thin views of this; no rule of an exercise is written anywhere else.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "fit/catalogue.hpp"
#include "io/point_file.hpp"
#include "lesson/lesson.hpp"

namespace snug::lesson {

/// An answer to a question: a point of the stage, or one of the question's choices.
struct Answer {
  enum class Kind { kPoint, kChoice, kSkipped } kind = Kind::kSkipped;
  int value = 0;  // the point's index, or the choice counted from 0
};

/// A question as it is asked now, with the choices worked out from the trace.
struct Asked {
  const Question* question = nullptr;
  int step = 0;                       // the step that it stands before
  std::vector<std::string> choices;   // what may be chosen; empty where only the stage answers
  std::vector<Index> choice_points;   // the point that each choice names, or kNoIndex
  bool on_stage = false;              // whether a click on a point answers
};

/// What happened, beside what was predicted.
struct Outcome {
  std::string question;    // its id
  Answer given;
  bool right = false;
  bool skipped = false;
  std::string predicted;   // "P9", "yes", "the x pair"
  std::string happened;    // the same in fact
  std::string because;
};

/// The grading of the task on the points as they stand.
struct Grade {
  bool done = false;
  int points = 0;          // how many there are
  double excess = 0;       // radius / smallest radius - 1
  std::string says;        // one sentence
};

/// A mark on the timeline: a step that matters.
struct Mark {
  int step = 0;
  enum class Kind { kGrew, kReplaced, kQuestion } kind = Kind::kGrew;
};

class Session {
 public:
  /// mesh: what lesson.points.mesh names, where it names one. Errors: points that no set can be made of.
  [[nodiscard]] static tl::expected<Session, InputError> open(Lesson lesson, std::optional<io::PointFile> mesh = {});

  [[nodiscard]] const Lesson& lesson() const { return lesson_; }

  // ---- the points -------------------------------------------------------------------------------------------
  [[nodiscard]] const AnyPointSet& points() const { return points_; }
  [[nodiscard]] int dim() const;
  [[nodiscard]] Index size() const;
  [[nodiscard]] Vector<double, 3> point(Index i) const;
  /// Triangles of the mesh that the points are vertices of; empty otherwise. Moving a vertex keeps them, adding or
  /// deleting a point drops them (undo brings them back).
  [[nodiscard]] const std::vector<std::array<Index, 3>>& triangles() const;
  [[nodiscard]] std::uint64_t seed() const { return seed_; }

  /// Edits. Each runs the algorithms anew at once and is one entry of undo; a drag is one entry from begin to end.
  /// The player stays at its step, or at the last one where the new trace is shorter.
  tl::expected<void, InputError> move(Index i, const Vector<double, 3>& to);
  tl::expected<void, InputError> add(const Vector<double, 3>& at);
  /// Errors: the last point cannot be deleted.
  tl::expected<void, InputError> remove(Index i);
  /// Points anew from a seed: the lesson's generator, or one of the same dimension where the lesson has a mesh or list.
  void scatter(std::uint64_t seed);
  /// The lesson's own points again.
  void reset();
  tl::expected<void, InputError> load(const io::PointFile& file, std::string_view name);
  void begin_drag();
  void end_drag();
  [[nodiscard]] bool can_undo() const { return !past_.empty(); }
  [[nodiscard]] bool can_redo() const { return !future_.empty(); }
  void undo();
  void redo();
  /// Whether the points are other than the lesson's own for this seed (an address cannot restore them then).
  [[nodiscard]] bool edited() const { return edited_; }

  // ---- the algorithms ---------------------------------------------------------------------------------------
  /// slot 0 is the main one, which the timeline, sentence and pseudocode speak of; slot 1 stands beside it.
  [[nodiscard]] const fit::Algorithm* algorithm(int slot) const { return slots_[static_cast<std::size_t>(slot)].algorithm; }
  /// Null clears slot 1; slot 0 must have one. Errors: too many points for it; unknown name.
  tl::expected<void, InputError> choose(int slot, std::string_view name);
  [[nodiscard]] const fit::Recording& recording(int slot) const { return slots_[static_cast<std::size_t>(slot)].recording; }
  /// The smallest ball of the points, for the excess.
  [[nodiscard]] const fit::Recording& optimum() const { return optimum_; }
  /// Every algorithm that the lesson offers, with its result on the points ("In the end, beside the others").
  struct Rival {
    const fit::Algorithm* algorithm;
    double radius;
    double excess;  // over the optimum, 0.1 for 10 per cent
  };
  [[nodiscard]] const std::vector<Rival>& rivals() const { return rivals_; }

  // ---- the player -------------------------------------------------------------------------------------------
  /// Steps of slot 0: 0 is before the first, steps() is after the last. step() shows the state after that many steps.
  [[nodiscard]] int step() const { return step_; }
  [[nodiscard]] int steps() const { return static_cast<int>(recording(0).steps.size()); }
  /// The step just done (null at 0), and slot 1's at the same share of its own trace.
  [[nodiscard]] const Recorder<fit::Step3>::Entry* current(int slot) const;
  [[nodiscard]] int step_of(int slot) const;
  /// Goes to a step; forward only up to the first unanswered question's gate. jump goes past gates: their questions
  /// then count as skipped (an address names a step).
  void go(int step);
  void jump(int step);
  void forward() { go(step_ + 1); }
  void back() { go(step_ - 1); }
  [[nodiscard]] const std::vector<Mark>& marks() const { return marks_; }
  /// The next or previous mark from here, or the end or start.
  [[nodiscard]] int next_mark() const;
  [[nodiscard]] int previous_mark() const;

  // ---- questions and the task -------------------------------------------------------------------------------
  /// The question that stands before the next step and has no answer yet; playing waits for it.
  [[nodiscard]] const Asked* asked() const;
  /// Every question of this trace in the timeline's order. Questions whose gate the trace does not have are left out.
  [[nodiscard]] const std::vector<Asked>& questions() const { return asked_; }
  /// Commits an answer and takes the step, so that what happened stands beside what was predicted.
  void answer(const Answer& answer);
  /// The last outcome, as long as the player stands on the step it speaks of; null otherwise.
  [[nodiscard]] const Outcome* outcome() const;
  [[nodiscard]] const std::vector<Outcome>& outcomes() const { return outcomes_; }
  /// None where the lesson has no task.
  [[nodiscard]] std::optional<Grade> grade() const;
  /// All questions anew.
  void forget_answers();

  // ---- figures ----------------------------------------------------------------------------------------------
  /// What the inspector shows, by name, in its order; values as text with their unit.
  struct Figure {
    std::string name;   // "Radius so far"
    std::string key;    // "radius": the name in window.snug.state().readout
    std::string text;   // "2.118"
    double value = 0;
  };
  [[nodiscard]] std::vector<Figure> figures() const;
  /// Changes whenever anything that a view shows has changed.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// The hash of slot 0's trace.
  [[nodiscard]] std::uint64_t trace_hash() const { return hash_; }

 private:
  Session(Lesson lesson, AnyPointSet points);
  struct Snapshot {
    AnyPointSet points;
    std::vector<std::array<Index, 3>> triangles;
    std::uint64_t seed;
    bool edited;
  };
  struct Slot {
    const fit::Algorithm* algorithm = nullptr;
    fit::Recording recording;
  };

  Lesson lesson_;
  AnyPointSet points_;
  std::vector<std::array<Index, 3>> triangles_;
  std::optional<io::PointFile> mesh_;
  std::uint64_t seed_ = 1;
  bool edited_ = false;
  bool dragging_ = false;
  std::vector<Snapshot> past_;
  std::vector<Snapshot> future_;
  std::array<Slot, 2> slots_;
  fit::Recording optimum_;
  std::vector<Rival> rivals_;
  int step_ = 0;
  std::vector<Mark> marks_;
  std::vector<Asked> asked_;
  std::vector<Outcome> outcomes_;
  std::uint64_t revision_ = 0;
  std::uint64_t hash_ = 0;
};

}  // namespace snug::lesson
