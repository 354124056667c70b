// A volume with handles to move, rotate and change it. Each kind of volume has its own handles.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "fit/any_step.hpp"
#include "geometry/input_error.hpp"
#include "lesson/subject.hpp"

namespace snug::lesson {

/// What a handle does to its volume.
struct Handle {
  enum class Kind {
    kCenter,  // moves the whole volume
    kTurn,    // rotates it; number: the axis of the knob
    kVertex,  // a vertex of the core, in the order of core_corners; for a hull, one of its points
    kRadius,  // a place on the boundary
    kBound,   // of a k-DOP; number: twice the slab's index, plus 1 for its greater bound
  } kind = Kind::kCenter;
  int number = 0;
  friend bool operator==(const Handle&, const Handle&) = default;
};

struct HeldVolume {
  fit::Volume3 volume;
  int dim = 2;
  std::vector<Point3> points;  // for a hull: the points that it is the hull of
  double knob = 0.5;           // the distance of a knob, scene units
};

/// The handles in order: the centre, the knobs, all others.
[[nodiscard]] std::vector<Handle> handles_of(const HeldVolume& held);
[[nodiscard]] Point3 at_handle(const HeldVolume& held, const Handle& handle);
/// What follows the volume's name in a handle's name: "", " turn", "3", " radius", " +x−y".
[[nodiscard]] std::string handle_name(const HeldVolume& held, const Handle& handle);

/// The volume with a handle moved to a place. Errors: a coordinate that is not finite or too large; slabs that would
/// have no point in common.
[[nodiscard]] tl::expected<HeldVolume, InputError> moved(const HeldVolume& held, const Handle& handle,
                                                         const Point3& to);

/// What is wrong with a volume that was read, as a sentence fragment; empty for nothing.
[[nodiscard]] std::string fault_of(const HeldVolume& held);

/// The volume with its numbers rounded to float; of a hull, the hull of the rounded points.
[[nodiscard]] HeldVolume rounded_to_float(const HeldVolume& held);

/// The volume rotated about its centre, if its kind can rotate, and moved.
[[nodiscard]] HeldVolume placed(const HeldVolume& held, const Matrix<double, 3>& rotation, const Point3& by);

}  // namespace snug::lesson
