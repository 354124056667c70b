// The smallest box of a hull in space, found and proven among the boxes with two adjacent faces on edges.
// Source: J. O'Rourke, "Finding minimal enclosing boxes", 1985: the smallest box is one of them. (Seen along each of
// its axes it is a smallest rectangle, one side of which lies on an edge of what the hull casts, by H. Freeman, R.
// Shapira, "Determining the minimum-area encasing rectangle for an arbitrary closed curve", 1975; so two of its faces
// that meet have an edge each.) How they are gone through is ours: as each pair of edges lets the box turn along one
// curve, on which the volume between any six fixed vertices is a rational function, whole stretches of it are ruled out
// by the signs of a quartic's Bernstein coefficients, and what is left is halved.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "fit/obb/obb_hull_solid.hpp"

namespace snug::fit {

/// What a search over the pairs of one edge came to.
struct PairTally {
  Index pairs = 0;      // later edges that an adjacent face can lie on
  Index ruled_out = 0;  // of these, by the first bound
  Index halvings = 0;
};

class EdgePairSearch {
 public:
  /// A smaller box: the vertices of both edges, by their places in the hull. It is axes() then.
  using SeeSmaller = std::function<void(const std::array<Index, 4>& on)>;

  /// start: the axes of a box to beat; the smaller it is, the less is left to do.
  EdgePairSearch(const HullSolid& solid, const Matrix<double, 3>& start);

  /// Goes through all boxes with a face on this edge and an adjacent one on a later edge. After all edges have had
  /// their turn, no box is smaller than lower_bound(). count: Ignore or Tally.
  template <class Count>
  PairTally search(Index edge, const SeeSmaller& see, Count& count);
  PairTally search(Index edge, const SeeSmaller& see) {
    Ignore ignore;
    return search(edge, see, ignore);
  }

  /// The axes of the smallest box found.
  [[nodiscard]] const Matrix<double, 3>& axes() const { return axes_; }
  [[nodiscard]] double measure() const { return measure_; }  // in the solid's units
  /// Below it by what rounding may cost: each length tolerance::kBoxProof of the size.
  [[nodiscard]] double lower_bound() const { return to_beat_; }

 private:
  using Point = Vector<double, 3>;

  /// A box of the curve: its normals are (1 - t) a + t b of the first arc and the same with s of the second, not unit.
  struct Place {
    double t = 0, s = 0;
  };
  /// A part of the curve on which both shares rise or fall all the way.
  struct Stretch {
    Place from, to;
  };
  /// Both normals at both ends of a stretch, scaled so that they go linearly in one parameter.
  struct Ends {
    std::array<Point, 2> first, second;
  };
  /// Two arcs with the dot products of their ends, the first's a or b with the second's.
  struct Pair {
    const NormalArc& first;
    const NormalArc& second;
    double aa, ab, ba, bb;

    [[nodiscard]] Place at_first(double t) const;
    [[nodiscard]] Place at_second(double s) const;
    [[nodiscard]] Ends by_first(const Stretch& stretch) const;
    [[nodiscard]] Ends by_second(const Stretch& stretch) const;
  };
  /// Between which vertices the box's lengths are measured, as vectors from one to the other.
  struct Spans {
    Point first, second, third;
  };

  template <class Count>
  void search_pair(const Pair& pair, PairTally& tally, const SeeSmaller& see, Count& count);
  template <class Count>
  void halve(const Pair& pair, const Stretch& stretch, PairTally& tally, const SeeSmaller& see, Count& count);
  [[nodiscard]] Spans nearby_spans(const Pair& pair, double t) const;
  template <class Count>
  [[nodiscard]] Spans spans_at(const Pair& pair, const Point& first, const Point& second, Count& count) const;
  [[nodiscard]] std::array<Index, 4> vertices_of(const Pair& pair) const;
  template <class Count>
  [[nodiscard]] bool all_larger(const Ends& ends, const Spans& spans, Count& count) const;
  bool take(const Matrix<double, 3>& axes);

  const HullSolid& solid_;
  Matrix<double, 3> axes_;
  double measure_ = 0;
  double to_beat_ = 0;
  std::vector<std::array<std::size_t, 2>> ends_;  // of each arc, by their normals
  std::vector<double> with_a_, with_b_;  // of the present first arc: the dot products of its ends with all normals
  std::vector<Stretch> open_;
};

}  // namespace snug::fit
