// What sliders can drive of two boxes besides their number fields: how nearly parallel they are, and how large.
#include "geometry/pose.hpp"
#include "geometry/turn.hpp"
#include "lesson/subjects/pair/pair.hpp"

namespace snug::lesson {
namespace {

constexpr std::string_view kAngle = "angle", kScale = "scale";
const Point3 kSlanting(1, 2, 3);  // in A's frame: along none of its edges

}  // namespace

std::vector<Drive> PairSubject::drives() const {
  std::vector<Drive> all = BoxSubject::drives();
  if (dim() == 3) all.push_back({.name = std::string(kAngle), .unit = "radians", .now = std::nullopt});
  all.push_back({.name = std::string(kScale), .unit = "", .now = std::nullopt, .rest = 1});
  return all;
}

Done PairSubject::drive(std::string_view name, double from, double to) {
  BoxPair next = boxes();
  if (name == kAngle && dim() == 3) {
    const Matrix<double, 3>& own = next.boxes[0].axes;
    next.boxes[1].axes = orthonormal<double, 3>(snug::turn(own * kSlanting, to) * own);
    return set_boxes(next);
  }
  if (name != kScale) return BoxSubject::drive(name, from, to);
  for (Obb<double, 3>& box : next.boxes) box.center *= to / from, box.half_extents *= to / from;
  next.knob *= to / from;
  return set_boxes(next);
}

}  // namespace snug::lesson
