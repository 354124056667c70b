// What a lesson's stage is about: what is on it, the handles for dragging it, and what each step of a method's run
// says. Each subject has its folder under subjects/; a session knows them only through this header.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/abilities.hpp"
#include "lesson/figures.hpp"
#include "lesson/grade.hpp"
#include "lesson/lesson.hpp"

namespace snug::lesson {

struct Asked;
struct QuestionKind;
struct SubjectRow;

/// Nanoseconds since some moment; null for no clock.
using Clock = double (*)();

/// Something whose steps can be watched: an algorithm, a test, an update.
struct Method {
  std::string_view volume;                                  // the lesson's volume that it belongs to
  std::string_view name;                                    // as scripts say it: "ritter_iterative"
  std::string_view title;                                   // as people say it: "Iterative Ritter"
  std::string_view source;                                  // author, title, year
  std::span<const std::string_view> pseudocode;             // steps name its lines, counted from 0
  std::span<const std::string_view> plane_pseudocode = {};  // in 2-D, if that differs; empty otherwise
  bool exact = false;                                       // whether it guarantees the smallest volume of its kind
  Index max_points = std::numeric_limits<Index>::max();     // more are refused
  bool plane = true, space = true;                          // the dimensions that it takes
  bool naive = false;    // as textbooks print it: rounding may cost it its digits, or leave points outside
  bool by_hand = false;  // whether its result is what the student makes of it
};

[[nodiscard]] inline std::span<const std::string_view> pseudocode_of(const Method& method, int dim) {
  return dim == 2 && !method.plane_pseudocode.empty() ? method.plane_pseudocode : method.pseudocode;
}

/// The tools that edit the subject by buttons and number fields.
struct Tools {
  std::string_view word;   // a short name: "Boxes"
  std::string_view title;  // their heading
  bool points = false;     // whether points can be added, deleted, loaded, and moved by their coordinates
};

/// A row of number fields.
struct NumberRow {
  std::string_view words;               // its heading: "Centre"
  std::vector<std::string_view> names;  // a name for each number: "x"; empty for a single number
  std::vector<double> values;
  std::string_view unit = "";   // "degrees"; empty for scene units
  double turn = 0;              // > 0: each number rotates about an axis by so many degrees; this is the usual angle
  std::string_view drive = "";  // its name in that of a Drive, after the group's: "turn"; empty for none
};

/// The number fields of one thing on the stage.
struct NumberGroup {
  std::string_view heading, name;  // "Box A"; in a sentence "A"
  std::vector<NumberRow> rows;
  std::string drive = {};  // its name in that of a Drive: "A"
};

/// A number that a slider can drive.
struct Drive {
  std::string name;  // as lesson files say it: "B turn", "offset"
  std::string_view unit = "units";
  std::optional<double> now;  // none if it cannot be told from what stands on the stage
  double rest = 0;            // if it cannot be told: the value at which it changes nothing
  bool whole = false;         // whether it takes whole numbers only
  bool by_hand = false;       // whether it moves nothing but what a method by hand starts from
};

/// A mark on the timeline: a step that matters. step: the player's place that shows it, for go.
struct Mark {
  int step = 0;
  enum class Kind {
    kGrew,      // there is a volume, or it grew
    kReplaced,  // the support set was replaced, or a verdict was reached
    kQuestion,  // a question is asked here
    kBest,      // the volume became the best so far, or an axis or a plane decides
    kWrong,     // a naive algorithm's first wrong test, or a wrong row or verdict
  } kind = Kind::kGrew;
};

/// The keys of figures that are hidden while a question about them is open; now: the one that is asked for now.
struct Untold {
  std::vector<std::string_view> figures;
  std::string_view now;
  [[nodiscard]] bool hides(std::string_view figure) const;
};

/// A recorded run of a method: its steps, which are facts, and everything that a lesson says about them. It refers to
/// the subject that it was made on, which must not change.
class Run {
 public:
  Run() = default;
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  virtual ~Run();

  [[nodiscard]] virtual int steps() const = 0;
  // For step i, counted from 0:
  [[nodiscard]] virtual std::string_view fact(int i) const = 0;  // its name: "ball_grown"
  [[nodiscard]] virtual int line(int i) const = 0;               // of the pseudocode
  [[nodiscard]] virtual std::string sentence(int i, const Untold& untold) const = 0;
  /// The handles that it is about, any of which is a right answer to "which".
  [[nodiscard]] virtual std::vector<Index> handles(int i) const = 0;
  /// What happens to them, in the present tense: "is chosen"; plural: "are chosen".
  [[nodiscard]] virtual std::string predicate(int i, bool plural) const = 0;
  [[nodiscard]] virtual std::optional<Mark::Kind> mark(int i) const = 0;
  /// What can be asked of it, besides "point" and "choice", which can be asked of any step.
  [[nodiscard]] virtual std::span<const QuestionKind> question_kinds(int i) const = 0;
  /// Whether gates count it: of a recursion, only the outermost calls count.
  [[nodiscard]] virtual bool counts(int i) const = 0;
  /// Whether it happened only by rounding, so that nothing sensible can be asked of it.
  [[nodiscard]] virtual bool is_rounding(int /*i*/) const { return false; }
  /// The handles that can be tapped when the step is asked for "point"; empty: all of them.
  [[nodiscard]] virtual std::vector<Index> candidates(int i) const;
  /// A hash over every number of every step, in order.
  [[nodiscard]] virtual std::uint64_t hash() const = 0;
  /// The volume after the first `steps` steps; null if there is none.
  [[nodiscard]] virtual const fit::Volume3* volume(int steps) const = 0;
  /// The handles that support the volume after the first `steps` steps: those that it touches by construction.
  [[nodiscard]] virtual std::vector<Index> support(int steps) const;
};

/// What a session shows in a slot. method is null if the slot is empty.
struct Slot {
  const Method* method = nullptr;
  const Run* run = nullptr;
};

/// The current place in a session, for whoever describes it.
struct View {
  std::array<Slot, 2> slots;  // the main one, and the one for comparison
  int slot = 0;               // which slot is meant, and
  int step = 0;               // how many of its steps are shown
  bool in_hand = false;  // whether something is being dragged: what takes long and tells little waits until it rests
  [[nodiscard]] const Method& method() const { return *slots[slot].method; }
  [[nodiscard]] const Run& run() const { return *slots[slot].run; }
  [[nodiscard]] bool at_end() const { return step == run().steps(); }
};

/// One of the lesson's methods with its result: "Final result, compared".
struct Rival {
  const Method* method = nullptr;
  double size = 0;               // a ball's radius; for any other volume its area or volume
  std::optional<double> excess;  // over the optimum, 0.1 for 10 per cent; none if that is unknown
};

class Subject {
 public:
  /// Where the subject came from.
  struct Origin {
    std::string source = "own";  // a generator's kind, a mesh's or file's name, "own" for the lesson's own, "task"
    int generated = 0;           // how many points the source's generator made; 0 without one
    std::uint64_t seed = 1;
    bool edited = false;  // whether it differs from the lesson's own for this seed
    std::string situation{kOwnSituation};
    bool in_float = false;  // whether its runs are computed in float, on points rounded to float
    friend bool operator==(const Origin&, const Origin&) = default;
  };

  virtual ~Subject();
  [[nodiscard]] virtual const SubjectRow& row() const = 0;
  [[nodiscard]] virtual std::unique_ptr<Subject> clone() const = 0;
  [[nodiscard]] const Origin& origin() const { return origin_; }
  virtual void set_origin(Origin origin) { origin_ = std::move(origin); }
  [[nodiscard]] virtual int dim() const = 0;
  /// The subject whose runs it shows: for a chart, its cloud.
  [[nodiscard]] virtual const Subject& shape() const { return *this; }
  [[nodiscard]] bool in_float() const { return origin_.in_float; }

  // ---- what only some can do: null for the others --------------------------------------------------------------
  [[nodiscard]] HasPoints* with_points() { return abilities().points; }
  [[nodiscard]] HasVolumes* with_volumes() { return abilities().volumes; }
  [[nodiscard]] HasScalar* scalar() { return abilities().scalar; }
  [[nodiscard]] HasParts* parts() { return abilities().parts; }
  [[nodiscard]] HasFrames* frames() { return abilities().frames; }
  [[nodiscard]] HasText* text() { return abilities().text; }
  [[nodiscard]] HasGoals* goals() { return abilities().goals; }
  [[nodiscard]] const HasPoints* with_points() const { return own_abilities().points; }
  [[nodiscard]] const HasVolumes* with_volumes() const { return own_abilities().volumes; }
  [[nodiscard]] const HasScalar* scalar() const { return own_abilities().scalar; }
  [[nodiscard]] const HasParts* parts() const { return own_abilities().parts; }
  [[nodiscard]] const HasFrames* frames() const { return own_abilities().frames; }
  [[nodiscard]] const HasText* text() const { return own_abilities().text; }
  [[nodiscard]] const HasGoals* goals() const { return own_abilities().goals; }
  [[nodiscard]] std::optional<StageFile> file() const;
  /// The points alone.
  [[nodiscard]] const AnyPointSet* points() const;
  /// Whether things can be moved at a step.
  [[nodiscard]] bool moves_at(int step) const { return frames() == nullptr ? step >= 0 : step == 0; }

  // ---- handles: what can be dragged, rotated, tapped -----------------------------------------------------------
  [[nodiscard]] virtual Index size() const = 0;
  [[nodiscard]] virtual Point3 at(Index i) const = 0;
  [[nodiscard]] virtual std::string name_of(Index i) const = 0;  // "P3", "A turn", "B2"
  /// What a handle is called, in singular and plural: "point", "points".
  [[nodiscard]] virtual std::array<std::string_view, 2> handle_words() const { return {"point", "points"}; }
  /// The handles of each thing on the stage: its points or vertices.
  [[nodiscard]] virtual std::vector<std::vector<Index>> things() const;

  /// What is on the stage, in words, for people who cannot see it.
  [[nodiscard]] virtual std::string_view stage_says() const = 0;

  // ---- tools --------------------------------------------------------------------------------------------------
  [[nodiscard]] virtual Tools tools() const = 0;
  /// Its number fields; none if it is edited only by hand.
  [[nodiscard]] virtual std::vector<NumberGroup> numbers() const { return {}; }
  /// Sets a row of numbers. values: as many as the row has. Errors: there is no such row; those of move.
  virtual Done set_numbers(std::size_t group, std::size_t row, std::span<const double> values);
  /// What sliders can drive: by default its number fields.
  [[nodiscard]] virtual std::vector<Drive> drives() const;
  /// Drives one of these from a value to another. Errors: there is none of that name; those of move.
  virtual Done drive(std::string_view name, double from, double to);
  /// Everything that edits can change, exact to the last bit.
  [[nodiscard]] virtual Rows rows() const = 0;
  /// Restores that state. Errors: these are not rows of such a subject; those of move.
  virtual Done set_rows(const Rows& rows) = 0;

  // ---- edits: if one is refused, nothing changes ------------------------------------------------
  virtual Done move(Index i, const Point3& to) = 0;
  /// own: the lesson's, as it opened.
  virtual void scatter(std::uint64_t seed, const Subject& own) = 0;
  /// Becomes what a task begins with.
  virtual void begin_task(const Lesson& lesson, const Task& task, const Subject& own) = 0;

  // ---- runs ---------------------------------------------------------------------------------------------------
  /// earlier: a run whose memory is reused, or null.
  [[nodiscard]] virtual std::unique_ptr<Run> run(const Method& method, std::unique_ptr<Run> earlier) const = 0;
  /// Why the method cannot be run on its points: "Brute force takes at most 40 points"; empty where it can.
  [[nodiscard]] virtual std::string refusal(const Method& method) const;
  [[nodiscard]] bool suits(const Method& method) const { return refusal(method).empty(); }
  /// The sentence before the first step.
  [[nodiscard]] virtual std::string opening(const Method& method) const = 0;

  // ---- what is said about a run ----------------------------------------------------------------------------------
  [[nodiscard]] virtual std::vector<Figure> figures(const View& view) const = 0;
  [[nodiscard]] virtual std::vector<Proof> proofs(const View& view) const = 0;
  /// The lesson's methods with their results, in order; none if there is nothing to compare.
  [[nodiscard]] virtual std::vector<Rival> rivals(const Lesson& lesson, const View& view) const;
  /// The figures at the end of a method's run. A run that the view has is not repeated.
  [[nodiscard]] virtual std::vector<Figure> figures_at_end(const Method& method, const View& view) const;
  /// The figures by which tasks and conditions are judged: those at the end, with every part switched on.
  [[nodiscard]] virtual std::vector<Figure> results(const Method& method, const View& view) const;
  /// The size of a method's final result: of a ball the radius, unless its area or volume is wanted. None if it has no
  /// volume.
  [[nodiscard]] virtual std::optional<double> result_size(const Method& method, bool by_measure,
                                                          const View& view) const;
  /// How many operations a method takes, all kinds together; 0 if they are not counted.
  [[nodiscard]] virtual std::int64_t operations(const Method& method) const;
  [[nodiscard]] virtual Grade grade(const Lesson& lesson, const Task& task, const View& view) const;

 protected:
  Subject() = default;
  Subject(const Subject&) = default;
  Subject& operator=(const Subject&) = default;
  /// Those that it has, which it is itself.
  [[nodiscard]] virtual Abilities abilities() { return {}; }
  Origin origin_;

 private:
  /// Whoever has only a const subject is given no more than const abilities.
  [[nodiscard]] Abilities own_abilities() const { return const_cast<Subject*>(this)->abilities(); }
};

/// The subject as a Type, or null if it is another kind. Type: has kRow, its row.
template <class Type>
[[nodiscard]] const Type* as(const Subject& subject) {
  return &subject.row() == &Type::kRow ? static_cast<const Type*>(&subject) : nullptr;
}

}  // namespace snug::lesson
