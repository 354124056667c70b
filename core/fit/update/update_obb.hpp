// Updates an oriented box with its body: its centre and its axes turn along.
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

/// The part of local_error that an oriented box needs: see update_obb.
template <class Scalar, int Dim>
[[nodiscard]] Scalar local_error(const Obb<Scalar, Dim>& box) {
  const Scalar diagonal = scaled_norm<Scalar, Dim>(box.half_extents);
  return local_error(diagonal, box.center) + tolerance::kTurnedBox<Scalar> * diagonal;
}

/// The vector at unit length, within 4u. v: of a length within 1000u of 1, where the root needs its first term alone.
template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> nearly_unit_to_unit(const Vector<Scalar, Dim>& v) {
  return v * ((3 - v.squaredNorm()) / 2);
}

/// A right-handed box's axes, rotated and then made unit and perpendicular again within tolerance::kObbAxes: by
/// Gram-Schmidt, and the last by the other two.
template <class Scalar>
[[nodiscard]] Matrix<Scalar, 3> turned_axes(const Matrix<Scalar, 3>& rotation, const Matrix<Scalar, 3>& axes) {
  const auto image = [&](int i) { return turned<Scalar, 3>(rotation, axes.col(i)); };
  const Vector<Scalar, 3> u = nearly_unit_to_unit<Scalar, 3>(image(0)), v = image(1);
  const Vector<Scalar, 3> w = nearly_unit_to_unit<Scalar, 3>(v - v.dot(u) * u);
  Matrix<Scalar, 3> result;
  result << u[0], w[0], u[1] * w[2] - u[2] * w[1],  //
      u[1], w[1], u[2] * w[0] - u[0] * w[2],        //
      u[2], w[2], u[0] * w[1] - u[1] * w[0];
  return result;
}
template <class Scalar>
[[nodiscard]] Matrix<Scalar, 2> turned_axes(const Matrix<Scalar, 2>& rotation, const Matrix<Scalar, 2>& axes) {
  const Vector<Scalar, 2> u = nearly_unit_to_unit<Scalar, 2>(turned<Scalar, 2>(rotation, axes.col(0)));
  Matrix<Scalar, 2> result;
  result << u[0], -u[1], u[1], u[0];
  return result;
}

/// The greatest distance of an axis, as seen from the body, from what it was.
template <class Scalar, int Dim>
[[nodiscard]] double most_off(const Obb<Scalar, Dim>& box, const Pose<Scalar, Dim>& pose,
                              const Obb<Scalar, Dim>& moved) {
  double off = 0;
  for (int i = 0; i < Dim; ++i) {
    const Vector<Scalar, Dim> back = turned_back<Scalar, Dim>(pose.rotation, moved.axes.col(i));
    off = std::max(off, static_cast<double>((back - box.axes.col(i)).norm()));
  }
  return off;
}

/// Rotates and moves the box with the body: it stays as tight as it was, at the cost of one matrix product. The axes
/// are made unit and perpendicular again each time, so that even a box updated from its own last state stays a box.
/// box: contains the points in the local frame; its axes are unit, perpendicular and right-handed within rounding.
/// local: its local_error.
///
/// It contains every placed point: with d from the centre to a point and a an axis, the rotated d projects onto the new
/// axis a' as d . (R^T a'), which is d . a plus at most |d| |R^T a' - a|. The last factor is kTurnedBox at most, d is
/// no longer than the box's half diagonal, and placing_error bounds the rounding of the point.
template <class Scalar, int Dim, StepObserver<UpdateStep<Obb<Scalar, Dim>>> Observer = Ignore>
[[gnu::flatten]] Updated<Obb<Scalar, Dim>> update_obb(const Obb<Scalar, Dim>& box, Scalar local,
                                                      const Pose<Scalar, Dim>& pose, Observer&& observe = {}) {
  using Step = UpdateStep<Obb<Scalar, Dim>>;
  Obb<Scalar, Dim> moved{placed(pose, box.center), box.axes, box.half_extents};
  if constexpr (kWatched<Observer>) observe(Step{0, false, moved, CenterMoved{}});

  moved.axes = turned_axes<Scalar>(pose.rotation, box.axes);
  if constexpr (kWatched<Observer>) observe(Step{1, false, moved, AxesTurned{most_off(box, pose, moved)}});

  const Scalar error = placing_error(local, pose);
  moved.half_extents += Vector<Scalar, Dim>::Constant(error);
  observe.count(Operation::kDotProducts, Dim + (Dim == 2 ? 3 : 12));
  if constexpr (kWatched<Observer>) {
    observe(Step{2, true, moved, CenterMoved{static_cast<double>(error)}});
    observe(Step{3, true, moved, Finished{}});
  }
  return {moved};
}

}  // namespace snug::fit
