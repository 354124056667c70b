// Quickhull in space: the point farthest outside a facet replaces all facets that it sees by a cone.
// Source: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The Quickhull algorithm for convex hulls", 1996. They thicken
// facets by the rounding error; here sides are decided exactly, and coplanar facets are merged at the end.
// This file runs the algorithm and tells its steps. The work is done by spanning_simplex (quickhull_simplex.hpp), by
// HullSurface::start, find_horizon and raise_cone (quickhull_surface.hpp), and by merge_faces (quickhull_faces.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "fit/hull/hull_steps.hpp"
#include "fit/hull/quickhull_2d.hpp"
#include "fit/hull/quickhull_faces.hpp"
#include "fit/hull/quickhull_simplex.hpp"
#include "fit/hull/quickhull_surface.hpp"
#include "number/tuple.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 10> kQuickhull3Pseudocode{
    "facets ← tetrahedron of far points",
    "if there is none: the hull is flat",
    "give each point to a facet that sees it",
    "while a facet has points outside",
    "  eye ← the farthest of them",
    "  find the facets that see eye, and their horizon",
    "  replace them by a cone from horizon to eye",
    "  give their points to it; drop those no facet sees",
    "merge facets in one plane; drop points that are not vertices",
    "return the facets",
};

/// Passes the counts on, but no steps, for they would be about another hull.
template <class Observer>
struct CountsOnly {
  Observer& observer;
  template <class Step>
  void operator()(const Step&) const noexcept {}
  void count(Operation operation, std::int64_t n) const { observer.count(operation, n); }
};

/// One run. What only the steps need is computed only if an observer sees them.
template <class Scalar, class Observer>
class Quickhull3 {
 public:
  Quickhull3(PointSpan<Scalar, 3> points, Observer& observe) : points_(points), observe_(observe) {}

  Fit<ConvexHull<Scalar, 3>> run() {
    std::vector<Index> simplex = spanning_simplex(points_);
    observe_.count(Operation::kPointsTouched, 3 * std::int64_t{points_.size()});
    if (simplex.size() < 4) return flat_hull(std::move(simplex));
    HullSurface<Scalar> surface(points_);
    start(surface, {simplex[0], simplex[1], simplex[2], simplex[3]});
    for (Index f = surface.next_open(); f != kNoIndex; f = surface.next_open()) add_farthest(surface, f);
    MergedFaces<Scalar> merged = merge_faces(surface, points_);
    if constexpr (kWatched<Observer>)
      if (merged.faces > 0) tell(8, FacesMerged{merged.faces, merged.dropped});
    return finish(std::move(merged.hull));
  }

 private:
  using Step = HullStep<Scalar, 3>;

  template <class Fact>
  void tell(int line, Fact fact) {
    observe_(Step{line, false, {}, std::move(fact)});
  }

  void start(HullSurface<Scalar>& surface, std::array<Index, 4> simplex) {
    surface.start(simplex);
    observe_.count(Operation::kPointsTouched, points_.size());
    count_tests(surface);
    if constexpr (kWatched<Observer>) {
      std::vector<Index> vertices;
      for (const Index f : surface.added())
        for (const Index v : facet(surface, f).vertices) vertices.push_back(v);
      tell(0, SimplexChosen{{simplex.begin(), simplex.end()}, vertices});
      tell_assigned(surface, 2);
    }
  }

  void add_farthest(HullSurface<Scalar>& surface, Index f) {
    if constexpr (kWatched<Observer>) tell(4, eye_of(facet(surface, f), f));
    surface.find_horizon(f);
    count_tests(surface);
    if constexpr (kWatched<Observer>) tell(5, HorizonFound{surface.eye(), surface.visible(), surface.horizon()});
    surface.raise_cone();
    count_tests(surface);
    if constexpr (kWatched<Observer>) {
      tell(6, FacetsReplaced{surface.eye(), surface.visible(), surface.horizon(), surface.added()});
      tell_assigned(surface, 7);
    }
  }

  /// Counts the tests since it was last called.
  void count_tests(const HullSurface<Scalar>& surface) {
    observe_.count(Operation::kOrientationTests, surface.tests() - counted_);
    counted_ = surface.tests();
  }

  void tell_assigned(const HullSurface<Scalar>& surface, int line) {
    PointsAssigned assigned{surface.added(), {}, {}, surface.dropped(), 0};
    for (const Index f : assigned.facets) {
      assigned.counts.push_back(facet(surface, f).count);
      surface.append_outside(f, assigned.points);
    }
    assigned.dropped = static_cast<Index>(assigned.inside.size());
    tell(line, std::move(assigned));
  }

  [[nodiscard]] static const Facet& facet(const HullSurface<Scalar>& surface, Index f) { return surface.facets()[f]; }

  /// The farthest point with its distance from the facet's plane.
  [[nodiscard]] EyeChosen eye_of(const Facet& from, Index f) const {
    const auto at = [this](Index i) -> Vector<double, 3> { return points_[i].template cast<double>(); };
    const auto unit = [](const Vector<double, 3>& v) -> Vector<double, 3> { return v / scaled_norm<double, 3>(v); };
    const Vector<double, 3> a = at(from.vertices[0]);
    const Vector<double, 3> e = unit(at(from.vertices[1]) - a), g = unit(at(from.vertices[2]) - a);
    const Vector<double, 3> normal = cross(e, g);
    const double length = scaled_norm<double, 3>(normal);
    const double distance = length > 0 ? std::abs((normal / length).dot(at(from.farthest) - a)) : 0;
    return {from.farthest, f, distance, from.count};
  }

  /// The hull of points in a plane, on a line or in one place. Along an axis that is not in the plane, no two of them
  /// have the same projection, so the hull of the projections is a ring of the same points.
  Fit<ConvexHull<Scalar, 3>> flat_hull(std::vector<Index> simplex) {
    const auto at = [this](Index i) -> Vector<double, 3> { return points_[i].template cast<double>(); };
    ConvexHull<Scalar, 3> hull;
    hull.affine_dim = static_cast<int>(simplex.size()) - 1;
    int axis = 0;
    if (simplex.size() == 3) axis = shadow_axis(at(simplex[0]), at(simplex[1]), at(simplex[2]));
    while (simplex.size() == 2 && shadow(at(simplex[0]), axis) == shadow(at(simplex[1]), axis)) ++axis;
    const auto shadow_at = [at, axis](Index i) { return shadow(at(i), axis); };
    if constexpr (kWatched<Observer>) tell(1, FlatFound{hull.affine_dim, simplex});
    CountsOnly<Observer> counts{observe_};
    hull.indices = hull_ring<Scalar>(points_.size(), shadow_at, counts);
    for (const Index i : hull.indices) hull.vertices.push_back(points_[i]);
    return finish(std::move(hull));
  }

  Fit<ConvexHull<Scalar, 3>> finish(ConvexHull<Scalar, 3> hull) {
    std::vector<Index> support = hull.indices;
    if constexpr (kWatched<Observer>) observe_(Step{9, true, hull, Finished{support}});
    return {std::move(hull), std::move(support)};
  }

  PointSpan<Scalar, 3> points_;
  Observer& observe_;
  std::int64_t counted_ = 0;
};

template <class Scalar, class Observer>
Fit<ConvexHull<Scalar, 3>> quickhull_3d(PointSpan<Scalar, 3> points, Observer& observe) {
  return Quickhull3<Scalar, Observer>(points, observe).run();
}

}  // namespace snug::fit
