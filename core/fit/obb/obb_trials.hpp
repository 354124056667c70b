// Compares boxes on candidate axes, and keeps the best so far.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "fit/counters.hpp"
#include "fit/obb/obb_frame.hpp"
#include "fit/obb/obb_steps.hpp"
#include "geometry/tolerance.hpp"
#include "number/power_of_two.hpp"
#include "trace/observer.hpp"

namespace snug::fit {

/// Points as doubles relative to the first, scaled by a power of two to a largest coordinate of about 1, so that no
/// product of a few coordinates over- or underflows. A point is first + 2^exponent * at.
template <int Dim>
struct LocalPoints {
  Vector<double, Dim> first;
  int exponent = 0;
  std::vector<Vector<double, Dim>> at;
  double size = 0;  // the largest distance from the first, at that scale

  /// points: a range of one Vector<Scalar, Dim> or more.
  template <class Points>
  explicit LocalPoints(const Points& points) : first(points.begin()->template cast<double>()) {
    double largest = 0;
    for (const auto& p : points) {
      at.push_back(p.template cast<double>() - first);
      largest = std::max(largest, at.back().cwiseAbs().maxCoeff());
    }
    exponent = exponent_of(largest);
    for (auto& p : at) {
      for (int i = 0; i < Dim; ++i) p[i] = std::ldexp(p[i], -exponent);
      size = std::max(size, p.norm());
    }
  }
};

/// The least and greatest projections of local points onto axes.
template <int Dim>
struct LocalBox {
  Matrix<double, Dim> axes;
  Vector<double, Dim> least, greatest;

  LocalBox(const Matrix<double, Dim>& columns, const std::vector<Vector<double, Dim>>& points) : axes(columns) {
    const Matrix<double, Dim> turn = axes.transpose();
    least = greatest = turn * points[0];
    for (const auto& p : points) {
      const Vector<double, Dim> along = turn * p;
      for (int i = 0; i < Dim; ++i) {
        least[i] = std::min(least[i], along[i]);
        greatest[i] = std::max(greatest[i], along[i]);
      }
    }
  }
};

/// Counts what a LocalBox of so many points costs.
template <int Dim, class Observer>
void count_box(std::size_t points, Observer& observe) {
  const auto n = static_cast<std::int64_t>(points);
  observe.count(Operation::kPointsTouched, n);
  observe.count(Operation::kDotProducts, Dim * n);
  observe.count(Operation::kComparisons, 2 * Dim * n);
}

/// The axes, right-handed, in order of rising length of the box.
template <int Dim>
[[nodiscard]] Matrix<double, Dim> by_length(const LocalBox<Dim>& box) {
  std::array<int, Dim> order{};
  std::iota(order.begin(), order.end(), 0);
  const Vector<double, Dim> lengths = box.greatest - box.least;
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return lengths[a] < lengths[b]; });
  Matrix<double, Dim> axes;
  for (int i = 0; i < Dim; ++i) axes.col(i) = box.axes.col(order[i]);
  return right_handed<double, Dim>(axes);
}

/// The measure by which boxes are compared: the product of the lengths, each at least floor. So flat boxes are compared
/// by their area, and not by the rounding error of their thickness.
template <int Dim>
[[nodiscard]] double padded_measure(const Vector<double, Dim>& lengths, double floor) {
  return lengths.cwiseMax(floor).prod();
}

/// The best of the boxes tried around a few points.
template <class Scalar, int Dim, class Observer>
class ObbTrials {
 public:
  using Step = ObbStep<Scalar, Dim>;
  using Tried = BoxTried<Scalar, Dim>;

  /// points: a range of one Vector<Scalar, Dim> or more, which the boxes are to contain.
  template <class Points>
  ObbTrials(const Points& points, Observer& observe)
      : local_(points), floor_(tolerance::kFlatBox * local_.size), observe_(observe) {}

  /// Tries the box on these axes, and reports it. on: the points that determined the axes, anything that a vector of
  /// Index can be made of. Returns whether it is the best so far.
  template <class Indices>
  bool attempt(const Matrix<double, Dim>& axes, const Indices& on, int line) {
    return attempt_and_tell(axes, [&](const Obb<Scalar, Dim>& box, bool better) {
      observe_(Step{line, has_best_, best_box_, Tried{{on.begin(), on.end()}, box, measure(box), better}});
    });
  }

  /// The same, but the caller reports it: tell(box, better).
  template <class Tell>
  bool attempt_and_tell(const Matrix<double, Dim>& axes, Tell&& tell) {
    const LocalBox<Dim> box(axes, local_.at);
    count_box<Dim>(local_.at.size(), observe_);
    observe_.count(Operation::kComparisons, 1);
    const double size = padded_measure<Dim>(box.greatest - box.least, floor_);
    const bool better = size < least_;
    if (better) {
      axes_ = axes;
      least_ = size;
      has_best_ = true;
    }
    if constexpr (kWatched<Observer>) {
      const Obb<Scalar, Dim> placed = place(box);
      if (better) best_box_ = placed;
      tell(placed, better);
    }
    return better;
  }

  /// The box on these axes in scene units, which is neither compared nor counted: for steps.
  [[nodiscard]] Obb<Scalar, Dim> box_on(const Matrix<double, Dim>& axes) const {
    return place(LocalBox<Dim>(axes, local_.at));
  }

  [[nodiscard]] const Matrix<double, Dim>& axes() const { return axes_; }
  [[nodiscard]] Matrix<Scalar, Dim> scalar_axes() const { return axes_.template cast<Scalar>(); }
  [[nodiscard]] const Obb<Scalar, Dim>& box() const { return best_box_; }  // for steps: kept only if they are observed
  [[nodiscard]] double least() const { return least_; }                    // padded_measure, local
  [[nodiscard]] double floor() const { return floor_; }
  [[nodiscard]] const LocalPoints<Dim>& local() const { return local_; }

 private:
  /// The box in scene units, for display only; the result comes from obb_from_axes.
  [[nodiscard]] Obb<Scalar, Dim> place(const LocalBox<Dim>& box) const {
    const double scale = std::ldexp(1.0, local_.exponent);
    const Vector<double, Dim> middle = box.axes * Vector<double, Dim>((box.least + box.greatest) / 2);
    return {(local_.first + scale * middle).template cast<Scalar>(), box.axes.template cast<Scalar>(),
            (scale / 2 * (box.greatest - box.least)).template cast<Scalar>()};
  }

  LocalPoints<Dim> local_;
  double floor_;
  Observer& observe_;
  Matrix<double, Dim> axes_ = Matrix<double, Dim>::Identity();
  double least_ = std::numeric_limits<double>::infinity();
  bool has_best_ = false;
  Obb<Scalar, Dim> best_box_;
};

}  // namespace snug::fit
