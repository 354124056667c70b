#include "lesson/subjects/tree/node_volume.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "fit/lift.hpp"
#include "fit/merge/merge.hpp"
#include "hierarchy/bounds.hpp"

namespace snug::lesson {
namespace {

constexpr std::array<std::string_view, 3> kKindNames{"aabb", "sphere", "obb"}, kKindWords{"AABB", "circle", "OBB"};

double perimeter_half(const Box2& box) { return (box.max - box.min).sum(); }
double perimeter_half(const Sphere<double, 2>& circle) { return std::numbers::pi * circle.radius; }
double perimeter_half(const Obb<double, 2>& box) { return 2 * box.half_extents.sum(); }

}  // namespace

std::span<const std::string_view> node_kinds() { return kKindNames; }
std::string_view word_of(NodeKind kind) { return kKindWords[static_cast<std::size_t>(kind)]; }

NodeVolume volume_around(NodeKind kind, const Box2& box) {
  const Point2 center = (box.min + box.max) / 2;
  switch (kind) {
    case NodeKind::kAabb: break;
    case NodeKind::kSphere:
      return Sphere<double, 2>{center, std::max((box.max - center).norm(), (box.min - center).norm())};
    case NodeKind::kObb: return Obb<double, 2>{center, Matrix<double, 2>::Identity(), (box.max - box.min) / 2};
  }
  return box;
}

NodeVolume merged(const NodeVolume& a, const NodeVolume& b) {
  return std::visit([&]<class Kind>(const Kind& own) -> NodeVolume { return fit::merge(own, std::get<Kind>(b)); }, a);
}

double half_perimeter_of(const NodeVolume& volume) {
  return std::visit([](const auto& own) { return perimeter_half(own); }, volume);
}

Box2 bounds_of(const NodeVolume& volume) {
  return std::visit([](const auto& own) { return snug::bounds_of(own); }, volume);
}

fit::Volume3 volume_in_space(const NodeVolume& volume) {
  return std::visit([](const auto& own) { return fit::Volume3(fit::lift(own)); }, volume);
}

}  // namespace snug::lesson
