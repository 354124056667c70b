// A capsule along the longest principal axis of the points.
// Source: D. Eberly, "3D Game Engine Design", 2000, for the axis and the caps. The line goes through the centre of the
// smallest circle instead of the mean: B. Gärtner, "Fast and robust smallest enclosing balls", 1999.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "fit/obb/principal_frame.hpp"
#include "fit/sphere/pivot.hpp"
#include "fit/swept/capsule_steps.hpp"
#include "fit/swept/swept_radius.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 7> kCapsulePcaPseudocode{
    "m ← mean of the points",
    "C ← covariance about m",
    "v ← eigenvector of largest eigenvalue",
    "line ← along v, centred on the projections",
    "pull each end in until its cap touches",
    "radius ← to the farthest point, exactly",
    "return capsule",
};

/// The smallest circle (2-D: interval) of the points' projection along their last coordinate.
template <class Scalar, int Dim>
struct SeenAlong {
  Vector<Scalar, Dim> center = Vector<Scalar, Dim>::Zero();  // its last coordinate 0
  Scalar radius = 0;
  std::vector<Index> support;
};

template <class Scalar, class Observer>
[[nodiscard]] SeenAlong<Scalar, 3> seen_along(const std::vector<Vector<Scalar, 3>>& local, const Options& options,
                                              Observer& observe) {
  std::vector<Vector<Scalar, 2>> flat;
  flat.reserve(local.size());
  for (const auto& q : local) flat.push_back(q.template head<2>());
  const auto set = *PointSet<Scalar, 2>::make(std::move(flat));  // of unit size, so never refused
  const auto circle = [&] {
    if constexpr (!kWatched<Observer>) return pivot(set.span(), options);
    Counter counter;  // its steps belong to another algorithm
    auto fit = pivot(set.span(), options, counter);
    for (int i = 0; i < kOperations; ++i) observe.count(static_cast<Operation>(i), counter.counts[i]);
    return fit;
  }();
  return {{circle.volume.center[0], circle.volume.center[1], 0}, circle.volume.radius, circle.support.list()};
}

template <class Scalar, class Observer>
[[nodiscard]] SeenAlong<Scalar, 2> seen_along(const std::vector<Vector<Scalar, 2>>& local, const Options&,
                                              Observer& observe) {
  const auto ends =
      std::minmax_element(local.begin(), local.end(), [](const auto& p, const auto& q) { return p[0] < q[0]; });
  observe.count(Operation::kComparisons, 2 * static_cast<std::int64_t>(local.size()));
  const Scalar least = (*ends.first)[0], greatest = (*ends.second)[0];
  return {{(least + greatest) / 2, 0},
          (greatest - least) / 2,
          {static_cast<Index>(ends.first - local.begin()), static_cast<Index>(ends.second - local.begin())}};
}

/// The segment's ends along the line: with caps beyond the farthest points, and with the caps pulled in.
template <class Scalar>
struct CapsuleEnds {
  std::array<Scalar, 2> far, near;
  std::array<Index, 2> touching{0, 0};
};

/// The segment must reach to within sqrt(radius^2 - d^2) of each point, where d is the point's distance from the line.
template <class Scalar, int Dim, class Observer>
[[nodiscard]] CapsuleEnds<Scalar> capsule_ends(const std::vector<Vector<Scalar, Dim>>& local,
                                               const SeenAlong<Scalar, Dim>& circle, Observer& observe) {
  CapsuleEnds<Scalar> ends;
  for (std::size_t i = 0; i < local.size(); ++i) {
    const Scalar along = local[i][Dim - 1];
    const Vector<Scalar, Dim> across = local[i] - circle.center;
    const Scalar square = circle.radius * circle.radius - across.template head<Dim - 1>().squaredNorm();
    const Scalar reach = std::sqrt(std::max(square, Scalar{0}));
    if (i == 0) {
      ends.far = {along, along};
      ends.near = {along + reach, along - reach};
    }
    ends.far = {std::min(ends.far[0], along), std::max(ends.far[1], along)};
    if (along + reach < ends.near[0]) {
      ends.near[0] = along + reach;
      ends.touching[0] = static_cast<Index>(i);
    }
    if (along - reach > ends.near[1]) {
      ends.near[1] = along - reach;
      ends.touching[1] = static_cast<Index>(i);
    }
  }
  // A point that supports the circle has no reach, so the ends are in order but for rounding.
  if (ends.near[0] > ends.near[1]) ends.near[0] = ends.near[1] = (ends.near[0] + ends.near[1]) / 2;
  observe.count(Operation::kPointsTouched, static_cast<std::int64_t>(local.size()));
  observe.count(Operation::kSquareRoots, static_cast<std::int64_t>(local.size()));
  return ends;
}

/// The capsule along the direction of greatest spread: as thin as that direction allows, with its caps pulled in as far
/// as the points allow. points: n >= 1 finite points, scene units. Expected O(n) time and memory.
template <class Scalar, int Dim, StepObserver<CapsuleStep<Scalar, Dim>> Observer = Ignore>
Fit<Capsule<Scalar, Dim>> capsule_pca(PointSpan<Scalar, Dim> points, const Options& options, Observer&& observe = {}) {
  using Step = CapsuleStep<Scalar, Dim>;
  const auto frame = principal_frame<Step>(points, observe);
  const SeenAlong<Scalar, Dim> circle = seen_along(frame.local, options, observe);
  const CapsuleEnds<Scalar> ends = capsule_ends(frame.local, circle, observe);
  const auto on_line = [&](Scalar along) -> Vector<Scalar, Dim> {
    Vector<Scalar, Dim> local = circle.center;
    local[Dim - 1] = along;
    return frame.origin + frame.to_scene(local);
  };
  Capsule<Scalar, Dim> capsule{on_line(ends.far[0]), on_line(ends.far[1]), circle.radius / frame.scale};
  observe(Step{3, true, capsule, LineFound{circle.support, static_cast<double>(capsule.radius)}});
  for (int end = 0; end < 2; ++end) {
    const std::size_t e = end;
    (end == 0 ? capsule.a : capsule.b) = on_line(ends.near[e]);
    const double by = std::abs(static_cast<double>(ends.near[e]) - static_cast<double>(ends.far[e]));
    observe(Step{4, true, capsule, EndPulledIn{end, ends.touching[e], by / static_cast<double>(frame.scale)}});
  }
  const SweptRadius radius = hold_all(capsule, points);
  observe.count(Operation::kPointsTouched, points.size());
  observe.count(Operation::kDistanceTests, points.size());
  observe(Step{5, true, capsule, RadiusChecked{radius.farthest, radius.widened}});

  std::vector<Index> support = circle.support;
  support.insert(support.end(), ends.touching.begin(), ends.touching.end());
  std::sort(support.begin(), support.end());
  support.erase(std::unique(support.begin(), support.end()), support.end());
  observe(Step{6, true, capsule, Finished{support}});
  return {capsule, std::move(support)};
}

}  // namespace snug::fit
