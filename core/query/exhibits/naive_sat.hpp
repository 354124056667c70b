// The separating-axis test as textbooks print it, kept to show where it breaks: it trusts the sign of a rounded gap, or
// shifts it by an epsilon. Snug's own test is obb_sat.hpp; nothing rests on this one.
// Source: C. Ericson, Real-Time Collision Detection, 2005, 4.4.1, for the table and for the epsilon on R.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

#include "geometry/obb.hpp"
#include "query/overlap/obb_sat_exact.hpp"
#include "query/overlap/sat_steps.hpp"
#include "trace/observer.hpp"

namespace snug::query {

/// What keeps rounding from calling overlapping boxes apart.
enum class Guard : std::uint8_t {
  kNone,      // nothing
  kOnR,       // an epsilon is added to every |R_ij|, which has no unit
  kAbsolute,  // a gap counts only if it is wider than an epsilon in scene units
  kRelative,  // the same, of an epsilon times the size of the boxes
};

/// Ericson's epsilon, and for kAbsolute the same number of units.
inline constexpr double kNaiveEpsilon = 1e-6;
/// The epsilon of kRelative, in parts of the sizes: an entry of R is off by 8u, and a row is a sum of six products with
/// them.
template <class Scalar>
inline constexpr Scalar kRelativeEpsilon = 32 * std::numeric_limits<Scalar>::epsilon();

inline constexpr std::array<std::string_view, 4> kNaivePseudocode{
    "R, t ← B in A's frame",
    "for each of the 15 axes L",
    "  apart if distance > r_A + r_B",
    "overlap if no axis separates",
};
inline constexpr std::array<std::string_view, 4> kNaiveOnRPseudocode{
    "R, t ← B in A's frame; |R| ← |R| + 0.000001",
    "for each of the 15 axes L",
    "  apart if distance > r_A + r_B",
    "overlap if no axis separates",
};
inline constexpr std::array<std::string_view, 4> kNaiveAbsolutePseudocode{
    "R, t ← B in A's frame; ε ← 0.000001 units",
    "for each of the 15 axes L",
    "  apart if distance > r_A + r_B + ε",
    "overlap if no axis separates",
};
inline constexpr std::array<std::string_view, 4> kNaiveRelativePseudocode{
    "R, t ← B in A's frame; ε ← 32 ulps of both boxes' size",
    "for each of the 15 axes L",
    "  apart if distance > r_A + r_B + ε",
    "overlap if no axis separates",
};
inline constexpr std::array<std::string_view, 4> kFacesOnlyPseudocode{
    "R, t ← B in A's frame",
    "for each of the 6 face axes L",
    "  apart if distance > r_A + r_B",
    "overlap (wrong if only an edge axis separates)",
};

/// One such test with an observer. axes: how many rows of the table it tests, from the first on.
template <class Scalar, class Observer>
class NaiveSat {
 public:
  using Box = Obb<Scalar, 3>;

  NaiveSat(const Box& a, const Box& b, Guard guard, int axes, Observer& observe)
      : a_(a), b_(b), axes_(axes), observe_(observe), rotation_(a.axes.transpose() * b.axes),
        translation_(a.axes.transpose() * (b.center - a.center)), sizes_(rotation_.cwiseAbs()) {
    const Scalar size = (b.center - a.center).template lpNorm<1>() + a.half_extents.sum() + b.half_extents.sum();
    if (guard == Guard::kOnR) sizes_.array() += static_cast<Scalar>(kNaiveEpsilon);
    if (guard == Guard::kAbsolute) epsilon_ = static_cast<Scalar>(kNaiveEpsilon);
    if (guard == Guard::kRelative) epsilon_ = kRelativeEpsilon<Scalar> * size;
  }

  bool run() {
    observe_(Step{0, FramesRelated<Scalar, 3>{rotation_, translation_, epsilon_}});
    SatResult<Scalar, 3> result{.overlap = true};
    for (int place = 0; place < axes_ && result.overlap; ++place) {
      const AxisTested<Scalar, 3> row = tested(place);
      ++result.tests;
      if (row.separates) {
        result.overlap = false;
        result.axis = row.axis;
      }
      observe_(Step{2, row});
    }
    observe_(Step{result.overlap ? 3 : 2, Verdict<Scalar, 3>{result}});
    return result.overlap;
  }

 private:
  using Step = SatStep<Scalar, 3>;
  using Direction = Vector<Scalar, 3>;

  /// The three terms of a row, times the length of its axis, as the table has them.
  struct Row {
    Scalar distance, radius_a, radius_b;
    Direction axis;  // in the world, not unit
  };

  [[nodiscard]] Row row(int place) const {
    const auto [kind, i, j] = axis_at<3>(place);
    const Direction &a = a_.half_extents, &b = b_.half_extents, &t = translation_;
    if (kind == AxisKind::kFaceA) return {std::abs(t[i]), a[i], sizes_.row(i).dot(b), a_.axes.col(i)};
    if (kind == AxisKind::kFaceB)
      return {std::abs(rotation_.col(j).dot(t)), sizes_.col(j).dot(a), b[j], b_.axes.col(j)};
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    return {std::abs(t[i2] * rotation_(i1, j) - t[i1] * rotation_(i2, j)),
            a[i1] * sizes_(i2, j) + a[i2] * sizes_(i1, j), b[j1] * sizes_(i, j2) + b[j2] * sizes_(i, j1),
            a_.axes.col(i1) * rotation_(i2, j) * Scalar(-1) + a_.axes.col(i2) * rotation_(i1, j)};
  }

  /// The row as it is shown: divided by the axis's length. Where that is 0 there is no axis, and no gap either.
  [[nodiscard]] AxisTested<Scalar, 3> tested(int place) const {
    const auto [kind, i, j] = axis_at<3>(place);
    const Row own = row(place);
    const Scalar gap = own.distance - (own.radius_a + own.radius_b);
    const Scalar length = kind == AxisKind::kEdgeEdge ? own.axis.norm() : Scalar(1);
    AxisTested<Scalar, 3> fact{.axis = {kind, i, j}, .length = length};
    fact.separates = gap > epsilon_;
    fact.skipped = length == 0 && !fact.separates;
    if (length == 0) return fact;
    const Direction towards_b = own.axis.dot(b_.center - a_.center) < 0 ? Direction(-own.axis) : own.axis;
    fact.axis.direction = towards_b / length;
    fact.axis.gap = gap / length;
    fact.distance = own.distance / length;
    fact.radius_a = own.radius_a / length;
    fact.radius_b = own.radius_b / length;
    fact.doubt = epsilon_ / length;
    fact.near_a = corners_towards(a_, fact.axis.direction);
    fact.near_b = corners_towards(b_, -fact.axis.direction);
    return fact;
  }

  /// The vertices that reach farthest, one bit each; no rounding is made allowance for.
  [[nodiscard]] static int corners_towards(const Box& box, const Direction& way) {
    int farthest = 0;
    for (int bits = 0; bits < 8; ++bits) {
      bool is = true;
      for (int axis = 0; axis < 3; ++axis) {
        const Scalar reach = box.axes.col(axis).dot(way);
        is = is && (reach == 0 || (reach > 0) == ((bits >> axis & 1) != 0));
      }
      if (is) farthest |= 1 << bits;
    }
    return farthest;
  }

  const Box& a_;
  const Box& b_;
  int axes_;
  Observer& observe_;
  Matrix<Scalar, 3> rotation_;
  Direction translation_;
  Matrix<Scalar, 3> sizes_;  // |R|, perhaps with an epsilon
  Scalar epsilon_ = 0;
};

/// Whether such a test says that the boxes overlap, right or wrong. a, b: as for obb_sat.
template <class Scalar, class Observer = Ignore>
bool naive_sat(const Obb<Scalar, 3>& a, const Obb<Scalar, 3>& b, Guard guard, Observer&& observe = {}) {
  return NaiveSat<Scalar, std::remove_reference_t<Observer>>(a, b, guard, kSatAxes<3>, observe).run();
}

/// The same with the face axes alone: it never calls overlapping boxes apart but for rounding, and it misses every gap
/// that only the cross product of two edges shows.
template <class Scalar, class Observer = Ignore>
bool faces_only(const Obb<Scalar, 3>& a, const Obb<Scalar, 3>& b, Observer&& observe = {}) {
  return NaiveSat<Scalar, std::remove_reference_t<Observer>>(a, b, Guard::kNone, 6, observe).run();
}

}  // namespace snug::query
