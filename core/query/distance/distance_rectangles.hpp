// The distance between two rectangles in space, each expressed in the other's frame.
// Source: E. Larsen, S. Gottschalk, M. Lin, D. Manocha, "Fast proximity queries with swept sphere volumes", 1999, for
// the pairs of edges; only those matter that belong to sides beyond which the other rectangle reaches.
#pragma once

#include "query/distance/distance.hpp"

namespace snug::query {

/// One rectangle (the other) in the frame of a second (own), which is centred at the origin in the plane z = 0.
template <class Scalar>
struct RectangleSeen {
  std::array<Scalar, 2> own, other;  // half extents
  Matrix<Scalar, 3> axes;            // the other's
  Vector<Scalar, 3> center;          // the other's

  /// How far the other reaches from its centre along axis i of the own frame.
  [[nodiscard]] Scalar reach(int i) const { return other[0] * std::abs(axes(i, 0)) + other[1] * std::abs(axes(i, 1)); }

  /// The gaps between both along the three axes of the own frame, 0 where they overlap.
  [[nodiscard]] Vector<Scalar, 3> gaps() const {
    Vector<Scalar, 3> gap;
    for (int i = 0; i < 3; ++i) gap[i] = std::max(Scalar(0), std::abs(center[i]) - reach(i) - (i < 2 ? own[i] : 0));
    return gap;
  }

  /// The point of the other at those coordinates along its axes.
  [[nodiscard]] Vector<Scalar, 3> at(Scalar s, Scalar t) const { return center + s * axes.col(0) + t * axes.col(1); }

  /// The point of the own rectangle nearest to p.
  [[nodiscard]] Vector<Scalar, 3> nearest(const Vector<Scalar, 3>& p) const {
    return {std::clamp(p[0], -own[0], own[0]), std::clamp(p[1], -own[1], own[1]), 0};
  }
};

/// Two rectangles, each expressed in the other's frame.
template <class Scalar>
class RectanglePair {
 public:
  RectanglePair(const Rectangle<Scalar>& a, const Rectangle<Scalar>& b) : a_(a), b_(b) {
    const Vector<Scalar, 3> between = b.center - a.center;
    from_a_ = {a.half_extents, b.half_extents, a.axes.transpose() * b.axes, a.axes.transpose() * between};
    from_b_ = {b.half_extents, a.half_extents, from_a_.axes.transpose(), b.axes.transpose() * -between};
  }

  /// A lower bound on the squared distance. It is cheap: only six axes are tested.
  [[nodiscard]] Scalar least_square() const {
    return std::max(from_a_.gaps().squaredNorm(), from_b_.gaps().squaredNorm());
  }

  /// The nearest points, or the first pair found whose squared distance is at most enough.
  [[nodiscard]] ClosestPoints<Scalar> closest(Scalar enough = 0) {
    if (!corners(from_a_, false, enough) && !corners(from_b_, true, enough) && !crossings(from_a_, false) &&
        !crossings(from_b_, true))
      edges(enough);
    const Rectangle<Scalar>& own = seen_from_b_ ? b_ : a_;
    const Vector<Scalar, 3> on_own = own.center + own.axes * own_;
    const Vector<Scalar, 3> on_other = own.center + own.axes * other_;
    const Vector<Scalar, 3> between = own.axes * (other_ - own_);
    if (seen_from_b_) return {on_other, on_own, -between, square_, tests_};
    return {on_own, on_other, between, square_, tests_};
  }

 private:
  using Seen = RectangleSeen<Scalar>;

  void take(const Vector<Scalar, 3>& own, const Vector<Scalar, 3>& other, bool from_b) {
    ++tests_;
    const Scalar square = (other - own).squaredNorm();
    if (square >= square_) return;
    square_ = square;
    own_ = own;
    other_ = other;
    seen_from_b_ = from_b;
  }

  /// Tests the other's vertices against the own rectangle. Returns whether one is near enough.
  bool corners(const Seen& seen, bool from_b, Scalar enough) {
    for (const int s : {-1, 1})
      for (const int t : {-1, 1}) {
        const Vector<Scalar, 3> corner = seen.at(Scalar(s) * seen.other[0], Scalar(t) * seen.other[1]);
        take(seen.nearest(corner), corner, from_b);
      }
    return square_ <= enough;
  }

  /// Finds an edge of the other that passes through the own rectangle. Returns whether there is one.
  bool crossings(const Seen& seen, bool from_b) {
    if (std::abs(seen.center[2]) > seen.reach(2)) return false;
    for (std::size_t along = 0; along < 2; ++along)
      for (const int side : {-1, 1}) {
        const int i = static_cast<int>(along);
        const Vector<Scalar, 3> middle = seen.center + Scalar(side) * seen.other[1 - along] * seen.axes.col(1 - i);
        const Scalar climb = seen.axes(2, i);
        if (climb == 0 || std::abs(middle[2]) > seen.other[along] * std::abs(climb)) continue;
        const Vector<Scalar, 3> at = middle - (middle[2] / climb) * seen.axes.col(i);
        if (std::abs(at[0]) > seen.own[0] || std::abs(at[1]) > seen.own[1]) continue;
        take({at[0], at[1], 0}, {at[0], at[1], 0}, from_b);
        return true;
      }
    return false;
  }

  /// Tests edges against edges. The nearest point can lie inside an edge only if the other rectangle reaches beyond the
  /// side that the edge is on.
  void edges(Scalar enough) {
    for (int i = 0; i < 2; ++i)
      for (const int side_a : {-1, 1}) {
        if (!reaches_beyond(from_a_, 1 - i, side_a)) continue;
        for (int j = 0; j < 2; ++j)
          for (const int side_b : {-1, 1}) {
            if (!reaches_beyond(from_b_, 1 - j, side_b)) continue;
            edge_pair(i, side_a, j, side_b);
            if (square_ <= enough) return;
          }
      }
  }

  [[nodiscard]] static bool reaches_beyond(const Seen& seen, int axis, int side) {
    return Scalar(side) * seen.center[axis] + seen.reach(axis) >= seen.own[axis];
  }

  /// Tests the first's edge along its axis i, on that side, against the second's edge along its axis j: as for two
  /// segments (query/distance/distance.hpp), projected along axis i.
  void edge_pair(int i, int side_a, int j, int side_b) {
    const int k = 1 - i;
    const Scalar a_half = from_a_.own[i];
    const Scalar b_half = from_a_.other[j];
    const Vector<Scalar, 3> direction = from_a_.axes.col(j);
    Vector<Scalar, 3> middle = from_a_.center;
    middle += Scalar(side_b) * from_a_.other[1 - j] * from_a_.axes.col(1 - j);
    Vector<Scalar, 3> on_a = Vector<Scalar, 3>::Zero();
    on_a[k] = Scalar(side_a) * from_a_.own[k];

    const Scalar off = middle[k] - on_a[k];
    const Scalar across = direction[k] * direction[k] + direction[2] * direction[2];
    const Scalar product = off * direction[k] + middle[2] * direction[2];
    Scalar t = across > 0 ? std::clamp(-product / across, -b_half, b_half) : Scalar(0);
    const Scalar s = middle[i] + t * direction[i];
    on_a[i] = std::clamp(s, -a_half, a_half);
    if (on_a[i] != s) t = std::clamp((on_a[i] - middle[i]) * direction[i] - product, -b_half, b_half);
    take(on_a, middle + t * direction, false);
  }

  const Rectangle<Scalar>& a_;
  const Rectangle<Scalar>& b_;
  Seen from_a_, from_b_;
  Vector<Scalar, 3> own_, other_;  // the nearest points so far, in the frame of one of them
  Scalar square_ = std::numeric_limits<Scalar>::infinity();
  bool seen_from_b_ = false;
  int tests_ = 0;
};

/// A segment is a rectangle without width.
template <class Scalar>
[[nodiscard]] ClosestPoints<Scalar> closest_points(const Rectangle<Scalar>& a, const Rectangle<Scalar>& b) {
  return RectanglePair<Scalar>(a, b).closest();
}

template <class Scalar>
[[nodiscard]] ClosestPoints<Scalar> closest_points(const Segment<Scalar>& segment, const Rectangle<Scalar>& rectangle) {
  const Vector<Scalar, 3> none = Vector<Scalar, 3>::Zero();
  return closest_points(rectangle_of<Scalar>(segment.start, {segment.edge, none}), rectangle);
}

}  // namespace snug::query
