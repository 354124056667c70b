// The vertex of a convex body that reaches farthest in a direction, by walking uphill over its edges.
// Source: C. Ericson, "Real-Time Collision Detection", 2005, 4.2.5.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "geometry/hull_neighbors.hpp"
#include "geometry/vector.hpp"

namespace snug::fit {

/// Where a walk ended.
template <class Scalar>
struct Climbed {
  Scalar value = 0;     // the greatest value of any vertex, whatever the rounding
  Index looked_at = 0;  // how many vertices were evaluated
};

/// What a walk did at a vertex: it evaluated those neighbours that it had not seen before, and best was the vertex of
/// greatest value after that.
struct WalkStep {
  Index vertex = kNoIndex;
  std::vector<Index> neighbors;
  Index best = kNoIndex;
};

/// A convex body to be walked over, and where the last walk in each of its directions ended.
///
/// The rounded values of a linear function can have false local maxima, and plateaus: equal vertices, and faces
/// perpendicular to the direction. So a walk continues through every vertex that is not certainly lower than the best.
/// That suffices: along a convex body's edges there is a path from any vertex to the true maximum on which the true
/// value never falls. If values are off by at most e, no vertex on that path seems lower than the best by more than 2e.
/// So the walk reaches the maximum, and from there every other vertex that seems higher.
template <class Scalar, int Dim>
class HillClimb {
 public:
  /// vertices: n >= 1, in the local frame; neighbors: theirs. Both must outlive it. directions: how many are asked for.
  /// all_points: whether the body has no other points, which rounding could place farther out.
  HillClimb(std::span<const Vector<Scalar, Dim>> vertices, const HullNeighbors& neighbors, int directions,
            bool all_points)
      : vertices_(vertices), neighbors_(neighbors), ends_(directions, 0), seen_(vertices.size(), 0),
        all_points_(all_points) {
    for (const auto& v : vertices) largest_ = largest_.cwiseMax(v.cwiseAbs());
  }

  [[nodiscard]] const Vector<Scalar, Dim>& vertex(Index v) const { return vertices_[v]; }
  /// The largest absolute coordinate of the vertices, by axis.
  [[nodiscard]] const Vector<Scalar, Dim>& largest() const { return largest_; }
  [[nodiscard]] bool all_points() const { return all_points_; }
  /// Where the last walk in the direction ended: the vertex of greatest value.
  [[nodiscard]] Index end(int direction) const { return ends_[direction]; }

  /// Starts where the last walk in this direction ended. value(v): a linear function, evaluated at vertex v;
  /// error_bound: at least twice its greatest error. walk: null, or a vector that receives what the walk did at each
  /// vertex.
  template <class Value, class Walk = std::nullptr_t>
  Climbed<Scalar> climb(int direction, Value&& value, Scalar error_bound, [[maybe_unused]] Walk walk = nullptr) {
    constexpr bool kSeen = !std::is_null_pointer_v<Walk>;
    Index& best = ends_[direction];
    Climbed<Scalar> climbed{value(best), 1};
    begin_walk();
    mark(best);
    open_.push_back({best, climbed.value});
    while (!open_.empty()) {
      const Open from = open_.back();
      open_.pop_back();
      if (from.value < climbed.value - error_bound) continue;
      if constexpr (kSeen) walk->push_back({from.vertex, {}, best});
      for (const Index v : neighbors_.of(from.vertex)) {
        if (!mark(v)) continue;
        const Scalar here = value(v);
        if constexpr (kSeen) walk->back().neighbors.push_back(v);
        ++climbed.looked_at;
        if (here < climbed.value - error_bound) continue;
        open_.push_back({v, here});
        if (here <= climbed.value) continue;
        climbed.value = here;
        best = v;
        if constexpr (kSeen) walk->back().best = v;
      }
    }
    return climbed;
  }

 private:
  struct Open {
    Index vertex;
    Scalar value;
  };

  void begin_walk() {
    if (++walk_ != 0) return;
    std::fill(seen_.begin(), seen_.end(), 0u);
    walk_ = 1;
  }
  bool mark(Index v) {
    std::uint32_t& seen = seen_[v];
    const bool first = seen != walk_;
    seen = walk_;
    return first;
  }

  std::span<const Vector<Scalar, Dim>> vertices_;
  const HullNeighbors& neighbors_;
  std::vector<Index> ends_;
  std::vector<std::uint32_t> seen_;  // the last walk in which each vertex was seen
  std::uint32_t walk_ = 0;
  std::vector<Open> open_;
  Vector<Scalar, Dim> largest_ = Vector<Scalar, Dim>::Zero();
  bool all_points_;
};

}  // namespace snug::fit
