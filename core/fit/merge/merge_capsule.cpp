#include "fit/merge/merge.hpp"
#include "fit/merge/merge_order.hpp"
#include "fit/merge/merge_swept.hpp"
#include "fit/obb/obb_frame.hpp"

namespace snug::fit {
namespace {

/// A ball around the balls' projections along a direction; with more than two balls, not always the smallest.
template <int Dim>
Sphere<double, 2> seen_from(const Balls<Dim>& balls, const Matrix<double, Dim>& axes) {
  std::vector<Sphere<double, 2>> circles;
  for (const BallIn<Dim>& ball : balls) {
    Sphere<double, 2>& circle = circles.emplace_back();
    circle.radius = ball.radius;
    for (int i = 1; i < Dim; ++i) circle.center[i - 1] = axes.col(i).dot(ball.center);
  }
  Sphere<double, 2> around = circles[0];
  for (std::size_t i = 0; i < circles.size(); ++i)
    for (std::size_t j = i + 1; j < circles.size(); ++j) {
      const Sphere<double, 2> pair = merge(circles[i], circles[j]);
      if (pair.radius > around.radius) around = pair;
    }
  for (const auto& circle : circles) around = merge(around, circle);
  return around;
}

/// The capsule around the line along the frame's first axis. The segment must reach to within sqrt((R - r)^2 - d^2) of
/// a ball's centre, where r is that ball's radius and d its centre's distance from the line.
template <int Dim>
Capsule<double, Dim> along_line(const Balls<Dim>& balls, const Matrix<double, Dim>& axes) {
  const Sphere<double, 2> around = seen_from<Dim>(balls, axes);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const BallIn<Dim>& ball : balls) {
    const double along = axes.col(0).dot(ball.center), left = around.radius - ball.radius;
    double square = left * left;
    for (int i = 1; i < Dim; ++i) {
      const double across = axes.col(i).dot(ball.center) - around.center[i - 1];
      square -= across * across;
    }
    const double reach = std::sqrt(std::max(square, 0.0));
    low = std::min(low, along + reach);
    high = std::max(high, along - reach);
  }
  if (low > high) low = high = (low + high) / 2;
  Vector<double, Dim> foot = Vector<double, Dim>::Zero();
  for (int i = 1; i < Dim; ++i) foot += axes.col(i) * around.center[i - 1];
  return {foot + axes.col(0) * low, foot + axes.col(0) * high, around.radius};
}

template <int Dim>
Matrix<double, Dim> frame_along(const Vector<double, Dim>& direction) {
  if constexpr (Dim == 2) return frame(direction);
  else return frame(direction, Vector<double, 3>::Zero());
}

/// balls: two from a, then two from b.
template <int Dim>
std::vector<Vector<double, Dim>> directions(const Balls<Dim>& balls) {
  const auto between = [&](std::size_t i, std::size_t j) -> Vector<double, Dim> {
    return balls[j].center - balls[i].center;
  };
  std::vector<Vector<double, Dim>> all{between(0, 1), between(2, 3), (between(0, 2) + between(1, 3)) / 2};
  Vector<double, Dim> farthest = between(0, 2);
  for (const std::size_t i : {0u, 1u})
    for (const std::size_t j : {2u, 3u})
      if (between(i, j).squaredNorm() > farthest.squaredNorm()) farthest = between(i, j);
  all.push_back(farthest);
  return all;
}

}  // namespace

template <class Scalar, int Dim>
Capsule<Scalar, Dim> merge(const Capsule<Scalar, Dim>& a, const Capsule<Scalar, Dim>& b) {
  const int order = order_of(a, b);
  if (order == 0) return a;
  if (order > 0) return merge(b, a);
  Balls<Dim> balls = balls_of(a);
  const Balls<Dim> of_b = balls_of(b);
  if (holds(a, of_b)) return a;
  if (holds(b, balls)) return b;
  balls.insert(balls.end(), of_b.begin(), of_b.end());

  const LocalBalls<Dim> local(balls);
  using Local = Capsule<double, Dim>;
  const auto least = least_of<Local>(directions<Dim>(local.balls), [&](const Vector<double, Dim>& direction) {
    return direction.isZero(0) ? std::nullopt
                               : std::optional<Local>(along_line<Dim>(local.balls, frame_along<Dim>(direction)));
  });
  // If no direction is left, all centres coincide, and the larger ball contains the others.
  const Local chosen = least.value_or(Local{});
  Capsule<Scalar, Dim> merged{local.to_scene(chosen.a).template cast<Scalar>(),
                              local.to_scene(chosen.b).template cast<Scalar>()};
  widen_to_hold(merged, balls);
  return merged;
}

template Capsule<float, 2> merge(const Capsule<float, 2>&, const Capsule<float, 2>&);
template Capsule<float, 3> merge(const Capsule<float, 3>&, const Capsule<float, 3>&);
template Capsule<double, 2> merge(const Capsule<double, 2>&, const Capsule<double, 2>&);
template Capsule<double, 3> merge(const Capsule<double, 3>&, const Capsule<double, 3>&);

}  // namespace snug::fit
