// What subjects with two boxes share: the boxes, and the places where they can be dragged: centres, knobs that rotate
// them, and vertices. The second box may taper, as a frustum does.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "geometry/obb.hpp"
#include "lesson/names.hpp"
#include "lesson/subject.hpp"

namespace snug::lesson {

class Session;

/// What A is: a box, a ball whose radius every half extent is, or a point, whose half extents are 0.
enum class Form : std::uint8_t { kBox, kBall, kPoint };

/// In 2-D z is 0, and the third axis is z.
struct BoxPair {
  int dim = 2;
  Form form = Form::kBox;
  std::array<Obb<double, 3>, 2> boxes;
  double knob = 0.5;      // the distance of a knob from its face, scene units
  double taper = 1;       // below 1, B is a frustum: the width of its near face over that of its far face
  bool in_float = false;  // whether the boxes are rounded to float, and tested in float
};

/// A place on a box that can be dragged.
struct BoxHandle {
  enum class Kind { kCenter, kTurn, kCorner, kRadius } kind = Kind::kCenter;
  int box = 0;     // 0: A, 1: B
  int number = 0;  // of a knob: its axis; of a vertex: its bits, 1 for +x, 2 for +y, 4 for +z
};

/// The number of places on a box: its centre, a knob (in 3-D two), its vertices. A's places come first, then B's.
[[nodiscard]] int places_of_box(int dim);
/// The same on A or B, whatever A is: a ball has its centre and its radius, a point itself.
[[nodiscard]] int places_of(const BoxPair& pair, int box);
[[nodiscard]] BoxHandle place_of(const BoxPair& pair, Index i);
[[nodiscard]] Index index_of(const BoxPair& pair, const BoxHandle& place);
// The same where A is a box, whatever the boxes are:
[[nodiscard]] BoxHandle place_of(int dim, Index i);
[[nodiscard]] Index index_of(int dim, const BoxHandle& place);
/// "A", "A turn", "A3".
[[nodiscard]] std::string place_name(int dim, Index i);
/// The indices of a box's vertices.
[[nodiscard]] std::vector<Index> vertices_of(int dim, int box);
[[nodiscard]] Vector<double, 3> at_place(const BoxPair& pair, Index i);

/// The same boxes rounded to float, to be tested in float.
[[nodiscard]] BoxPair rounded_to_float(const BoxPair& pair);

/// Whether every place has coordinates that a point of the pair's scalar may have. Errors: as of PointSet::make.
[[nodiscard]] Done check_places(const BoxPair& pair);

/// The pair with a place moved: the centre moves the whole box, a knob rotates it, and a vertex leaves the opposite one
/// fixed. Errors: a coordinate that is not finite or too large.
[[nodiscard]] tl::expected<BoxPair, InputError> moved(const BoxPair& pair, Index place, const Vector<double, 3>& to);

/// A box rotated about a world axis through its centre (in 2-D about z), counter-clockwise. axis: 0 … 2.
[[nodiscard]] Obb<double, 3> turned_by(const Obb<double, 3>& box, int axis, double radians);

/// The angle from the x axis to the box's first axis, in 2-D; radians, in (-pi, pi].
[[nodiscard]] double angle_of(const Obb<double, 3>& box);

/// A pair of boxes of the same sizes, with random positions and orientations.
[[nodiscard]] BoxPair scattered(const BoxPair& like, std::uint64_t seed);

/// The vertex with those bits of one of the pair, even of a frustum. box: 0 or 1.
[[nodiscard]] Vector<double, 3> corner_of(const BoxPair& pair, int box, int bits);
/// The point off the middle of the face on an axis's positive side; for a frustum's sides, half way from near to far.
[[nodiscard]] Vector<double, 3> beyond_face(const BoxPair& pair, int box, int axis, double by);
/// The vertex with those bits.
[[nodiscard]] Vector<double, 3> corner_of(const Obb<double, 3>& box, int bits);

/// The box in the plane.
[[nodiscard]] Obb<double, 2> flat(const Obb<double, 3>& box);

/// Reads two boxes from a lesson's file, where each key has a list of two. turn: degrees, in 3-D about x, then y, then
/// z. taper: 1 for two boxes. Of a ball or a point only the centre is listed, and of a ball a radius.
[[nodiscard]] BoxPair read_pair(TomlTable& table, int dim, double taper, Form form = Form::kBox);

class BoxSubject : public Subject, public HasScalar {
 public:
  [[nodiscard]] const BoxPair& boxes() const { return pair_; }
  [[nodiscard]] int dim() const override { return pair_.dim; }
  [[nodiscard]] Index size() const override { return places_of(pair_, 0) + places_of(pair_, 1); }
  [[nodiscard]] Point3 at(Index i) const override { return at_place(pair_, i); }
  [[nodiscard]] std::string name_of(Index i) const override { return place_name(pair_.dim, i); }
  [[nodiscard]] std::array<std::string_view, 2> handle_words() const override { return {"vertex", "vertices"}; }
  [[nodiscard]] std::vector<std::vector<Index>> things() const override;
  [[nodiscard]] std::string_view stage_says() const override { return "two boxes"; }
  [[nodiscard]] Tools tools() const override { return {"Boxes", "Boxes"}; }
  [[nodiscard]] std::vector<NumberGroup> numbers() const override;
  /// In space, a turn rotates the box about a world axis by so many degrees.
  Done set_numbers(std::size_t group, std::size_t row, std::span<const double> values) override;
  [[nodiscard]] Rows rows() const override;
  Done set_rows(const Rows& rows) override;
  /// A box's heading, its name in a sentence, and the heading of its sizes.
  struct Words {
    std::string_view heading, name, sizes;
  };
  [[nodiscard]] virtual Words words_of(int box) const {
    return box == 0 ? Words{"Box A", "A", "Half extents"} : Words{"Box B", "B", "Half extents"};
  }
  Done move(Index i, const Point3& to) override;
  Done set_float(bool in_float) override;
  /// Replaces the boxes. Errors: another dimension; a number that is not finite, a half extent below 0; the errors of
  /// check.
  Done set_boxes(const BoxPair& pair);
  void scatter(std::uint64_t seed, const Subject& own) override;
  void begin_task(const Lesson& lesson, const Task& task, const Subject& own) override;

 protected:
  [[nodiscard]] Abilities abilities() override { return {.scalar = this}; }
  BoxSubject(BoxPair pair, std::uint64_t seed) : lesson_seed_(seed), pair_(std::move(pair)) { origin_.seed = seed; }
  BoxSubject(const BoxSubject&) = default;
  BoxSubject& operator=(const BoxSubject&) = default;
  /// Whether these boxes are possible.
  [[nodiscard]] virtual Done check(const BoxPair& pair) const { return check_places(pair); }
  /// The boxes before they were rounded to float; in double, the boxes.
  [[nodiscard]] const BoxPair& unrounded() const { return unrounded_ ? *unrounded_ : pair_; }

 private:
  /// Puts boxes on the stage, rounded if the runs are in float. Errors: those of check.
  Done hold(BoxPair pair, bool in_float);

  std::uint64_t lesson_seed_;
  BoxPair pair_;
  std::optional<BoxPair> unrounded_;
};

/// The boxes of a subject that is a BoxSubject.
[[nodiscard]] inline const BoxPair& boxes_of(const Subject& subject) {
  return static_cast<const BoxSubject&>(subject).boxes();
}
/// The rows of two boxes (Subject::rows).
[[nodiscard]] Rows rows_of(const BoxPair& pair);
/// Reads a task's "model", a table written as [boxes] is. read: reads its boxes, of the dimension, taper and form of
/// like.
[[nodiscard]] Rows read_box_model(TomlTable& task, const Lesson& lesson, Complaints& complaints,
                                  BoxPair (*read)(TomlTable& table, const BoxPair& like));
/// Replaces the boxes of a session's BoxSubject, as one edit.
Done set_boxes(Session& session, const BoxPair& pair);

/// What a lesson's file says about two boxes.
struct BoxTables : Tables {
  BoxPair boxes;
};

}  // namespace snug::lesson
