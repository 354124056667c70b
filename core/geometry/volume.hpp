// Any bounding volume, whose kind is known only at run time.
//
// A kind of volume is its own header, which gives:
//   SNUG_FIELDS        its numbers by name: lifting, casting, JSON, lesson files, bytes and hashes follow
//   measure            its area or volume
//   anchor             a point of it around which coordinates are taken, so that far volumes lose no digits
//   contains           whether it contains a point, in exact arithmetic on its numbers as they are
//   moved              by a vector; and turned, where its kind can turn: about its middle
// and how far it reaches in any direction, in one of two ways:
//   core_corners       the corners of its core relative to an origin, in scene units: a sphere's centre, a capsule's
//                      segment, a lozenge's rectangle, else all of it. None where the volume is empty (a hull without
//                      vertices, a k-DOP whose slabs do not meet). The volume is its core's convex hull grown by
//   core_radius        where it has one
//   core_support       or, where the volume is smooth, its point farthest along a direction (of a size near 1)
//                      relative to an origin, in scene units: no other lies farther by more than 16 roundings of the
//                      volume's extent about that origin
// Every pair's test (query/overlap/overlaps.hpp), culling (query/cull/classify.hpp), the distance of a point
// (query/contain/contains.hpp), trees (hierarchy/bounds.hpp) and the drawing (app/volumes.cpp) follow from that. Kinds
// that have something faster, or something that says more, have overloads of their own there. A header may also give
//   core_span          how far its core reaches on both sides of a plane, in rounded and in exact numbers, with
//   magnitude_of       the size that rounding is relative to; without them, culling calls intersecting what it leaves
//                      open
//   bounds_of          (in geometry/bounds.hpp) the axis-aligned box around it
// Source of core and radius: G. van den Bergen, "A fast and robust GJK implementation for collision detection of convex
// objects", 1999.
#pragma once

#include <string_view>
#include <variant>

#include "geometry/aabb.hpp"
#include "geometry/capsule.hpp"
#include "geometry/hull.hpp"
#include "geometry/kdop.hpp"
#include "geometry/lozenge.hpp"
#include "geometry/obb.hpp"
#include "geometry/pose.hpp"
#include "geometry/sphere.hpp"

namespace snug {

template <class Scalar, int Dim>
using Volume = std::variant<Sphere<Scalar, Dim>, Aabb<Scalar, Dim>, Obb<Scalar, Dim>, Capsule<Scalar, Dim>,
                            Lozenge<Scalar, Dim>, Kdop<Scalar, Dim>, ConvexHull<Scalar, Dim>>;

/// The names that the command line and lessons use, in the variant's order.
inline constexpr std::array<std::string_view, std::variant_size_v<Volume<double, 3>>> kVolumeNames{
    "sphere", "aabb", "obb", "capsule", "lozenge", "kdop", "hull"};
static_assert(!kVolumeNames.back().empty());

/// Turned about its middle, as far as its kind can turn, and then moved.
template <template <class, int> class Kind, class Scalar, int Dim>
[[nodiscard]] Kind<Scalar, Dim> placed(const Kind<Scalar, Dim>& volume, const Pose<Scalar, Dim>& pose) {
  if constexpr (requires { turned(volume, pose.rotation); })
    return moved(turned(volume, pose.rotation), pose.translation);
  else return moved(volume, pose.translation);
}

/// An empty volume of a kind, in double and 3-D. name: of kVolumeNames.
template <std::size_t at = 0>
[[nodiscard]] Volume<double, 3> volume_of_kind(std::string_view name) {
  if constexpr (at + 1 < kVolumeNames.size())
    if (name != kVolumeNames[at]) return volume_of_kind<at + 1>(name);
  return Volume<double, 3>(std::in_place_index<at>);
}

/// Expands a macro of (..., kind) for each kind of volume: where templates are instantiated.
#define SNUG_EACH_VOLUME(ONE, ...)                                                                                     \
  ONE(__VA_ARGS__, Sphere)                                                                                             \
  ONE(__VA_ARGS__, Aabb)                                                                                               \
  ONE(__VA_ARGS__, Obb)                                                                                                \
  ONE(__VA_ARGS__, Capsule)                                                                                            \
  ONE(__VA_ARGS__, Lozenge)                                                                                            \
  ONE(__VA_ARGS__, Kdop)                                                                                               \
  ONE(__VA_ARGS__, ConvexHull)

}  // namespace snug
