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
#include <tl/expected.hpp>
#include <vector>

#include "fit/any_step.hpp"
#include "geometry/input_error.hpp"
#include "geometry/point_set.hpp"
#include "io/point_file.hpp"
#include "lesson/figures.hpp"
#include "lesson/grade.hpp"
#include "lesson/lesson.hpp"
#include "lesson/stage_file.hpp"

namespace snug::lesson {

struct Asked;
struct Asking;
struct SubjectRow;

using Point3 = Vector<double, 3>;
/// Nanoseconds since some moment; null for no clock.
using Clock = double (*)();
/// Nothing, or why it could not be done.
using Done = tl::expected<void, InputError>;

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

/// The state of a subject as numbers: a row for each point, box or volume.
using Rows = std::vector<std::vector<double>>;

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
  [[nodiscard]] virtual std::span<const Asking> askings(int i) const = 0;
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

/// A part of the subject that the student can switch off and on, and what it did so far.
struct Switch {
  std::string name;
  bool on = true;
  std::int64_t constructed = 0, run = 0, skipped = 0;
  std::string microseconds;  // the time of a run; kept out of steps, figures and hashes, which are the same everywhere
  bool called = true;        // whether the subject calls for it now, and not only may do so
  bool optional = false;     // whether the student may add it to what the subject calls for, and take it out
  std::string says = {};     // what it did in the current step, and why; empty where that is not told
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

  // ---- handles: what can be dragged, rotated, tapped -----------------------------------------------------------
  [[nodiscard]] virtual Index size() const = 0;
  [[nodiscard]] virtual Point3 at(Index i) const = 0;
  [[nodiscard]] virtual std::string name_of(Index i) const = 0;  // "P3", "A turn", "B2"
  /// What a handle is called, in singular and plural: "point", "points".
  [[nodiscard]] virtual std::array<std::string_view, 2> handle_words() const { return {"point", "points"}; }
  /// The handles of each thing on the stage: its points or vertices.
  [[nodiscard]] virtual std::vector<std::vector<Index>> things() const;

  /// The nearest points of the two volumes on it, A's first. Where they overlap, the points that would touch if B were
  /// moved out of A, from centre to centre. None if there are not two volumes.
  [[nodiscard]] virtual std::optional<std::array<Point3, 2>> gap() const { return std::nullopt; }

  /// The volumes that its tests are given, in space: both of a pair, the body beside a frustum. None of points.
  [[nodiscard]] virtual std::vector<fit::Volume3> volumes() const { return {}; }
  /// The volumes that are drawn on paper.
  [[nodiscard]] virtual std::vector<fit::Volume3> on_paper() const { return volumes(); }
  /// The planes of a frustum on it, each a row: its normal, then d. None without one.
  [[nodiscard]] virtual Rows planes() const { return {}; }

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
  virtual Done add(const Point3& at);
  virtual Done remove(Index i);
  virtual Done load(const io::PointFile& file, std::string_view name);
  virtual Done set_generator(std::string_view kind, int count, int dim, std::uint64_t seed, const Subject& own);
  /// own: the lesson's, as it opened.
  virtual void scatter(std::uint64_t seed, const Subject& own) = 0;
  /// Becomes what a task begins with.
  virtual void begin_task(const Lesson& lesson, const Task& task, const Subject& own) = 0;
  /// Whether the player then stands at the end, because a student who builds an example looks at results.
  [[nodiscard]] virtual bool task_begins_at_end() const { return true; }
  /// Whether things can be moved at a step, and if not, why.
  [[nodiscard]] virtual bool moves_at(int step) const { return step >= 0; }
  [[nodiscard]] virtual std::string_view fixed_now() const { return {}; }

  /// Whether its runs can be computed in float as well as in double.
  [[nodiscard]] virtual bool takes_float() const { return false; }
  [[nodiscard]] bool in_float() const { return origin_.in_float; }
  /// Chooses the scalar of its runs. In float, points are rounded to float; double shows them as they were before.
  /// Errors: it takes none but double; a coordinate that is too large for float.
  virtual Done set_float(bool in_float);

  /// The points, if the subject has points; null otherwise.
  [[nodiscard]] virtual const AnyPointSet* points() const { return nullptr; }
  /// The same before they were rounded to float.
  [[nodiscard]] virtual const AnyPointSet* unrounded_points() const { return points(); }
  /// The triangles of the mesh whose vertices the points are; empty otherwise.
  [[nodiscard]] virtual std::span<const std::array<Index, 3>> triangles() const { return {}; }

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
  /// Whether the ends of runs take too long to be worked out while something is dragged: a run records its steps no
  /// farther than they are shown, and results and grades wait until the hand rests.
  [[nodiscard]] virtual bool results_wait() const { return false; }
  /// The figures by which tasks and conditions are judged: those at the end, with every part switched on.
  [[nodiscard]] virtual std::vector<Figure> results(const Method& method, const View& view) const;
  /// The same after one of a scene's frames, counted from 1; none where there is no such frame.
  [[nodiscard]] virtual std::vector<Figure> results_at(const Method& method, int frame) const;
  /// The size of a method's final result: of a ball the radius, unless its area or volume is wanted. None if it has no
  /// volume.
  [[nodiscard]] virtual std::optional<double> result_size(const Method& method, bool by_measure,
                                                          const View& view) const;
  /// How many operations a method takes, all kinds together; 0 if they are not counted.
  [[nodiscard]] virtual std::int64_t operations(const Method& method) const;
  /// Whether one of the row's goals is reached, and a sentence about it.
  [[nodiscard]] virtual bool reaches(std::string_view goal) const;
  [[nodiscard]] virtual std::string goal_says(std::string_view goal) const;
  [[nodiscard]] virtual Grade grade(const Lesson& lesson, const Task& task, const View& view) const;
  [[nodiscard]] virtual std::vector<Switch> switches(const View& view) const;
  /// Switches a part off after view.step steps, or on again for all. Returns false if that is impossible.
  virtual bool turn(std::string_view name, bool on, const View& view);
  /// Adds a part to what the subject calls for, or takes it out. Errors: there is no such part.
  virtual Done call_for(std::string_view name, bool called);
  /// Pushes what is at a handle, after view.step steps. Returns false if that is impossible.
  virtual bool push(Index i, const View& view);
  /// The text that it is made from; none if that is not shown.
  [[nodiscard]] virtual std::optional<StageFile> file() const { return std::nullopt; }
  /// Becomes what a text says. One with mistakes is only kept, with what is wrong. Errors: it is made from no text.
  virtual Done set_file(std::string text);
  /// Whether parts are switched off, or something was pushed: then what the lesson says about its own run is not true.
  [[nodiscard]] virtual bool has_switched_off() const { return false; }

 protected:
  Subject() = default;
  Subject(const Subject&) = default;
  Subject& operator=(const Subject&) = default;
  Origin origin_;
};

/// The subject as a Type, or null if it is another kind. Type: has kRow, its row.
template <class Type>
[[nodiscard]] const Type* as(const Subject& subject) {
  return &subject.row() == &Type::kRow ? static_cast<const Type*>(&subject) : nullptr;
}

}  // namespace snug::lesson
