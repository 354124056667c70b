// What the stage shows at a step, in geometric words: the picture before it has colours. No screen is needed for it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "lesson/session.hpp"

namespace snug::app {

using Point3 = Vector<double, 3>;

struct Shown {
  std::optional<fit::Volume3> volume;     // as it stands
  std::optional<fit::Volume3> before;     // the one that this step replaced
  std::optional<fit::Volume3> candidate;  // tried by this step, other than the volume
  bool candidate_fails = false;
  std::optional<fit::Volume3> rival;    // of slot 1, at the same share of its trace
  std::optional<fit::Volume3> optimum;  // where it is wanted, or at the end
  bool finished = false;

  std::vector<Index> support;  // what holds the volume, in this trace so far
  fit::Support forced;         // of it, what Welzl's recursion has forced onto the boundary
  int depth = 0;

  Index examined = kNoIndex;
  bool examined_outside = false;
  double outside_by = 0;          // < 0 inside, scene units
  Index left_outside = kNoIndex;  // the point that the candidate leaves outside

  struct Extremes {
    std::array<Index, 3> least, greatest;
  };
  std::optional<Extremes> extremes;
  struct Box {
    Point3 least, greatest, midpoint;
  };
  std::optional<Box> box;
  std::optional<fit::PairChosen> pair;  // the first diameter
  std::optional<Point3> mean;
  struct Spread {
    Matrix<double, 3> axes;  // columns, by rising sigma
    Point3 sigma;            // standard deviations, scene units
    bool named = false;      // whether the axes themselves were found yet
    bool ends = false;       // whether the extreme points along the main axis were
  };
  std::optional<Spread> spread;

  /// For box fitters: the hull's vertices, and the points that the step speaks of.
  std::vector<Index> hull, spoken_of;
  /// For a test of two boxes: the axis that the step speaks of (lesson::axis_at), the one that a question asks about,
  /// and what is known at the end.
  std::optional<query::AxisTested<double, 3>> axis, axis_asked;
  std::optional<bool> overlap;
  std::optional<query::OutlinesCompared> outlines;  // of the wrong tests
  std::optional<query::CornerTried> corner;
  /// For a box and a frustum: the plane that the step speaks of (lesson::plane_at), -1 for none, with its p- and
  /// n-vertex where they are known; nothing of it is shown while a question asks about it. Then the vertices tested
  /// against that plane or against all planes, the current one last, and what is known so far.
  int plane_at = -1;
  std::optional<query::PlaneTested<double, 3>> plane;
  bool plane_asked = false;
  std::vector<query::CornerTested<double, 3>> corners;
  std::optional<query::Culling> verdict;

  /// While an outcome stands: the points of a wrong guess, and those that would have been right.
  std::vector<Index> guessed_wrong, right;
};

/// The ball that a volume is; null where it is none.
[[nodiscard]] inline const fit::Sphere3* ball_in(const std::optional<fit::Volume3>& volume) {
  return volume ? std::get_if<fit::Sphere3>(&*volume) : nullptr;
}

/// At the session's step. want_optimum: also before the end; it costs a run of its own after each edit.
[[nodiscard]] Shown shown_at(const lesson::Session& session, bool want_optimum);

}  // namespace snug::app
