// Quickhull in the plane as it is often printed: sides are decided in the points' own scalar, with or without an
// epsilon, and nothing is checked afterwards. quickhull_2d.hpp is the careful one beside it.
#pragma once

#include <cmath>

#include "fit/hull/quickhull.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 7> kQuickhullRoundedPseudocode{
    "edges ← a b and b a, a the leftmost point, b the rightmost",
    "give p to the edge a b if (b − a) × (p − a) < 0, rounded",
    "while an edge a b has points outside",
    "  c ← the one of least cross product",
    "  replace a b by a c and c b",
    "  give its points to these two in the same way",
    "return the edges in their order",
};
inline constexpr std::array<std::string_view, 7> kQuickhullEpsilonPseudocode = [] {
  auto lines = kQuickhullRoundedPseudocode;
  lines[1] = "give p to a b if it is over 0.000001 outside";
  lines[3] = "  c ← the farthest of them";
  return lines;
}();

/// Callers refuse more points: what is left outside is looked for edge by edge.
inline constexpr Index kQuickhullNaiveLimit = 1000;

/// The sign of the cross product as it is rounded.
template <class Scalar>
struct RoundedSides {
  using Point = Vector<double, 2>;
  static bool outside(const Point& a, const Point& b, const Point& p) { return cross(a, b, p) < 0; }
  static int farther(const Point& a, const Point& b, const Point& p, const Point& q) {
    const Scalar of_p = cross(a, b, p), of_q = cross(a, b, q);
    if (of_q < of_p) return 1;
    return of_q > of_p ? -1 : 0;
  }
  /// The points are Scalar's own, so that casting them back is exact.
  static Scalar cross(const Point& a, const Point& b, const Point& p) {
    const Vector<Scalar, 2> from = a.cast<Scalar>();
    const Vector<Scalar, 2> along = b.cast<Scalar>() - from, out = p.cast<Scalar>() - from;
    return along[0] * out[1] - along[1] * out[0];
  }
};

/// The usual remedy: a point counts as outside once it is so far from the edge's line, whatever the size of the points.
template <class Scalar>
struct EpsilonSides : RoundedSides<Scalar> {
  static constexpr double kEpsilon = 1e-6;  // scene units
  using Point = Vector<double, 2>;
  static bool outside(const Point& a, const Point& b, const Point& p) {
    const Vector<Scalar, 2> along = b.cast<Scalar>() - a.cast<Scalar>();
    const Scalar length = std::sqrt(along[0] * along[0] + along[1] * along[1]);
    return -RoundedSides<Scalar>::cross(a, b, p) > static_cast<Scalar>(kEpsilon) * length;
  }
};

/// The ring that rounded tests lead to: it may leave points outside, and have dents. Sides: RoundedSides or
/// EpsilonSides. points: as of quickhull; in 3-D it is quickhull. Each split takes a point for good, so it ends after
/// at most n of them.
template <template <class> class Sides, class Scalar, int Dim, StepObserver<HullStep<Scalar, Dim>> Observer = Ignore>
Fit<ConvexHull<Scalar, Dim>> quickhull_naive(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  if constexpr (Dim == 2) return quickhull_2d<Scalar, Sides<Scalar>>(points, observe);
  else return quickhull(points, observe);
}

}  // namespace snug::fit
