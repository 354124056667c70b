#include "measure/naive_welzl.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

#include "fit/sphere/support_ball.hpp"
#include "geometry/tolerance.hpp"

namespace snug::cost {
namespace {

class NaiveWelzl {
 public:
  explicit NaiveWelzl(PointSpan<double, 3> points) : points_(points) {}

  RecursionDepth run() {
    (void)ball_of(points_.size(), {}, 0);
    return {deepest_, static_cast<double>(highest_ - lowest_) / std::max<Index>(deepest_, 1)};
  }

 private:
  using Ball = std::optional<Sphere<double, 3>>;

  /// The sphere of the first n points, with the support on its boundary.
  __attribute__((noinline)) Ball ball_of(Index n, const fit::Support& support, Index depth) {
    see(depth);
    if (n == 0 || support.size() == 4) {
      if (support.size() == 0) return std::nullopt;
      const auto ball = fit::ball_through(points_, support);
      if (!ball) return std::nullopt;
      return Sphere<double, 3>{ball->center, ball->radius};
    }
    const Ball ball = ball_of(n - 1, support, depth + 1);
    const auto& last = points_[n - 1];
    const double limit = ball ? ball->radius * ball->radius * (1 + tolerance::kSquaredDistance<double>) : -1;
    if (ball && (last - ball->center).squaredNorm() <= limit) return ball;
    fit::Support with = support;
    with.add(n - 1);
    return ball_of(n - 1, with, depth + 1);
  }

  /// Records how deep the stack is at a call, by the address of a local variable.
  __attribute__((noinline)) void see(Index depth) {
    volatile char here = 0;
    const auto place = reinterpret_cast<std::uintptr_t>(&here);
    lowest_ = std::min(lowest_, place);
    highest_ = std::max(highest_, place);
    deepest_ = std::max(deepest_, depth);
  }

  PointSpan<double, 3> points_;
  Index deepest_ = 0;
  std::uintptr_t lowest_ = std::numeric_limits<std::uintptr_t>::max(), highest_ = 0;
};

}  // namespace

RecursionDepth naive_welzl_depth(PointSpan<double, 3> points) { return NaiveWelzl(points).run(); }

}  // namespace snug::cost
