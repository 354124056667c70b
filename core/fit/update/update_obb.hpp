// Source: C. Ericson, "Real-Time Collision Detection", 2005, 4.4.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "fit/update/update.hpp"
#include "fit/update/update_sphere.hpp"
#include "geometry/obb.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 4> kUpdateObbPseudocode{
    "center ← transformed center",
    "axes ← rotation · axes, normalized",
    "half extents unchanged, but for rounding",
    "return box",
};

/// Rotates and moves the box with the body: it stays as tight as it was, at the cost of one matrix product. The axes
/// are made unit and perpendicular again each time, so that even a box updated from its own last state stays a box.
/// box: contains the points in the local frame; its axes are unit and perpendicular within rounding.
///
/// It contains every placed point: with d from the centre to a point and a an axis, the rotated d projects onto the new
/// axis a' as d . (R^T a'), which is d . a plus at most |d| |R^T a' - a|. The last factor is known within 7u, d is no
/// longer than the box's half diagonal, and placing_error bounds the rounding of the point.
template <class Scalar, int Dim, StepObserver<UpdateStep<Obb<Scalar, Dim>>> Observer = Ignore>
Updated<Obb<Scalar, Dim>> update_obb(const Obb<Scalar, Dim>& box, const Pose<Scalar, Dim>& pose,
                                     Observer&& observe = {}) {
  using Step = UpdateStep<Obb<Scalar, Dim>>;
  Obb<Scalar, Dim> moved{placed(pose, box.center), box.axes, box.half_extents};
  observe(Step{0, false, moved, CenterMoved{}});

  for (int i = 0; i < Dim; ++i) moved.axes.col(i) = turned<Scalar, Dim>(pose.rotation, box.axes.col(i));
  moved.axes = orthonormal<Scalar, Dim>(moved.axes);
  Vector<Scalar, Dim> off;
  for (int i = 0; i < Dim; ++i)
    off[i] = (turned_back<Scalar, Dim>(pose.rotation, moved.axes.col(i)) - box.axes.col(i)).norm();
  observe(Step{1, false, moved, AxesTurned{static_cast<double>(off.maxCoeff())}});

  const Scalar diagonal = scaled_norm<Scalar, Dim>(box.half_extents);
  const Scalar error = placing_error(diagonal, box.center, pose);
  moved.half_extents += diagonal * off + Vector<Scalar, Dim>::Constant(error);
  observe.count(Operation::kDotProducts, Dim + 2 * Dim * Dim + 2 * Dim * (Dim - 1) / 2);
  observe.count(Operation::kSquareRoots, 2 * Dim);
  observe(Step{2, true, moved, CenterMoved{static_cast<double>((moved.half_extents - box.half_extents).maxCoeff())}});
  observe(Step{3, true, moved, Finished{}});
  return {moved};
}

}  // namespace snug::fit
