// Any bounding volume, where only the running program knows which.
#pragma once

#include <string_view>
#include <variant>

#include "geometry/aabb.hpp"
#include "geometry/capsule.hpp"
#include "geometry/hull.hpp"
#include "geometry/kdop.hpp"
#include "geometry/lozenge.hpp"
#include "geometry/obb.hpp"
#include "geometry/sphere.hpp"

namespace snug {

template <class Scalar, int Dim>
using Volume = std::variant<Sphere<Scalar, Dim>, Aabb<Scalar, Dim>, Obb<Scalar, Dim>, Capsule<Scalar, Dim>,
                            Lozenge<Scalar, Dim>, Kdop<Scalar, Dim>, ConvexHull<Scalar, Dim>>;

/// The names that the command line and lessons use, in the variant's order.
inline constexpr std::array<std::string_view, 7> kVolumeNames{"sphere",  "aabb", "obb", "capsule",
                                                              "lozenge", "kdop", "hull"};

}  // namespace snug
