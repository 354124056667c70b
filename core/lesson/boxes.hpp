// What subjects that are made of two boxes share: the boxes, and the places by which a hand takes them: centres, knobs
// that turn them, vertices. The second box may taper, as a frustum does.
#pragma once

#include <array>
#include <string>
#include <tl/expected.hpp>

#include "geometry/obb.hpp"
#include "lesson/names.hpp"
#include "lesson/subject.hpp"

namespace snug::lesson {

class Session;

/// In 2-D z is 0 and the third axis z.
struct BoxPair {
  int dim = 2;
  std::array<Obb<double, 3>, 2> boxes;
  double knob = 0.5;  // how far a knob stands off its face, scene units
  double taper = 1;   // below 1 B is a frustum: its near face is so much smaller than its far one
};

/// What a place is of its box.
struct Place {
  enum class Kind { kCenter, kTurn, kCorner } kind = Kind::kCenter;
  int box = 0;     // 0: A, 1: B
  int number = 0;  // of a knob: the axis that it stands on; of a corner: its bits, 1 for +x, 2 for +y, 4 for +z
};

/// The places of A, then those of B: the centre, a knob (in 3-D two), the corners.
[[nodiscard]] int places_of_box(int dim);
[[nodiscard]] Place place_of(int dim, Index i);
[[nodiscard]] Index index_of(int dim, const Place& place);
/// "A", "A turn", "A3".
[[nodiscard]] std::string place_name(int dim, Index i);
/// The indices of a box's vertices.
[[nodiscard]] std::vector<Index> vertices_of(int dim, int box);
[[nodiscard]] Vector<double, 3> at_place(const BoxPair& pair, Index i);

/// Whether every place has coordinates that a point may have. Errors: as of PointSet::make.
[[nodiscard]] Done check_places(const BoxPair& pair);

/// The pair with a place moved: the centre takes its box along, a knob turns it, a corner leaves the opposite one where
/// it is. Errors: a coordinate that is not finite or too large.
[[nodiscard]] tl::expected<BoxPair, InputError> moved(const BoxPair& pair, Index place, const Vector<double, 3>& to);

/// A box turned about one of the world's axes through its centre (in 2-D about z), counter-clockwise. axis: 0 … 2.
[[nodiscard]] Obb<double, 3> turned_by(const Obb<double, 3>& box, int axis, double radians);

/// The angle from the x axis to the box's first axis, in 2-D; radians, in (-pi, pi].
[[nodiscard]] double angle_of(const Obb<double, 3>& box);

/// A pair like this one with boxes of its sizes, placed and turned at random.
[[nodiscard]] BoxPair scattered(const BoxPair& like, std::uint64_t seed);

/// The corner of one of the pair's with those bits, of a frustum as well. box: 0 or 1.
[[nodiscard]] Vector<double, 3> corner_of(const BoxPair& pair, int box, int bits);
/// A place off the middle of the face on an axis's positive side; of a frustum's sides, half way between near and far.
[[nodiscard]] Vector<double, 3> beyond_face(const BoxPair& pair, int box, int axis, double by);
/// The corner with those bits.
[[nodiscard]] Vector<double, 3> corner_of(const Obb<double, 3>& box, int bits);

/// The box in the plane.
[[nodiscard]] Obb<double, 2> flat(const Obb<double, 3>& box);

/// Two boxes of a lesson's file: each key has a list of two. turn: degrees, in 3-D about x, then y, then z. taper: 1 of
/// two boxes.
[[nodiscard]] BoxPair read_pair(TomlTable& table, int dim, double taper);

class BoxSubject : public Subject {
 public:
  [[nodiscard]] const BoxPair* boxes() const final { return &pair_; }
  [[nodiscard]] int dim() const override { return pair_.dim; }
  [[nodiscard]] Index size() const override { return 2 * places_of_box(pair_.dim); }
  [[nodiscard]] Point3 at(Index i) const override { return at_place(pair_, i); }
  [[nodiscard]] std::string name_of(Index i) const override { return place_name(pair_.dim, i); }
  [[nodiscard]] std::array<std::string_view, 2> handle_words() const override { return {"vertex", "vertices"}; }
  [[nodiscard]] std::string_view tools_word() const override { return "Boxes"; }
  /// A box's heading, what it is called in a sentence, and what its three sizes are.
  struct Words {
    std::string_view heading, name, sizes;
  };
  [[nodiscard]] virtual Words words_of(int box) const {
    return box == 0 ? Words{"Box A", "A", "Half extents"} : Words{"Box B", "B", "Half extents"};
  }
  Done move(Index i, const Point3& to) override;
  /// Other boxes in the place of these. Errors: of another dimension; a number that is not finite, a half extent below
  /// 0; as of check.
  Done set_boxes(const BoxPair& pair) override;
  void scatter(std::uint64_t seed, const Subject& own) override;
  void begin_task(const Lesson& lesson, const Subject& own) override;

 protected:
  BoxSubject(BoxPair pair, std::uint64_t seed) : lesson_seed_(seed), pair_(std::move(pair)) { origin_.seed = seed; }
  BoxSubject(const BoxSubject&) = default;
  BoxSubject& operator=(const BoxSubject&) = default;
  /// Whether there can be such boxes at all.
  [[nodiscard]] virtual Done check(const BoxPair& pair) const { return check_places(pair); }

 private:
  std::uint64_t lesson_seed_;
  BoxPair pair_;
};

/// Null where the subject is not made of boxes.
[[nodiscard]] inline const BoxSubject* as_boxes(const Subject& subject) {
  return subject.boxes() != nullptr ? static_cast<const BoxSubject*>(&subject) : nullptr;
}

/// What a lesson's file says of two boxes.
struct BoxTables : Tables {
  BoxPair boxes;
};

/// What a task on two boxes asks for: goals, reached one after the other.
struct BoxTask : Tables {
  std::vector<std::string> goals;
  std::vector<BoxPair> models;  // one a goal
};

/// A goal by its name, on two boxes.
struct BoxGoals {
  bool (*reaches)(std::string_view goal, const BoxPair& pair);
  /// What there is to say of it. now: whether it is reached; found: whether it ever was.
  std::string (*sentence)(std::string_view goal, const BoxPair& pair, bool now, bool found);
};

/// names: of the goals that there are. read: a [[task.model]].
void read_box_task(TomlTable& table, Lesson& lesson, Complaints& complaints, std::span<const std::string_view> names,
                   BoxPair (*read)(TomlTable& table, const BoxPair& like));
/// Every goal is reached by its model, but not at the start.
void check_box_task(const Lesson& lesson, const toml::table& toml, const Subject& own, const BoxGoals& goals,
                    Complaints& complaints);
/// Plays the models, one after the other.
tl::expected<Grade, InputError> play_box_task(Session& session);
/// found: which goals were reached before; those that are reached now are added.
[[nodiscard]] Grade grade_box_task(const Lesson& lesson, const BoxPair& pair, const BoxGoals& goals,
                                   std::vector<bool>& found);

}  // namespace snug::lesson
