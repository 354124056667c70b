// Updates an axis-aligned box by rotating it and taking the AABB of the result.
// Source: J. Arvo, "Transforming axis-aligned bounding boxes", Graphics Gems, 1990.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "fit/update/update.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 4> kUpdateRotatedBoxPseudocode{
    "for each axis i of the world",
    "  min ← sum over j of the lesser r(i,j) · end",
    "  max ← likewise the greater; then translate",
    "return box",
};

/// The AABB of the rotated and moved local box, in constant time: no point is examined. Its tightness is between
/// rebuilt and loose; it is tight if the body is not rotated. box: contains the points in the local frame. (With the
/// last frame's world box and the pose since then, the result would contain them too, but would grow from frame to
/// frame.) It contains every placed point: each rounded product and sum here bounds the point's own, because it has the
/// same factors except for one that is farther out.
template <class Scalar, int Dim, StepObserver<UpdateStep<Aabb<Scalar, Dim>>> Observer = Ignore>
[[gnu::flatten]] Updated<Aabb<Scalar, Dim>> update_rotated_box(const Aabb<Scalar, Dim>& box,
                                                               const Pose<Scalar, Dim>& pose, Observer&& observe = {}) {
  using Step = UpdateStep<Aabb<Scalar, Dim>>;
  Aabb<Scalar, Dim> turned;
  for (int i = 0; i < Dim; ++i) {
    Scalar least = 0, greatest = 0;
    for (int j = 0; j < Dim; ++j) {
      const Scalar a = pose.rotation(i, j) * box.min[j], b = pose.rotation(i, j) * box.max[j];
      least = j == 0 ? std::min(a, b) : least + std::min(a, b);
      greatest = j == 0 ? std::max(a, b) : greatest + std::max(a, b);
    }
    turned.min[i] = least + pose.translation[i];
    turned.max[i] = greatest + pose.translation[i];
    if constexpr (kWatched<Observer>)
      observe(Step{2, i + 1 == Dim, turned,
                   BoundsRotated{i, static_cast<double>(turned.min[i]), static_cast<double>(turned.max[i])}});
  }
  observe.count(Operation::kDotProducts, 2 * Dim);
  observe.count(Operation::kComparisons, Dim * Dim);
  if constexpr (kWatched<Observer>) observe(Step{3, true, turned, Finished{}});
  return {turned};
}

}  // namespace snug::fit
