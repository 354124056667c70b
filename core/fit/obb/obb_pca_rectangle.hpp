// An oriented box along one principal axis, with the rectangle of least area around the projection along it.
// Source: G. Barequet, S. Har-Peled, "Efficiently approximating the minimum-volume bounding box of a point set in three
// dimensions", 2001, and I. D. Romanick, "Data Structures & Algorithms for Geometry", 2007: project along an axis of
// the PCA box, take the rectangle of least area, repeat.
#pragma once

#include <array>
#include <string_view>

#include "fit/obb/obb_hull.hpp"
#include "fit/obb/obb_pca.hpp"
#include "fit/obb/obb_trials.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 10> kObbPcaRectanglePseudocode{
    "hull ← convex hull of the points",
    "m ← mean of its vertices",
    "C ← their covariance about m",
    "box ← on the eigenvectors of C",
    "for each axis of the box, the shortest first",
    "  turn calipers around the projection along it",
    "  rectangle ← the smallest of all its edges",
    "  if its box is smaller: keep it, start over",
    "extents ← least and greatest along each",
    "return box",
};

/// After so many rectangles a box is shrunk no further, whatever they would gain. Where the k-th gains a part of about
/// 3 / k^2 (tolerance::kSameBox), those after these have less than 3 / 512 to gain together; where points are flat but
/// for their rounding, each of thousands may gain some. Tested by "however many rectangles would shrink a box, no more
/// than stated are tried".
inline constexpr int kMostRectangles = 512;

/// How many edges of projections are reported in a run. An outline of a mesh has hundreds, and there may be hundreds of
/// projections: one whose edges would be too many is reported by its smallest rectangle alone.
inline constexpr std::ptrdiff_t kMostTurnsTold = 240;

/// Reports the rectangles on which the calipers stand. points: which of them each index means.
template <class Scalar, class Observer>
void tell_turns(const std::vector<CalipersTurn>& turns, const ObbTrials<Scalar, 3, Observer>& trials,
                const std::vector<Index>& points, int line, Observer& observe) {
  double least = 0;
  for (const CalipersTurn& turn : turns) {
    const Obb<Scalar, 3> box = trials.box_on(turn.rectangle.axes);
    const double area = 4.0 * static_cast<double>(box.half_extents[1]) * static_cast<double>(box.half_extents[2]);
    if (turn.better) least = area;
    std::vector<Index> touching;
    for (const Index i : turn.touching) touching.push_back(points[i]);
    observe(ObbStep<Scalar, 3>{line, true, trials.box(),
                               CalipersTurned<Scalar, 3>{box.axes.col(0), touching, box, area, least, turn.better}});
  }
}

/// The rectangle with its edge as indices of points. vertices: a point's index for each vertex.
[[nodiscard]] inline RectangleFrame<3> on_points(RectangleFrame<3> found, const std::vector<Index>& vertices) {
  for (Index* i : {&found.edge_a, &found.edge_b})
    if (*i != kNoIndex) *i = vertices[*i];
  return found;
}

/// Reports a rectangle. found: with its edge as indices of points. line: as below.
template <class Scalar, int Dim, class Observer>
void attempt_rectangle(ObbTrials<Scalar, Dim, Observer>& trials, const RectangleFrame<Dim>& found, int line,
                       Observer& observe) {
  trials.attempt_and_tell(found.axes, [&](const Obb<Scalar, Dim>& box, bool better) {
    Vector<Scalar, Dim> along = Vector<Scalar, Dim>::Zero();
    if constexpr (Dim == 3) along = box.axes.col(0);
    observe(ObbStep<Scalar, Dim>{
        line + (better ? 1 : 0), true, trials.box(),
        RectangleFound<Scalar, Dim>{along, found.edge_a, found.edge_b, box, measure(box), better}});
  });
}

/// The smallest rectangle around the points' projection along a direction, reported edge by edge as long as that is not
/// too much. left: how many edges may still be reported.
template <class Scalar, class Observer>
RectangleFrame<3> told_rectangle_along(const Vector<double, 3>& direction, const ObbTrials<Scalar, 3, Observer>& trials,
                                       const std::vector<Index>& indices, std::ptrdiff_t& left, int line,
                                       Observer& observe) {
  if constexpr (kWatched<Observer>) {
    PartCounter tally;
    std::vector<CalipersTurn> turns;
    const RectangleFrame<3> found = rectangle_along(direction, trials.local().at, tally, turns);
    hand_on(tally, observe);
    if (std::ssize(turns) > left) return found;
    left -= std::ssize(turns);
    tell_turns(turns, trials, indices, line, observe);
    return found;
  } else {
    return watched_rectangle_along(direction, trials.local().at, observe);
  }
}

/// Tries rectangles perpendicular to the best box's axes, the shortest axis first, until none makes the box smaller by
/// more than a fraction tolerance::kSameBox, but at most kMostRectangles of them. line: for a rectangle; the line after
/// it is for a smaller box, and the one before it for the edges of a projection. told: how many of these are reported.
template <class Scalar, class Observer>
void shrink_by_rectangles(ObbTrials<Scalar, 3, Observer>& trials, const std::vector<Index>& indices, int line,
                          std::ptrdiff_t told, Observer& observe) {
  for (int turn = 0, tried = 0; turn < 3 && tried < kMostRectangles; ++tried) {
    const auto& points = trials.local().at;
    const double before = trials.least();
    const Matrix<double, 3> box = by_length<3>(LocalBox<3>(trials.axes(), points));
    count_box<3>(points.size(), observe);
    const RectangleFrame<3> found = told_rectangle_along(box.col(turn), trials, indices, told, line - 1, observe);
    attempt_rectangle(trials, on_points(found, indices), line, observe);
    turn = trials.least() < before * (1 - tolerance::kSameBox) ? 0 : turn + 1;
  }
}

/// The PCA box, improved by rectangles of least area perpendicular to its axes until it no longer shrinks. In 2-D there
/// is one such rectangle, which is the smallest box. points: n >= 1 finite points, scene units. Expected O(n log n)
/// time, and O(h log h) for each of at most kMostRectangles rectangles, with h vertices on the hull.
template <class Scalar, int Dim, StepObserver<ObbStep<Scalar, Dim>> Observer = Ignore>
Fit<Obb<Scalar, Dim>> obb_pca_rectangle(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  using Watcher = std::remove_reference_t<Observer>;
  const ConvexHull<Scalar, Dim> hull = watched_hull(points, 0, observe);
  const PointSet<Scalar, Dim> vertices = vertices_of(hull);
  const Matrix<Scalar, Dim> axes = watched_principal_axes(vertices.span(), 1, observe);
  ObbTrials<Scalar, Dim, Watcher> trials(hull.vertices, observe);
  trials.attempt(axes.template cast<double>(), std::array<Index, 0>{}, 3);
  if constexpr (Dim == 3) {
    shrink_by_rectangles(trials, hull.indices, 6, kMostTurnsTold, observe);
  } else {
    PartCounterFor<Watcher> tally;
    const RectangleFrame<2> found = smallest_rectangle(hull, tally);
    hand_on(tally, observe);
    attempt_rectangle(trials, found, 6, observe);
  }
  return finish_on_hull<Scalar, Dim>(trials.scalar_axes(), hull, 8, observe);
}

}  // namespace snug::fit
