// The cylinders on the axes of two capsules, which GJK tests as it tests any convex volumes.
#include "geometry/cylinder.hpp"
#include "lesson/subjects/pair/volumes.hpp"
#include "query/distance/gjk.hpp"

namespace snug::lesson {
namespace {

std::optional<Cylinder<double, 3>> cylinder_of(const HeldVolume& held) {
  const auto* capsule = std::get_if<Capsule<double, 3>>(&held.volume);
  if (capsule == nullptr || capsule->a == capsule->b) return std::nullopt;
  return Cylinder<double, 3>{capsule->a, capsule->b, capsule->radius};
}

}  // namespace

std::optional<AsCylinders> as_cylinders(const VolumePair& pair) {
  const auto a = cylinder_of(pair.held[0]), b = cylinder_of(pair.held[1]);
  if (!a || !b) return std::nullopt;
  const auto found = query::gjk(*a, *b);
  if (!found) return std::nullopt;
  return AsCylinders{found->overlap, found->overlap ? 0 : found->distance, found->turns};
}

}  // namespace snug::lesson
