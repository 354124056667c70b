// What only some subjects can do, a class for each; a subject says by Subject::abilities which it has.
#pragma once

#include <array>
#include <cstdint>
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
#include "lesson/stage_file.hpp"

namespace snug::lesson {

class Subject;
struct View;

using Point3 = Vector<double, 3>;
/// Nothing, or why it could not be done.
using Done = tl::expected<void, InputError>;
/// The state of a subject as numbers: a row for each point, box or volume.
using Rows = std::vector<std::vector<double>>;

/// Points that can be added, deleted, loaded and generated. If an edit is refused, nothing changes.
class HasPoints {
 public:
  /// In float, the rounded ones.
  [[nodiscard]] virtual const AnyPointSet& set_of_points() const = 0;
  /// The same before they were rounded to float.
  [[nodiscard]] virtual const AnyPointSet& unrounded_points() const { return set_of_points(); }
  /// The triangles of the mesh whose vertices the points are; empty otherwise.
  [[nodiscard]] virtual std::span<const std::array<Index, 3>> triangles() const = 0;
  virtual Done add(const Point3& at) = 0;
  virtual Done remove(Index i) = 0;
  virtual Done load(const io::PointFile& file, std::string_view name) = 0;
  /// own: the lesson's, as it opened.
  virtual Done set_generator(std::string_view kind, int count, int dim, std::uint64_t seed, const Subject& own) = 0;

 protected:
  ~HasPoints() = default;
};

/// Volumes that a test is given, or that are drawn.
class HasVolumes {
 public:
  /// Both of a pair, the body beside a frustum, in space; empty where only planes or nodes stand on the stage.
  [[nodiscard]] virtual std::vector<fit::Volume3> volumes() const { return {}; }
  /// Those that are drawn on paper.
  [[nodiscard]] virtual std::vector<fit::Volume3> on_paper() const { return volumes(); }
  /// The planes of a frustum, each a row: its normal, then d. None without one.
  [[nodiscard]] virtual Rows planes() const { return {}; }
  /// The nearest points of two volumes, A's first. Where they overlap, the points that would touch if B were moved out
  /// of A, from centre to centre. None if there are not two.
  [[nodiscard]] virtual std::optional<std::array<Point3, 2>> gap() const { return std::nullopt; }

 protected:
  ~HasVolumes() = default;
};

/// Runs that can be computed in float as well as in double.
class HasScalar {
 public:
  /// In float, what stands on the stage is rounded to float; double shows it as it was before. Errors: a coordinate
  /// that is too large for float.
  virtual Done set_float(bool in_float) = 0;

 protected:
  ~HasScalar() = default;
};

/// A part that the student can switch off and on, and what it did so far.
struct Switch {
  std::string name;
  bool on = true;
  std::int64_t constructed = 0, run = 0, skipped = 0;
  std::string microseconds;  // the time of a run; kept out of steps, figures and hashes, which are the same everywhere
  bool called = true;        // whether the subject calls for it now, and not only may do so
  bool optional = false;     // whether the student may add it to what the subject calls for, and take it out
  std::string says = {};     // what it did in the current step, and why; empty where that is not told
};

/// Parts that can be switched off: a scene's effects.
class HasParts {
 public:
  [[nodiscard]] virtual std::vector<Switch> switches(const View& view) const = 0;
  /// Switches a part off after view.step steps, or on again for all. Returns false if that is impossible.
  virtual bool turn(std::string_view name, bool on, const View& view) = 0;
  /// Adds a part to what the subject calls for, or takes it out. Errors: there is no such part.
  virtual Done call_for(std::string_view name, bool called) = 0;

 protected:
  ~HasParts() = default;
};

/// Steps that are frames: what stands on the stage moves by itself. It can be edited before the first frame alone,
/// where tasks begin as well. The ends of runs take too long to be worked out while something is dragged: a run records
/// its steps no farther than they are shown, and results and grades wait until the hand rests.
class HasFrames {
 public:
  /// The time that a frame simulates.
  [[nodiscard]] virtual double seconds_of_frame() const = 0;
  /// Why nothing can be moved after the first.
  [[nodiscard]] virtual std::string_view fixed_now() const = 0;
  /// Pushes what is at a handle, after view.step steps. Returns false if that is impossible.
  virtual bool push(Index i, const View& view) = 0;
  /// Whether parts are switched off, or something was pushed: then what the lesson says about its own run is not true.
  [[nodiscard]] virtual bool is_disturbed() const = 0;

 protected:
  ~HasFrames() = default;
};

/// A text that the stage is made from, where the student may edit it.
class HasText {
 public:
  [[nodiscard]] virtual StageFile file() const = 0;
  /// Becomes what a text says. One with mistakes is only kept, with what is wrong.
  virtual Done set_file(std::string text) = 0;

 protected:
  ~HasText() = default;
};

/// Goals that a requirement may name.
class HasGoals {
 public:
  /// Whether one of the row's goals is reached, and a sentence about it.
  [[nodiscard]] virtual bool reaches(std::string_view goal) const = 0;
  [[nodiscard]] virtual std::string goal_says(std::string_view goal) const = 0;

 protected:
  ~HasGoals() = default;
};

/// Null for what a subject does not have.
struct Abilities {
  HasPoints* points = nullptr;
  HasVolumes* volumes = nullptr;
  HasScalar* scalar = nullptr;
  HasParts* parts = nullptr;
  HasFrames* frames = nullptr;
  HasText* text = nullptr;
  HasGoals* goals = nullptr;
};

}  // namespace snug::lesson
