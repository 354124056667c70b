// Source: S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree: A hierarchical structure for rapid interference detection", 1996;
// the table of axes as in C. Ericson, Real-Time Collision Detection, 2005, 4.4.1.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "geometry/obb.hpp"
#include "geometry/tolerance.hpp"
#include "query/obb_sat_exact.hpp"
#include "query/sat_steps.hpp"
#include "trace/observer.hpp"

namespace snug::query {

inline constexpr std::array<std::string_view, 7> kSatPseudocode2{
    "R, t ← B as seen from A's frame",
    "for each face axis of A",
    "  apart if distance > r_A + r_B",
    "for each face axis of B",
    "  apart if distance > r_A + r_B",
    "what rounding hides: exactly",
    "no axis separates: overlap",
};
inline constexpr std::array<std::string_view, 10> kSatPseudocode3{
    "R, t ← B as seen from A's frame",
    "for each face axis of A",
    "  apart if distance > r_A + r_B",
    "for each face axis of B",
    "  apart if distance > r_A + r_B",
    "for each edge of A × edge of B",
    "  no axis if they are parallel",
    "  apart if distance > r_A + r_B",
    "what rounding hides: exactly",
    "no axis separates: overlap",
};

/// The lines of kSatPseudocode2 and 3 that steps name.
template <int Dim>
struct SatLine {
  static constexpr int kFrames = 0, kFaceA = 2, kFaceB = 4, kParallel = 6, kEdges = 7;
  static constexpr int kExactly = Dim == 2 ? 5 : 8, kVerdict = kExactly + 1;
};

/// Whether the test ends at the first axis that separates, or goes on to find the axis of the widest gap.
enum class SatExtent : std::uint8_t { kFirst, kAll };

/// The state of one test. An axis counts as separating, or as not, only where no rounding can change that; what is left
/// open is decided by obb_sat_exact.hpp.
template <class Scalar, int Dim, SatExtent kExtent, class Observer>
class ObbSat {
 public:
  ObbSat(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b, Observer& observe) : a_(a), b_(b), observe_(observe) {}

  SatResult<Scalar, Dim> run() {
    offset_ = b_.center - a_.center;
    const Scalar size = offset_.template lpNorm<1>() + a_.half_extents.sum() + b_.half_extents.sum();
    doubt_ = tolerance::kSatGap<Scalar> * size + std::numeric_limits<Scalar>::min();
    if constexpr (kWatched<Observer>) {
      for (int i = 0; i < Dim; ++i) relate(i);
      observe_(Step{Line::kFrames, FramesRelated<Scalar, Dim>{rotation_, translation_, doubt_}});
    }
    if (!test_each(std::make_integer_sequence<int, kSatAxes<Dim>>{})) {
      result_.tests = kSatAxes<Dim>;
      if (!apart_ && open_ != 0) settle_exactly();
      result_.overlap = !apart_;
    }
    if (kExtent == SatExtent::kAll && !apart_) result_.axis.gap = std::min(result_.axis.gap, Scalar(0));
    observe_(Step{Line::kVerdict, Verdict<Scalar, Dim>{result_}});
    return result_;
  }

 private:
  using Step = SatStep<Scalar, Dim>;
  using Line = SatLine<Dim>;
  using Direction = Vector<Scalar, Dim>;

  /// The axes in their order, unrolled, so that every index is a constant. Whether one of them
  /// ended the test.
  template <int... kAxis>
  bool test_each(std::integer_sequence<int, kAxis...>) {
    return (ends_at<kAxis>() || ...);
  }

  template <int kAxis>
  bool ends_at() {
    if constexpr (kAxis < Dim)
      return face_of_a<kAxis>();
    else if constexpr (kAxis < 2 * Dim)
      return face_of_b<kAxis - Dim>();
    else
      return edges<(kAxis - 2 * Dim) / Dim, (kAxis - 2 * Dim) % Dim>();
  }

  /// Row i of R and t, how B lies along A's axis i; as it is needed, for many boxes are apart along the first.
  void relate(int i) {
    for (int j = 0; j < Dim; ++j) rotation_(i, j) = a_.axes.col(i).dot(b_.axes.col(j));
    translation_[i] = a_.axes.col(i).dot(offset_);
  }

  template <int i>
  bool face_of_a() {
    relate(i);
    observe_.count(Operation::kDotProducts, Dim + 1);
    return judge({AxisKind::kFaceA, i, -1}, translation_[i], a_.half_extents[i],
                 rotation_.row(i).cwiseAbs().dot(b_.half_extents));
  }

  template <int j>
  bool face_of_b() {
    observe_.count(Operation::kDotProducts, 1);
    return judge({AxisKind::kFaceB, -1, j}, rotation_.col(j).dot(translation_),
                 rotation_.col(j).cwiseAbs().dot(a_.half_extents), b_.half_extents[j]);
  }

  template <int i, int j>
  bool edges() {
    constexpr int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    const auto r = [&](int row, int column) { return std::abs(rotation_(row, column)); };
    return judge({AxisKind::kEdgeEdge, i, j}, translation_[i2] * rotation_(i1, j) - translation_[i1] * rotation_(i2, j),
                 a_.half_extents[i1] * r(i2, j) + a_.half_extents[i2] * r(i1, j),
                 b_.half_extents[j1] * r(i, j2) + b_.half_extents[j2] * r(i, j1));
  }

  struct Axis {
    AxisKind kind;
    int i, j;
  };

  /// The offset of the centres and the radii, all times the axis's length. Whether the test ends here.
  bool judge(Axis axis, Scalar offset, Scalar radius_a, Scalar radius_b) {
    const Scalar gap = std::abs(offset) - (radius_a + radius_b);
    observe_.count(Operation::kComparisons, 1);
    if constexpr (kWatched<Observer>) report(axis, std::abs(offset), radius_a, radius_b);
    if (kExtent == SatExtent::kFirst && gap < -doubt_) return false;
    return consider(axis, gap);
  }

  // Out of the way of the many axes that do not separate, so that their test stays short.
  [[gnu::noinline]] bool consider(Axis axis, Scalar gap) {
    if (gap > doubt_) {
      apart_ = true;
    } else if (!(gap < -doubt_)) {
      if (parallel(axis)) {
        parallel_ |= bit(axis);
        return false;
      }
      open_ |= bit(axis);
    }
    if (kExtent == SatExtent::kAll) {
      keep_if_widest(axis, gap);
      return false;
    }
    if (apart_) result_ = {false, bit_place(axis) + 1, sat_axis(axis, gap)};
    return apart_;
  }

  [[nodiscard]] static int bit_place(Axis axis) { return axis_place<Dim>(axis.kind, axis.i, axis.j); }
  [[nodiscard]] static AxisSet bit(Axis axis) { return AxisSet{1} << bit_place(axis); }

  /// The sine of the angle between two edges; of a face's normal 1.
  [[nodiscard]] Scalar length(Axis axis) const {
    if (axis.kind != AxisKind::kEdgeEdge) return 1;
    const Scalar x = rotation_((axis.i + 1) % Dim, axis.j), y = rotation_((axis.i + 2) % Dim, axis.j);
    return std::sqrt(x * x + y * y);
  }
  [[nodiscard]] bool parallel(Axis axis) const { return length(axis) <= tolerance::kParallelAxes<Scalar>; }

  [[nodiscard]] Direction direction(Axis axis) const {
    Direction along = axis.kind == AxisKind::kFaceA ? a_.axes.col(axis.i) : b_.axes.col(axis.j);
    if constexpr (Dim == 3)
      if (axis.kind == AxisKind::kEdgeEdge) {
        const Direction u = a_.axes.col(axis.i), v = b_.axes.col(axis.j);
        along = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
        along /= along.norm();
      }
    return along.dot(offset_) < 0 ? Direction(-along) : along;
  }

  [[nodiscard]] SatAxis<Scalar, Dim> sat_axis(Axis axis, Scalar gap) const {
    return {axis.kind, axis.i, axis.j, direction(axis), gap / length(axis)};
  }

  /// By the gap that is certain: of the axis of nearly parallel edges little is.
  void keep_if_widest(Axis axis, Scalar gap) {
    const Scalar certain = (gap - doubt_) / length(axis);
    if (result_.axis.kind != AxisKind::kNone && certain <= widest_) return;
    widest_ = certain;
    result_.axis = sat_axis(axis, gap);
  }

  /// The other axes were found not to separate, by more than the axes of parallel edges, left out, could change. Where one
  /// is open, they too must be looked at: they may be parallel within rounding only.
  void settle_exactly() {
    const AxisSet axes = open_ | parallel_;
    const auto separating = separating_exactly(a_, b_, axes);
    apart_ = separating.has_value();
    if (separating) result_.axis = *separating;
    observe_(Step{Line::kExactly, LookedCloser{std::popcount(axes), !apart_}});
  }

  void report(Axis axis, Scalar distance, Scalar radius_a, Scalar radius_b) {
    AxisTested<Scalar, Dim> fact{.kind = axis.kind, .i = axis.i, .j = axis.j, .length = length(axis)};
    fact.skipped = parallel(axis);
    if (!fact.skipped) {
      const Scalar gap = distance - (radius_a + radius_b);
      fact.direction = direction(axis);
      fact.distance = distance / fact.length;
      fact.radius_a = radius_a / fact.length;
      fact.radius_b = radius_b / fact.length;
      fact.gap = gap / fact.length;
      fact.doubt = doubt_ / fact.length;
      fact.separates = gap > doubt_;
    }
    constexpr std::array<int, 4> kLines{Line::kVerdict, Line::kFaceA, Line::kFaceB, Line::kEdges};
    observe_(Step{fact.skipped ? Line::kParallel : kLines[static_cast<std::size_t>(axis.kind)], fact});
  }

  const Obb<Scalar, Dim>& a_;
  const Obb<Scalar, Dim>& b_;
  Observer& observe_;
  Direction offset_;
  Scalar doubt_ = 0;
  Matrix<Scalar, Dim> rotation_;
  Direction translation_;
  AxisSet open_ = 0, parallel_ = 0;
  bool apart_ = false;
  Scalar widest_ = 0;
  SatResult<Scalar, Dim> result_;
};

/// Whether two oriented boxes share a point; touching boxes do. The verdict is exact on the numbers as they are, a box
/// being all center + sum s_i h_i u_i with |s_i| <= 1, flat boxes, segments and points too: the lecture's test decides
/// where its own error bound allows, exact arithmetic the rest.
/// a, b: axes unit and perpendicular within tolerance::kObbAxes; sizes below half of the largest Scalar.
/// Ends at the first axis that separates; overlapping boxes get no axis.
template <class Scalar, int Dim, StepObserver<SatStep<Scalar, Dim>> Observer = Ignore>
SatResult<Scalar, Dim> obb_sat(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b, Observer&& observe = {}) {
  return ObbSat<Scalar, Dim, SatExtent::kFirst, std::remove_reference_t<Observer>>(a, b, observe).run();
}

/// The same through all of the axes: boxes that are apart get the axis of the widest gap, overlapping ones that of the
/// least penetration.
template <class Scalar, int Dim, StepObserver<SatStep<Scalar, Dim>> Observer = Ignore>
SatResult<Scalar, Dim> obb_sat_all_axes(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b, Observer&& observe = {}) {
  return ObbSat<Scalar, Dim, SatExtent::kAll, std::remove_reference_t<Observer>>(a, b, observe).run();
}

}  // namespace snug::query
