// Source: J. Arvo, "Transforming axis-aligned bounding boxes", Graphics Gems, 1990.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "fit/update/update.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 4> kUpdateRotatedBoxPseudocode{
    "for each axis i of the world",
    "  sum r(i,j) · the lesser end of box j",
    "  likewise the greater ends; then translate",
    "return box",
};

/// The box of the turned and moved box, without looking at a point: constant time. Between rebuilt and loose; tight
/// when the body is a box, or upright. box: the local one, which holds the points in the local frame. (With the world's
/// box of the last frame and the pose since then it holds them too, but then grows from frame to frame.) It holds every
/// point as placed: each rounded product and sum here is at least, or at most, the same one of the point, for it is of
/// the same numbers but one that is farther out.
template <class Scalar, int Dim, StepObserver<UpdateStep<Aabb<Scalar, Dim>>> Observer = Ignore>
Updated<Aabb<Scalar, Dim>> update_rotated_box(const Aabb<Scalar, Dim>& box, const Pose<Scalar, Dim>& pose,
                                              Observer&& observe = {}) {
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
    observe(Step{2, i + 1 == Dim, turned,
                 BoundsRotated{i, static_cast<double>(turned.min[i]), static_cast<double>(turned.max[i])}});
  }
  observe.count(Operation::kDotProducts, 2 * Dim);
  observe.count(Operation::kComparisons, Dim * Dim);
  observe(Step{3, true, turned, Finished{}});
  return {turned};
}

}  // namespace snug::fit
