#include "fit/merge/merge.hpp"
#include "fit/merge/merge_order.hpp"
#include "fit/merge/merge_swept.hpp"
#include "fit/obb/obb_frame.hpp"

namespace snug::fit {
namespace {

/// Fits a lozenge with given axes around balls, in the frame of these axes.
template <int Dim>
class LozengeAround {
 public:
  LozengeAround(const Balls<Dim>& balls, const Matrix<double, Dim>& axes) : axes_(axes) {
    for (const BallIn<Dim>& ball : balls) local_.push_back({axes.transpose() * ball.center, ball.radius});
    choose_thin_axis();
    for (std::size_t edge = 0; edge < 2; ++edge) pull_in(edge);
    for (const BallIn<Dim>& ball : local_) take_corner(ball);
  }

  [[nodiscard]] Lozenge<double, Dim> lozenge() const {
    Vector<double, Dim> corner = Vector<double, Dim>::Zero();
    std::array<Vector<double, Dim>, 2> edges;
    for (std::size_t edge = 0; edge < 2; ++edge) {
      corner += axes_.col(edge_axes_[edge]) * low_[edge];
      edges[edge] = axes_.col(edge_axes_[edge]) * (high_[edge] - low_[edge]);
    }
    if constexpr (Dim == 3) corner += axes_.col(thin_) * height_;
    return {corner, edges, radius_};
  }

 private:
  /// In space, chooses the axis along which the balls are thinnest; half of their extent is the radius. In the plane
  /// there is no such axis, and the largest of the radii is kept.
  void choose_thin_axis() {
    for (const auto& ball : local_) radius_ = std::max(radius_, ball.radius);
    if constexpr (Dim == 2) return;
    double thinnest = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < Dim; ++axis) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const auto& ball : local_) {
        low = std::min(low, ball.center[axis] - ball.radius);
        high = std::max(high, ball.center[axis] + ball.radius);
      }
      if (high - low < thinnest) {
        thinnest = high - low;
        thin_ = axis;
        height_ = low + thinnest / 2;
      }
    }
    radius_ = std::max(radius_, thinnest / 2);
    edge_axes_ = {(thin_ + 1) % 3, (thin_ + 2) % 3};
  }

  /// How far beyond the rectangle's side, along the rectangle, the ball's centre may lie.
  [[nodiscard]] double reach(const BallIn<Dim>& ball) const {
    const double left = radius_ - ball.radius;
    if constexpr (Dim == 2) return left;
    const double height = ball.center[thin_] - height_;
    return std::sqrt(std::max(left * left - height * height, 0.0));
  }

  void pull_in(std::size_t edge) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto& ball : local_) {
      low = std::min(low, ball.center[edge_axes_[edge]] + reach(ball));
      high = std::max(high, ball.center[edge_axes_[edge]] - reach(ball));
    }
    if (low > high) low = high = (low + high) / 2;
    low_[edge] = low;
    high_[edge] = high;
  }

  /// If the ball is within reach of two sides but not of the vertex between them, lengthens the first edge until it is.
  void take_corner(const BallIn<Dim>& ball) {
    const double x = ball.center[edge_axes_[0]], y = ball.center[edge_axes_[1]], most = reach(ball);
    const double past_y = std::max({low_[1] - y, y - high_[1], 0.0});
    const double left = std::sqrt(std::max(most * most - past_y * past_y, 0.0));
    low_[0] = std::min(low_[0], x + left);
    high_[0] = std::max(high_[0], x - left);
  }

  Matrix<double, Dim> axes_;
  Balls<Dim> local_;
  std::array<int, 2> edge_axes_{0, 1};
  int thin_ = 2;
  double height_ = 0, radius_ = 0;
  std::array<double, 2> low_{}, high_{};
};

template <int Dim>
Matrix<double, Dim> frame_along(const Vector<double, Dim>& first, const Vector<double, Dim>& second) {
  if constexpr (Dim == 2) return frame(first.isZero(0) ? Vector<double, 2>(second[1], -second[0]) : first);
  else return frame(first, second);
}

/// The centre, within rounding.
template <class Scalar, int Dim>
Vector<double, Dim> middle_of(const Lozenge<Scalar, Dim>& lozenge) {
  return lozenge.origin.template cast<double>() + (lozenge.edges[0] / 2 + lozenge.edges[1] / 2).template cast<double>();
}

template <class Scalar, int Dim>
std::vector<Matrix<double, Dim>> frames(const Lozenge<Scalar, Dim>& a, const Lozenge<Scalar, Dim>& b) {
  std::vector<Matrix<double, Dim>> all;
  for (const auto* lozenge : {&a, &b})
    all.push_back(
        frame_along<Dim>(lozenge->edges[0].template cast<double>(), lozenge->edges[1].template cast<double>()));
  const bool first_is_longer = scaled_norm<Scalar, Dim>(a.edges[0]) >= scaled_norm<Scalar, Dim>(a.edges[1]);
  all.push_back(
      frame_along<Dim>(middle_of(b) - middle_of(a), a.edges[first_is_longer ? 0 : 1].template cast<double>()));
  return all;
}

}  // namespace

template <class Scalar, int Dim>
Lozenge<Scalar, Dim> merge(const Lozenge<Scalar, Dim>& a, const Lozenge<Scalar, Dim>& b) {
  const int order = order_of(a, b);
  if (order == 0) return a;
  if (order > 0) return merge(b, a);
  Balls<Dim> balls = balls_of(a);
  const Balls<Dim> of_b = balls_of(b);
  if (holds(a, of_b)) return a;
  if (holds(b, balls)) return b;
  balls.insert(balls.end(), of_b.begin(), of_b.end());

  const LocalBalls<Dim> local(balls);
  using Local = Lozenge<double, Dim>;
  const Local chosen = least_of<Local>(frames(a, b), [&](const Matrix<double, Dim>& axes) {
                         return std::optional<Local>(LozengeAround<Dim>(local.balls, axes).lozenge());
                       }).value_or(Local{});
  Lozenge<Scalar, Dim> merged{local.to_scene(chosen.origin).template cast<Scalar>()};
  for (const std::size_t edge : {0u, 1u})
    merged.edges[edge] = (chosen.edges[edge] / local.scale).template cast<Scalar>();
  widen_to_hold(merged, balls);
  return merged;
}

template Lozenge<float, 2> merge(const Lozenge<float, 2>&, const Lozenge<float, 2>&);
template Lozenge<float, 3> merge(const Lozenge<float, 3>&, const Lozenge<float, 3>&);
template Lozenge<double, 2> merge(const Lozenge<double, 2>&, const Lozenge<double, 2>&);
template Lozenge<double, 3> merge(const Lozenge<double, 3>&, const Lozenge<double, 3>&);

}  // namespace snug::fit
