// An oriented box along the axis that the bounding sphere suggests.
// Source: I. D. Romanick, "Data Structures & Algorithms for Geometry", 2007: the bounding sphere gives an estimate of
// the longest axis. Here the circle around the points' projection along that axis gives the second in the same way.
#pragma once

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "fit/obb/obb_frame.hpp"
#include "fit/obb/obb_from_axes.hpp"
#include "fit/obb/obb_trials.hpp"
#include "fit/sphere/pivot.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 6> kObbSphereAxisPseudocode{
    "sphere ← smallest around the points",  //
    "u ← along the farthest two of its support",
    "circle ← smallest, projected along u",
    "v ← along the farthest two of its support",
    "extents ← along u, v and across both",
    "return box",
};

/// The smallest ball around points, and the two points of its support set that are farthest apart.
template <int Dim>
struct LongestChord {
  Fit<Sphere<double, Dim>> ball;
  PairChosen pair;
  Vector<double, Dim> chord;

  /// points: n >= 1, of coordinates of about 1. count: Ignore or PartCounter.
  template <class Count>
  LongestChord(std::vector<Vector<double, Dim>> points, Count& count) {
    const auto set = *PointSet<double, Dim>::make(std::move(points));  // finite and small: nothing is refused
    ball = pivot(set.span(), Options{}, count);
    count.count(Operation::kDistanceTests, ball.support.size() * (ball.support.size() - 1) / 2);
    pair = {ball.support[0], ball.support[0], kNoIndex, 0};
    for (const Index a : ball.support)
      for (const Index b : ball.support) {
        const double distance = (set[b] - set[a]).norm();
        if (a < b && distance > pair.distance) pair = {a, b, kNoIndex, distance};
      }
    chord = set[pair.b] - set[pair.a];
  }
};

/// The box whose first axis runs through the smallest ball's two farthest support points, and the second through those
/// of the projection's smallest circle. points: n >= 1 finite points, scene units. Expected O(n) time, O(n) memory.
template <class Scalar, int Dim, StepObserver<ObbStep<Scalar, Dim>> Observer = Ignore>
Fit<Obb<Scalar, Dim>> obb_sphere_axis(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  using Step = ObbStep<Scalar, Dim>;
  const LocalPoints<Dim> local(points);
  const double scale = std::ldexp(1.0, local.exponent);
  const auto tell = [&](int line, const Vector<double, Dim>& center, const auto& found) {
    const Sphere<Scalar, Dim> ball{(local.first + scale * center).template cast<Scalar>(),
                                   static_cast<Scalar>(scale * found.ball.volume.radius)};
    observe(Step{line, false, {}, BallFound<Scalar, Dim>{ball, found.ball.support.list()}});
    observe(Step{line + 1, false, {}, PairChosen{found.pair.a, found.pair.b, kNoIndex, scale * found.pair.distance}});
  };

  PartCounterFor<Observer> tally;
  const LongestChord<Dim> first(local.at, tally);
  hand_on(tally, observe);
  const Vector<double, Dim> center = first.ball.volume.center;
  tell(0, center, first);
  Matrix<double, Dim> axes;
  if constexpr (Dim == 2) {
    axes = frame(first.chord);
  } else {
    axes = frame(first.chord, Vector<double, 3>::Zero());
    const Vector<double, 3> u = axes.col(0), x = axes.col(1), y = axes.col(2);
    std::vector<Vector<double, 2>> cast;
    for (const auto& p : local.at) cast.emplace_back(x.dot(p), y.dot(p));
    PartCounterFor<Observer> spent;
    spent.count(Operation::kPointsTouched, points.size());
    spent.count(Operation::kDotProducts, 2 * std::int64_t{points.size()});
    const LongestChord<2> second(std::move(cast), spent);
    hand_on(spent, observe);
    const Vector<double, 2> middle = second.ball.volume.center;
    tell(2, u * u.dot(center) + x * middle[0] + y * middle[1], second);
    axes = frame(first.chord, x * second.chord[0] + y * second.chord[1]);
  }
  return finish_on_axes<Scalar, Dim>(axes.template cast<Scalar>(), points, 4, observe);
}

}  // namespace snug::fit
