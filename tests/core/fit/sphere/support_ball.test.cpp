// The ball of a few points beside all of their subsets' balls.
#include "fit/sphere/support_ball.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/point_clouds.hpp"
#include "geometry/random.hpp"

namespace snug::fit {
namespace {

/// The largest ball of all subsets with the first point whose centre is in their hull.
template <int Dim>
double largest_of_subsets(PointSpan<double, Dim> points) {
  double largest = 0;
  for (unsigned subset = 0; subset < 1u << static_cast<unsigned>(points.size() - 1); ++subset) {
    Support support{0};
    for (Index i = 1; i < points.size(); ++i)
      if ((subset >> static_cast<unsigned>(i - 1) & 1u) != 0 && support.size() <= Dim + 1) support.add(i);
    if (support.size() > Dim + 1) continue;
    const auto ball = ball_through(points, support);
    if (ball && ball->center_in_hull()) largest = std::max(largest, ball->radius);
  }
  return largest;
}

/// Anywhere, on a small lattice (cospherical, collinear, the same), or near one sphere.
template <int Dim>
Vector<double, Dim> any_point(Random& random, int kind) {
  Vector<double, Dim> p;
  for (int i = 0; i < Dim; ++i) p[i] = kind == 1 ? static_cast<double>(random.below(3)) : random.unit() - 0.5;
  return kind == 2 ? Vector<double, Dim>(p.normalized() * (1 + 1e-12 * random.unit())) : p;
}

template <int Dim>
void check_all_supports() {
  Random random(5);
  for (int round = 0; round < 6000; ++round) {
    test::Cloud<double, Dim> points;
    const int size = 2 + static_cast<int>(random.below(Dim + 1));
    for (int i = 0; i < size; ++i) points.push_back(any_point<Dim>(random, round % 3));
    const auto set = test::set_of<double, Dim>(points);
    Support others;
    for (Index i = 1; i < size; ++i) others.add(i);
    const auto ball = smallest_ball_with(set.span(), 0, others);
    CHECK(ball.center_in_hull());
    CHECK(ball.support.contains(0));
    REQUIRE(ball.radius == doctest::Approx(largest_of_subsets(set.span())).epsilon(1e-14));
  }
}

}  // namespace

TEST_CASE("the first sure ball of a few points is the largest of all subsets'") {
  check_all_supports<2>();
  check_all_supports<3>();
}

}  // namespace snug::fit
