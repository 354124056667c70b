// Finds and proves the smallest box around a hull in space, among those with two adjacent faces flush with edges.
// Source: J. O'Rourke, "Finding minimal enclosing boxes", 1985: the smallest box is one of them. (Projected along any
// of its axes it is a smallest rectangle, one side of which lies on an edge of the projected hull, by H. Freeman, R.
// Shapira, "Determining the minimum-area encasing rectangle for an arbitrary closed curve", 1975; so two adjacent faces
// are flush with an edge each.) The search is our own. Each pair of edges lets the box rotate along one curve, on which
// the volume between any six fixed vertices is a rational function. Whole stretches of the curve are ruled out by the
// signs of a quartic's Bernstein coefficients, and the rest is halved.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "fit/obb/obb_hull_solid.hpp"

namespace snug::fit {

/// The result of a search over the pairs of one edge.
struct PairTally {
  Index pairs = 0;      // later edges that an adjacent face can be flush with
  Index ruled_out = 0;  // how many of them the first bound ruled out
  Index halvings = 0;
  std::optional<std::array<Index, 4>> smaller_on;  // the vertices of both edges, by index in the hull, if a smaller box
                                                   // was found: those of the smallest, whose axes are axes()
};

class EdgePairSearch {
 public:
  /// start: the axes of the box to beat; the smaller it is, the less work is left.
  EdgePairSearch(const HullSolid& solid, const Matrix<double, 3>& start);

  /// Searches all boxes with one face flush with this edge and an adjacent one flush with a later edge. Once all edges
  /// are searched, no box is smaller than lower_bound(). count: Ignore or PartCounter.
  template <class Count>
  PairTally search(Index edge, Count& count);
  PairTally search(Index edge) {
    Ignore ignore;
    return search(edge, ignore);
  }

  /// The axes of the smallest box found.
  [[nodiscard]] const Matrix<double, 3>& axes() const { return axes_; }
  [[nodiscard]] double measure() const { return measure_; }  // in the solid's units
  /// Below measure() by the rounding error: tolerance::kBoxProof of the size in each length.
  [[nodiscard]] double lower_bound() const { return to_beat_; }

 private:
  using Point = Vector<double, 3>;

  /// A box on the curve: its normals are (1 - t) a + t b on the first arc, the same with s on the second; not unit.
  struct Place {
    double t = 0, s = 0;
  };
  /// A part of the curve on which t and s are both monotonic.
  struct Stretch {
    Place from, to;
  };
  /// Both normals at both ends of a stretch, scaled so that they are linear in one parameter.
  struct Ends {
    std::array<Point, 2> first, second;
  };
  /// Two arcs, with the dot products of the ends of the first with those of the second.
  struct Pair {
    const NormalArc& first;
    const NormalArc& second;
    double aa, ab, ba, bb;

    [[nodiscard]] Place at_first(double t) const;
    [[nodiscard]] Place at_second(double s) const;
    [[nodiscard]] Ends by_first(const Stretch& stretch) const;
    [[nodiscard]] Ends by_second(const Stretch& stretch) const;
  };
  /// The vectors between the vertices that the box's lengths are measured between.
  struct Spans {
    Point first, second, third;
  };

  template <class Count>
  void search_pair(const Pair& pair, PairTally& tally, Count& count);
  template <class Count>
  void halve(const Pair& pair, const Stretch& stretch, PairTally& tally, Count& count);
  [[nodiscard]] Spans nearby_spans(const Pair& pair, double t) const;
  template <class Count>
  [[nodiscard]] Spans spans_at(const Pair& pair, const Point& first, const Point& second, Count& count) const;
  [[nodiscard]] std::array<Index, 4> vertices_of(const Pair& pair) const;
  template <class Count>
  [[nodiscard]] bool all_larger(const Ends& ends, const Spans& spans, Count& count) const;
  template <class Count>
  [[nodiscard]] bool all_larger_around(const Pair& pair, const Stretch& stretch, const Spans& spans,
                                       Count& count) const;
  [[nodiscard]] static Place within(const Stretch& stretch, const Place& place);
  bool take(const Matrix<double, 3>& axes);

  const HullSolid& solid_;
  Matrix<double, 3> axes_;
  double measure_ = 0;
  double to_beat_ = 0;
  std::vector<std::array<std::size_t, 2>> ends_;  // of each arc: the indices of its end normals
  std::vector<double> with_a_, with_b_;           // the dot products of the current first arc's ends with all normals
  std::vector<Stretch> open_;
};

}  // namespace snug::fit
