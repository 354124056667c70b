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
  std::optional<fit::Sphere3> ball;       // as it stands
  std::optional<fit::Sphere3> before;     // the one that this step replaced
  std::optional<fit::Sphere3> candidate;  // tried by this step, other than the ball
  bool candidate_fails = false;
  std::optional<fit::Sphere3> rival;      // of slot 1, at the same share of its trace
  std::optional<fit::Sphere3> optimum;    // where it is wanted, or at the end
  bool finished = false;

  fit::Support support;                   // what holds the ball, in this trace so far
  fit::Support forced;                    // of it, what Welzl's recursion has forced onto the boundary
  int depth = 0;

  Index examined = kNoIndex;
  bool examined_outside = false;
  double outside_by = 0;                  // < 0 inside, scene units
  Index left_outside = kNoIndex;          // the point that the candidate leaves outside

  struct Extremes {
    std::array<Index, 3> least, greatest;
  };
  std::optional<Extremes> extremes;
  struct Box {
    Point3 least, greatest, midpoint;
  };
  std::optional<Box> box;
  std::optional<fit::PairChosen> pair;    // the first diameter
  std::optional<Point3> mean;
  struct Spread {
    Matrix<double, 3> axes;               // columns, by rising sigma
    Point3 sigma;                         // standard deviations, scene units
    bool named = false;                   // whether the axes themselves were found yet
    bool ends = false;                    // whether the extreme points along the main axis were
  };
  std::optional<Spread> spread;

  /// While an outcome stands: the points of a wrong guess, and those that would have been right.
  std::vector<Index> guessed_wrong, right;
};

/// At the session's step. want_optimum: also before the end; it costs a run of its own after each edit.
[[nodiscard]] Shown shown_at(const lesson::Session& session, bool want_optimum);

}  // namespace snug::app
