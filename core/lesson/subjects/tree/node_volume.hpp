// What a tree's nodes may have around what is below them: boxes along the axes, circles, or oriented boxes.
#pragma once

#include <string_view>
#include <variant>

#include "fit/any_step.hpp"
#include "geometry/obb.hpp"
#include "geometry/sphere.hpp"
#include "lesson/subjects/tree/tree_stage.hpp"

namespace snug::lesson {

/// In the order of NodeKind.
using NodeVolume = std::variant<Box2, Sphere<double, 2>, Obb<double, 2>>;

/// The names of the kinds in a lesson's file: aabb, sphere, obb.
[[nodiscard]] std::span<const std::string_view> node_kinds();
/// "AABB", "circle", "OBB".
[[nodiscard]] std::string_view word_of(NodeKind kind);

/// The smallest one around a box.
[[nodiscard]] NodeVolume volume_around(NodeKind kind, const Box2& box);
/// Around two of a kind, as a tree's builder merges them.
[[nodiscard]] NodeVolume merged(const NodeVolume& a, const NodeVolume& b);
/// Half of its perimeter, to which the probability that a random line meets a convex volume is proportional.
[[nodiscard]] double half_perimeter_of(const NodeVolume& volume);
/// The box along the axes around it.
[[nodiscard]] Box2 bounds_of(const NodeVolume& volume);
/// The same in 3-D, where it is drawn and checked.
[[nodiscard]] fit::Volume3 volume_in_space(const NodeVolume& volume);

}  // namespace snug::lesson
