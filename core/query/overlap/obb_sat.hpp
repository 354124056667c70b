// The separating-axis test (SAT) of two oriented boxes: they are apart exactly if their projections onto one of 15 axes
// are (in the plane 4): the normals of A's faces, those of B's, and the cross products of an edge of each.
// apart_filter is the test in plain lines. obb_sat, below it, is the same test with its steps; exact arithmetic decides
// what rounding leaves open.
// Source: S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree: A hierarchical structure for rapid interference detection",
// 1996; the axes in the order of table 4.1 in C. Ericson, Real-Time Collision Detection, 2005, 4.4.1.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

#include "geometry/obb.hpp"
#include "geometry/tolerance.hpp"
#include "number/tuple.hpp"
#include "query/overlap/obb_sat_exact.hpp"
#include "query/overlap/sat_steps.hpp"
#include "trace/observer.hpp"

namespace snug::query {

/// Whether two boxes are apart; none where rounding may decide (a floating-point filter). On each axis the distance of
/// the centres stands against the sum of the projected radii. Parallel edges have no axis: if they leave it open, boxes
/// still overlap where they do along all other axes, by twice the error bound (tolerance::kSatParallelDepth has the
/// proof). off: how far both boxes' bounds together may be from the intended ones, along any direction.
template <class Scalar, int Dim>
[[nodiscard, gnu::flatten]] std::optional<bool> apart_filter(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b,
                                                             std::type_identity_t<Scalar> off = 0) {
  const Vector<Scalar, Dim> offset = b.center - a.center;
  const Vector<Scalar, Dim>&e = a.half_extents, &f = b.half_extents;
  const Scalar error_bound = tolerance::kSatGap<Scalar> * (offset.template lpNorm<1>() + e.sum() + f.sum()) + off +
                             std::numeric_limits<Scalar>::min();
  Scalar r[Dim][Dim], s[Dim][Dim], t[Dim];  // B in A's frame: the axes, their sizes, the centre
  Scalar widest = -std::numeric_limits<Scalar>::infinity();
  const auto apart = [&](Scalar gap) {
    widest = std::max(widest, gap);
    return gap > error_bound;
  };
  // The normals of A's faces, and on the way R and t.
  for (int i = 0; i < Dim; ++i) {
    Scalar radii = e[i];
    for (int j = 0; j < Dim; ++j) {
      r[i][j] = a.axes.col(i).dot(b.axes.col(j));
      s[i][j] = std::abs(r[i][j]);
      radii += f[j] * s[i][j];
    }
    t[i] = a.axes.col(i).dot(offset);
    if (apart(std::abs(t[i]) - radii)) return true;
  }
  // The normals of B's faces.
  for (int j = 0; j < Dim; ++j) {
    Scalar distance = 0, radii = f[j];
    for (int i = 0; i < Dim; ++i) {
      distance += t[i] * r[i][j];
      radii += e[i] * s[i][j];
    }
    if (apart(std::abs(distance) - radii)) return true;
  }
  if constexpr (Dim == 2) {
    if (widest < -error_bound) return false;
  } else {
    // Edge i of A times edge j of B: in A's frame a unit vector times a column of R, so each sum has two terms.
    const auto gap_of_edges = [&](int i, int j) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      return std::abs(t[i2] * r[i1][j] - t[i1] * r[i2][j]) -
             (e[i1] * s[i2][j] + e[i2] * s[i1][j] + (f[j1] * s[i][j2] + f[j2] * s[i][j1]));
    };
    const Scalar widest_of_faces = widest;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (apart(gap_of_edges(i, j))) return true;
    if (widest < -error_bound) return false;
    // Parallel edges, whose cross product is near zero, always leave it open. The other axes may decide.
    widest = widest_of_faces;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (s[(i + 1) % 3][j] + s[(i + 2) % 3][j] > tolerance::kParallelAxes<Scalar>)
          widest = std::max(widest, gap_of_edges(i, j));
    if (widest < -tolerance::kSatParallelDepth<Scalar> * error_bound) return false;
  }
  return std::nullopt;
}

inline constexpr std::array<std::string_view, 7> kSatPseudocode2{
    "R, t ← B in A's frame",  //
    "for each face axis of A",
    "  apart if distance > r_A + r_B",  //
    "for each face axis of B",
    "  apart if distance > r_A + r_B",  //
    "decide what rounding left open",
    "overlap if no axis separates",  //
};
inline constexpr std::array<std::string_view, 10> kSatPseudocode3{
    "R, t ← B in A's frame",  //
    "for each face axis of A",
    "  apart if distance > r_A + r_B",  //
    "for each face axis of B",
    "  apart if distance > r_A + r_B",  //
    "for each edge of A × edge of B",
    "  no axis if they are parallel",  //
    "  apart if distance > r_A + r_B",
    "decide what rounding left open",  //
    "overlap if no axis separates",
};

/// The lines of kSatPseudocode2 and 3 that steps name.
template <int Dim>
struct SatLine {
  static constexpr int kFrames = 0, kFaceA = 2, kFaceB = 4, kParallel = 6, kEdges = 7;
  static constexpr int kExactly = Dim == 2 ? 5 : 8, kVerdict = kExactly + 1;
};

/// B in A's frame, and the projections of both boxes onto the axes of Ericson's table 4.1.
template <class Scalar, int Dim>
class ObbFrames {
 public:
  ObbFrames(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b) : a_(a), b_(b), offset_(b.center - a.center) {
    const Scalar size = offset_.template lpNorm<1>() + a.half_extents.sum() + b.half_extents.sum();
    error_bound_ = tolerance::kSatGap<Scalar> * size + std::numeric_limits<Scalar>::min();
  }

  /// Calls visit(place, offset, radius_a, radius_b) for each axis in the table's order until one call returns true, and
  /// returns whether one did. offset: between the centres along the axis; all values are times the axis's length. It is
  /// unrolled, so that every index is a constant.
  template <class Visit>
  [[gnu::always_inline]] bool any_axis(Visit&& visit) {
    return any_axis(std::make_integer_sequence<int, kSatAxes<Dim>>{}, visit);
  }

  /// The error bound of a gap, times the axis's length: a gap larger than this is certain.
  [[nodiscard]] Scalar error_bound() const { return error_bound_; }

  [[nodiscard]] FramesRelated<Scalar, Dim> related() {
    for (int i = 0; i < Dim; ++i) relate(i);
    return {rotation_, translation_, error_bound_};
  }

  /// The axis's length: 1 for a face's normal, for two edges the sine of the angle between them.
  [[nodiscard]] Scalar length(int place) const {
    return axis_at<Dim>(place).kind == AxisKind::kEdgeEdge ? cross(place).norm() : 1;
  }
  [[nodiscard]] bool parallel(int place) const { return length(place) <= tolerance::kParallelAxes<Scalar>; }

  /// gap: the gap times the axis's length.
  [[nodiscard]] SatAxis<Scalar, Dim> axis(int place, Scalar gap) const {
    const auto [kind, i, j] = axis_at<Dim>(place);
    if (parallel(place)) return {kind, i, j};
    const Scalar length = this->length(place);
    Direction direction;
    if (kind == AxisKind::kFaceA) direction = a_.axes.col(i);
    else if (kind == AxisKind::kFaceB) direction = b_.axes.col(j);
    else direction = cross(place) / length;
    if (direction.dot(offset_) < 0) direction = -direction;
    return {kind, i, j, direction, gap / length};
  }

  /// The vertices that reach farthest in a direction, one bit each.
  [[nodiscard]] int corners_of_a(const Vector<Scalar, Dim>& way) const { return corners_towards(a_, way); }
  [[nodiscard]] int corners_of_b(const Vector<Scalar, Dim>& way) const { return corners_towards(b_, way); }

  /// Decides exactly whether one of the axes in doubt separates the boxes, and which. The other axes certainly do not.
  /// If only axes of parallel edges are in doubt, they cannot separate the boxes; but beside others in doubt they are
  /// tested, for their edges may be parallel only within rounding.
  [[nodiscard]] std::optional<SatAxis<Scalar, Dim>> decide_exactly(AxisSet in_doubt) const {
    for (int place = 0; place < kSatAxes<Dim>; ++place)
      if ((in_doubt >> place & 1) != 0 && !parallel(place)) return separating_exactly(a_, b_, in_doubt);
    return std::nullopt;
  }

 private:
  using Direction = Vector<Scalar, Dim>;

  /// The vertices that reach farthest in a direction: if an edge or a face does within rounding, all of its vertices.
  [[nodiscard]] int corners_towards(const Obb<Scalar, Dim>& box, const Direction& way) const {
    int corners = 0;
    for (int bits = 0; bits < 1 << Dim; ++bits) {
      bool farthest = true;
      for (int axis = 0; axis < Dim; ++axis) {
        const Scalar reach = box.axes.col(axis).dot(way) * box.half_extents[axis];
        farthest = farthest && (std::abs(reach) <= error_bound_ || (reach > 0) == ((bits >> axis & 1) != 0));
      }
      if (farthest) corners |= 1 << bits;
    }
    return corners;
  }

  template <int... kPlace, class Visit>
  [[gnu::always_inline]] bool any_axis(std::integer_sequence<int, kPlace...>, Visit& visit) {
    return (at<kPlace>(visit) || ...);
  }

  template <int kPlace, class Visit>
  [[gnu::always_inline]] bool at(Visit& visit) {
    constexpr AxisAt kAxis = axis_at<Dim>(kPlace);
    constexpr int i = kAxis.i, j = kAxis.j;
    if constexpr (kAxis.kind == AxisKind::kFaceA) {
      relate(i);
      return visit(kPlace, translation_[i], a_.half_extents[i], rotation_.row(i).cwiseAbs().dot(b_.half_extents));
    } else if constexpr (kAxis.kind == AxisKind::kFaceB) {
      return visit(kPlace, rotation_.col(j).dot(translation_), rotation_.col(j).cwiseAbs().dot(a_.half_extents),
                   b_.half_extents[j]);
    } else {
      constexpr int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const auto r = [&](int row, int column) { return std::abs(rotation_(row, column)); };
      return visit(kPlace, translation_[i2] * rotation_(i1, j) - translation_[i1] * rotation_(i2, j),
                   a_.half_extents[i1] * r(i2, j) + a_.half_extents[i2] * r(i1, j),
                   b_.half_extents[j1] * r(i, j2) + b_.half_extents[j2] * r(i, j1));
    }
  }

  /// Computes row i of R and t: B along A's axis i. Only when needed, for many boxes are apart along the first axis.
  void relate(int i) {
    rotation_.row(i) = b_.axes.transpose().lazyProduct(a_.axes.col(i));
    translation_[i] = a_.axes.col(i).dot(offset_);
  }

  [[nodiscard]] Direction cross(int place) const {
    if constexpr (Dim == 2) {
      return Direction::Zero();  // there is no such axis
    } else {
      const auto [kind, i, j] = axis_at<Dim>(place);
      return snug::cross<Direction>(a_.axes.col(i), b_.axes.col(j));
    }
  }

  const Obb<Scalar, Dim>& a_;
  const Obb<Scalar, Dim>& b_;
  Direction offset_;
  Scalar error_bound_;
  Matrix<Scalar, Dim> rotation_;
  Direction translation_;
};

/// Whether the test ends at the first axis that separates, or tests all axes to find the widest gap.
enum class SatExtent : std::uint8_t { kFirst, kAll };

/// One test with an observer. An axis counts as separating, or as not separating, only if no rounding can change that.
template <class Scalar, int Dim, class Observer>
class ObbSat {
 public:
  ObbSat(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b, SatExtent extent, Observer& observe)
      : frames_(a, b), extent_(extent), observe_(observe) {}

  SatResult<Scalar, Dim> run() {
    if constexpr (kWatched<Observer>) observe_(Step{Line::kFrames, frames_.related()});
    frames_.any_axis([this](int place, Scalar offset, Scalar radius_a, Scalar radius_b) {
      return judge(place, std::abs(offset), radius_a, radius_b);
    });
    result_.overlap = !apart_;
    if (!apart_ && in_doubt_ != 0) decide_exactly();
    if (extent_ == SatExtent::kAll && result_.overlap) result_.axis.gap = std::min(result_.axis.gap, Scalar(0));
    observe_(Step{line_of_verdict(), Verdict<Scalar, Dim>{result_}});
    return result_;
  }

 private:
  using Step = SatStep<Scalar, Dim>;
  using Line = SatLine<Dim>;

  /// Judges one axis. Returns whether the test ends here.
  bool judge(int place, Scalar distance, Scalar radius_a, Scalar radius_b) {
    const Scalar gap = distance - (radius_a + radius_b);
    ++result_.tests;
    observe_.count(Operation::kDotProducts, dot_products(place));
    observe_.count(Operation::kComparisons, 1);
    if constexpr (kWatched<Observer>) report(place, distance, radius_a, radius_b);
    const bool separates = gap > frames_.error_bound();
    if (!separates && !(gap < -frames_.error_bound())) in_doubt_ |= AxisSet{1} << place;
    if (extent_ == SatExtent::kAll) keep_if_widest(place, gap);
    if (!separates) return false;
    apart_ = true;
    if (extent_ == SatExtent::kFirst) result_.axis = frames_.axis(place, gap);
    return extent_ == SatExtent::kFirst;
  }

  /// A face of A takes a row of R and an entry of t; a face of B the sum of an entry of t in B's frame.
  [[nodiscard]] static int dot_products(int place) {
    if (place < Dim) return Dim + 1;
    return place < 2 * Dim ? 1 : 0;
  }

  /// The line of the pseudocode that the verdict belongs to.
  [[nodiscard]] int line_of_verdict() const {
    if (result_.overlap) return Line::kVerdict;
    if (!apart_) return Line::kExactly;
    if (result_.axis.kind == AxisKind::kFaceA) return Line::kFaceA;
    return result_.axis.kind == AxisKind::kFaceB ? Line::kFaceB : Line::kEdges;
  }

  /// Keeps the axis if its gap is the widest, compared by the part that is certain, small for nearly parallel edges.
  void keep_if_widest(int place, Scalar gap) {
    if (frames_.parallel(place)) return;
    const Scalar certain = (gap - frames_.error_bound()) / frames_.length(place);
    if (result_.axis.kind != AxisKind::kNone && certain <= widest_) return;
    widest_ = certain;
    result_.axis = frames_.axis(place, gap);
  }

  void decide_exactly() {
    const auto separating = frames_.decide_exactly(in_doubt_);
    result_.overlap = !separating;
    if (separating) result_.axis = *separating;
    observe_(Step{Line::kExactly, LookedCloser{std::popcount(in_doubt_), result_.overlap}});
  }

  void report(int place, Scalar distance, Scalar radius_a, Scalar radius_b) {
    const Scalar gap = distance - (radius_a + radius_b);
    AxisTested<Scalar, Dim> fact{.axis = frames_.axis(place, gap), .length = frames_.length(place)};
    fact.skipped = frames_.parallel(place);
    if (!fact.skipped) {
      fact.distance = distance / fact.length;
      fact.radius_a = radius_a / fact.length;
      fact.radius_b = radius_b / fact.length;
      fact.doubt = frames_.error_bound() / fact.length;
      fact.separates = gap > frames_.error_bound();
      fact.near_a = frames_.corners_of_a(fact.axis.direction);
      fact.near_b = frames_.corners_of_b(-fact.axis.direction);
    }
    observe_(Step{line_of(place, fact.skipped), fact});
  }

  [[nodiscard]] static int line_of(int place, bool parallel) {
    if (place < Dim) return Line::kFaceA;
    if (place < 2 * Dim) return Line::kFaceB;
    return parallel ? Line::kParallel : Line::kEdges;
  }

  ObbFrames<Scalar, Dim> frames_;
  SatExtent extent_;
  Observer& observe_;
  AxisSet in_doubt_ = 0;
  bool apart_ = false;
  Scalar widest_ = 0;
  SatResult<Scalar, Dim> result_;
};

/// Whether two oriented boxes share a point; touching boxes do. The verdict is exact on the numbers as they are, where
/// a box is the set of all center + sum s_i h_i u_i with |s_i| <= 1; that includes flat boxes, segments and points. The
/// test of table 4.1 decides as far as its error bound allows, and exact arithmetic decides the rest.
/// a, b: axes unit and perpendicular within tolerance::kObbAxes; coordinates finite, and small enough that their sums
/// are. extent: kFirst ends at the first axis that separates, and overlapping boxes get no axis. kAll tests all: boxes
/// that are apart get the axis of the widest gap, overlapping ones that of the least penetration.
template <class Scalar, int Dim, StepObserver<SatStep<Scalar, Dim>> Observer = Ignore>
SatResult<Scalar, Dim> obb_sat(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b,
                               SatExtent extent = SatExtent::kFirst, Observer&& observe = {}) {
  return ObbSat<Scalar, Dim, std::remove_reference_t<Observer>>(a, b, extent, observe).run();
}

/// The verdict of obb_sat, if nothing else is needed.
template <class Scalar, int Dim>
[[nodiscard]] bool obbs_overlap(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b) {
  if (const auto apart = apart_filter(a, b)) [[likely]]
    return !*apart;
  return obb_sat(a, b).overlap;
}

// Compiled once, in obb_sat.cpp: without an observer, and with every step kept.
template <class Scalar, int Dim>
using SatRecorder = Recorder<SatStep<Scalar, Dim>>;
#define SNUG_OBB_SAT(EXTERN, Scalar, Dim)                                                                              \
  EXTERN template SatResult<Scalar, Dim> obb_sat(const Obb<Scalar, Dim>&, const Obb<Scalar, Dim>&, SatExtent,          \
                                                 Ignore&&);                                                            \
  EXTERN template SatResult<Scalar, Dim> obb_sat<Scalar, Dim, SatRecorder<Scalar, Dim>&>(                              \
      const Obb<Scalar, Dim>&, const Obb<Scalar, Dim>&, SatExtent, SatRecorder<Scalar, Dim>&);
SNUG_OBB_SAT(extern, float, 2)
SNUG_OBB_SAT(extern, float, 3)
SNUG_OBB_SAT(extern, double, 2)
SNUG_OBB_SAT(extern, double, 3)

}  // namespace snug::query
