#include "lesson/subjects/pair/gap.hpp"

namespace snug::lesson {
namespace {

constexpr int kHalvings = 48;  // the way out is then known to about the last digits of a double

VolumePair with_b_moved(VolumePair pair, const Point3& by) {
  HeldVolume& b = pair.held[1];
  if (auto next = moved(b, {}, at_handle(b, {}) + by)) b = *std::move(next);
  return pair;
}

}  // namespace

std::array<Point3, 2> gap_of(const VolumePair& pair) {
  if (const auto apart = separation_of(pair)) return {apart->on_a, apart->on_b};
  const Point3 between = at_handle(pair.held[1], {}) - at_handle(pair.held[0], {});
  const Point3 way = between.norm() > 0 ? Point3(between.normalized()) : Point3(Point3::UnitX());
  double in = 0, out = reach_along(pair.held[0], way) + reach_along(pair.held[1], -way);
  out = std::max(out * (1 + 1e-6), 1e-300);  // clear of rounding
  auto apart = separation_of(with_b_moved(pair, way * out));
  for (int i = 0; apart && i < kHalvings; ++i) {
    const double middle = in + (out - in) / 2;
    if (const auto there = separation_of(with_b_moved(pair, way * middle))) apart = there, out = middle;
    else in = middle;
  }
  if (!apart) return {at_handle(pair.held[0], {}), at_handle(pair.held[1], {})};
  return {apart->on_a, apart->on_b - way * out};
}

VolumePair as_volumes(const BoxPair& boxes) {
  const auto held = [&](int i) { return HeldVolume{fit::Volume3(boxes.boxes[i]), boxes.dim, {}, boxes.knob}; };
  return {boxes.dim, {held(0), held(1)}};
}

std::optional<std::array<Point3, 2>> PairSubject::gap() const { return gap_of(as_volumes(boxes())); }
std::optional<std::array<Point3, 2>> VolumesSubject::gap() const { return gap_of(pair_); }

}  // namespace snug::lesson
