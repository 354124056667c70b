// Two boxes on the stage, or a box and a frustum (frustum_box.hpp), and the places by which a hand takes them: centres,
// knobs that turn them, corners.
#pragma once

#include <array>
#include <string>
#include <tl/expected.hpp>

#include "geometry/input_error.hpp"
#include "geometry/obb.hpp"
#include "geometry/point_set.hpp"

namespace snug::lesson {

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
/// "A", "A turn", "A3"; of a box and a frustum "Box", "Box turn", "+−" (sign_name), "Frustum", "Frustum turn", "F3".
[[nodiscard]] std::string place_name(int dim, Index i, bool frustum = false);
[[nodiscard]] Vector<double, 3> at_place(const BoxPair& pair, Index i);

/// Every place, as a set. Errors: as of PointSet::make; of a frustum, as of frustum_of.
[[nodiscard]] tl::expected<AnyPointSet, InputError> places(const BoxPair& pair);

/// The pair with a place moved: the centre takes its box along, a knob turns it, a corner leaves the opposite one where
/// it is. Errors: a coordinate that is not finite or too large. A frustum may become flat, which places() refuses.
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

/// In the plane.
[[nodiscard]] Obb<double, 2> flat(const Obb<double, 3>& box);

}  // namespace snug::lesson
