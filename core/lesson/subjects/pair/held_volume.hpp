// A volume as a hand takes it: the handles by which it is moved, turned and changed. Each kind of volume has its own.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "fit/any_step.hpp"
#include "geometry/input_error.hpp"
#include "lesson/subject.hpp"

namespace snug::lesson {

/// What a handle is of its volume.
struct Handle {
  enum class Kind {
    kCenter,  // takes the volume along
    kTurn,    // turns it; number: the axis that the knob stands on
    kVertex,  // of the volume's core, in the order of query::core_corners; of a hull one of its points
    kRadius,  // a place on the boundary
    kBound,   // of a k-DOP; number: twice the slab, 1 more for its greater bound
  } kind = Kind::kCenter;
  int number = 0;
  friend bool operator==(const Handle&, const Handle&) = default;
};

struct HeldVolume {
  fit::Volume3 volume;
  int dim = 2;
  std::vector<Point3> points;  // of a hull: those that it is the hull of
  double knob = 0.5;           // how far a knob stands off, scene units
};

/// In their order: the centre, the knobs, all others.
[[nodiscard]] std::vector<Handle> handles_of(const HeldVolume& held);
[[nodiscard]] Point3 at_handle(const HeldVolume& held, const Handle& handle);
/// "", " turn", "3", " radius", " +x−y": what stands after the volume's name.
[[nodiscard]] std::string handle_name(const HeldVolume& held, const Handle& handle);

/// The volume with a handle moved to a place. Errors: a coordinate that is not finite or too large; slabs that would
/// have no point in common.
[[nodiscard]] tl::expected<HeldVolume, InputError> moved(const HeldVolume& held, const Handle& handle,
                                                         const Point3& to);

/// What is wrong with a volume that was read, in one fragment; empty for nothing.
[[nodiscard]] std::string fault_of(const HeldVolume& held);

/// Turned about its centre, as far as its kind can be, and moved.
[[nodiscard]] HeldVolume placed(const HeldVolume& held, const Matrix<double, 3>& rotation, const Point3& by);

/// What stands for a direction of a k-DOP: "+x−y"; and for its axis: "x−y".
[[nodiscard]] std::string direction_name(const Point3& direction);
[[nodiscard]] std::string axis_name(const Point3& direction);

}  // namespace snug::lesson
