// Updates a sphere with its body: only its centre moves.
// Source: C. Ericson, "Real-Time Collision Detection", 2005, 4.3.
#pragma once

#include <array>
#include <limits>
#include <string_view>

#include "fit/update/update.hpp"
#include "geometry/sphere.hpp"
#include "geometry/tolerance.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 3> kUpdateSpherePseudocode{
    "center ← transformed center",
    "radius unchanged, but for rounding",
    "return sphere",
};

/// How much rounding may move two placed points apart, but for the translation's part: it does not depend on the pose,
/// so a body works it out once. size: that of a volume that contains both; center: its centre, in the local frame. See
/// tolerance::kPlaced.
template <class Scalar, int Dim>
[[nodiscard]] Scalar local_error(Scalar size, const Vector<Scalar, Dim>& center) {
  return tolerance::kPlaced<Scalar> * (size + scaled_norm<Scalar, Dim>(center)) +
         16 * std::numeric_limits<Scalar>::denorm_min();
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar local_error(const Sphere<Scalar, Dim>& ball) {
  return local_error(ball.radius, ball.center);
}

/// The same with the translation's part: the sum of its coordinates is at least its length.
template <class Scalar, int Dim>
[[nodiscard]] Scalar placing_error(Scalar local_error, const Pose<Scalar, Dim>& pose) {
  return local_error + tolerance::kPlaced<Scalar> * pose.translation.template lpNorm<1>();
}

/// Moves the ball with its centre: no rotation makes it looser. The radius is widened by as much as rounding may move a
/// placed point away from the placed centre, a few u of the farthest coordinate.
/// ball: contains the points in the local frame. local: its local_error. Its few operations are inlined: a call for
/// each would cost more than they do.
template <class Scalar, int Dim, StepObserver<UpdateStep<Sphere<Scalar, Dim>>> Observer = Ignore>
[[gnu::flatten]] Updated<Sphere<Scalar, Dim>> update_sphere(const Sphere<Scalar, Dim>& ball, Scalar local,
                                                            const Pose<Scalar, Dim>& pose, Observer&& observe = {}) {
  using Step = UpdateStep<Sphere<Scalar, Dim>>;
  const Scalar error = placing_error(local, pose);
  const Sphere<Scalar, Dim> moved{placed(pose, ball.center), ball.radius + error};
  observe.count(Operation::kDotProducts, Dim);
  if constexpr (kWatched<Observer>) {
    observe(Step{1, true, moved, CenterMoved{static_cast<double>(error)}});
    observe(Step{2, true, moved, Finished{}});
  }
  return {moved};
}

}  // namespace snug::fit
