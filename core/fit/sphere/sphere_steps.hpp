// The steps of the sphere fitters.
#pragma once

#include <span>
#include <string_view>
#include <variant>

#include "fit/facts.hpp"
#include "fit/fit.hpp"
#include "geometry/sphere.hpp"
#include "trace/fields.hpp"

namespace snug::fit {

/// The axis-aligned bounding box and its centre.
template <class Scalar, int Dim>
struct MidpointFound {
  static constexpr std::string_view kName = "midpoint_found";
  Vector<Scalar, Dim> least, greatest, midpoint;
  SNUG_FIELDS(least, greatest, midpoint);
};

/// The point farthest from a centre, which sets the radius.
struct FarthestFound {
  static constexpr std::string_view kName = "farthest_found";
  Index point = kNoIndex;
  double distance = 0;
  SNUG_FIELDS(point, distance);
};

/// A point was tested against the ball: distance is from its centre, in scene units; depth: how many points were then
/// forced onto the boundary (Welzl only).
struct PointExamined {
  static constexpr std::string_view kName = "point_examined";
  Index point = kNoIndex;
  double distance = 0;
  bool outside = false;
  int depth = 0;
  SNUG_FIELDS(point, distance, outside, depth);
};

/// The ball grew just enough to contain the point.
template <class Scalar, int Dim>
struct BallGrown {
  static constexpr std::string_view kName = "ball_grown";
  Index point = kNoIndex;
  Sphere<Scalar, Dim> before;
  SNUG_FIELDS(point, before);
};

/// A new pass of the iterative algorithm: the ball was shrunk and the order shuffled.
template <class Scalar, int Dim>
struct BallShrunk {
  static constexpr std::string_view kName = "ball_shrunk";
  int pass = 0;  // counted from 1
  Sphere<Scalar, Dim> before;
  SNUG_FIELDS(pass, before);
};

/// The end of a pass: whether its ball is smaller than the best so far.
template <class Scalar, int Dim>
struct PassJudged {
  static constexpr std::string_view kName = "pass_judged";
  int pass = 0;
  bool better = false;
  Sphere<Scalar, Dim> best;
  SNUG_FIELDS(pass, better, best);
};

/// The smallest ball through all points fixed on the boundary; depth: how many these are.
struct BoundaryForced {
  static constexpr std::string_view kName = "boundary_forced";
  Support boundary;
  int depth = 0;
  SNUG_FIELDS(boundary, depth);
};

/// The point was moved to the front of the list, after the smallest ball of it and all points before it was found.
struct MovedToFront {
  static constexpr std::string_view kName = "moved_to_front";
  Index point = kNoIndex;
  int depth = 0;
  SNUG_FIELDS(point, depth);
};

/// Every point was tested against the ball. outside: in how many of the blocks of points (one block, where there are
/// few) the farthest lay outside; 0 where the ball contains them all.
struct AllChecked {
  static constexpr std::string_view kName = "all_checked";
  Index outside = 0;
  SNUG_FIELDS(outside);
};

/// The finished ball was tested against every point: the farthest one, and whether rounding had left it outside, so
/// that the radius was widened by its last digits.
struct RadiusChecked {
  static constexpr std::string_view kName = "radius_checked";
  Index farthest = kNoIndex;
  bool widened = false;
  SNUG_FIELDS(farthest, widened);
};

/// A point entered the support set; those that no longer support the ball left it.
struct SupportReplaced {
  static constexpr std::string_view kName = "support_replaced";
  Index entered = kNoIndex;
  Support before, after;
  SNUG_FIELDS(entered, before, after);
};

/// The recursion as lectures print it: a call was made for the first points of the list, which has `left`, with those
/// of the support on the boundary. It removes the last point, and calls on the others; where there is none to remove
/// (point is kNoIndex), it returns the ball through the support at once. depth: how many calls are open, this one
/// included; bytes: what they keep.
struct CallEntered {
  static constexpr std::string_view kName = "call_entered";
  Index point = kNoIndex;
  Index left = 0;
  Support boundary;
  int depth = 0;
  int bytes = 0;
  SNUG_FIELDS(point, left, boundary, depth, bytes);
};

/// The first call has returned, and its ball was tested against the point that was removed: inside, this call returns
/// the same ball; outside, the point joins the support, and the call on the others is made again. distance: from the
/// ball's centre, 0 where there is no ball yet.
struct CallDecided {
  static constexpr std::string_view kName = "call_decided";
  Index point = kNoIndex;
  double distance = 0;
  bool outside = false;
  Support boundary;
  int depth = 0;
  SNUG_FIELDS(point, distance, outside, boundary, depth);
};

/// The recursion reached the depth that the stack is given, and was stopped: so many points had not been removed yet.
struct RecursionStopped {
  static constexpr std::string_view kName = "recursion_stopped";
  int depth = 0;
  Index left = 0;
  int bytes = 0;
  SNUG_FIELDS(depth, left, bytes);
};

/// Brute force: the ball of a few points was kept, was no smaller than the best, or left a point outside; or there was
/// none (kNoBall: fewer of these points support their smallest ball; kDependent: they lie on a line, or in a plane of
/// space, so they do not determine a ball).
template <class Scalar, int Dim>
struct CandidateTried {
  static constexpr std::string_view kName = "candidate_tried";
  enum class Verdict { kKept, kNotSmaller, kLeavesPointOutside, kNoBall, kDependent };
  Support points;
  Sphere<Scalar, Dim> candidate;
  Verdict verdict = Verdict::kKept;
  Index outside = kNoIndex;  // the first point found outside
  SNUG_FIELDS(points, candidate, verdict, outside);
};

template <class Scalar, int Dim>
using SphereStep =
    Step<Sphere<Scalar, Dim>, ExtremesFound<Scalar, Dim>, MidpointFound<Scalar, Dim>, PairChosen, FarthestFound,
         PointExamined, BallGrown<Scalar, Dim>, MeanFound<Scalar, Dim>, CovarianceFound<Scalar, Dim>,
         AxesFound<Scalar, Dim>, BallShrunk<Scalar, Dim>, PassJudged<Scalar, Dim>, BoundaryForced, MovedToFront,
         AllChecked, RadiusChecked, SupportReplaced, CandidateTried<Scalar, Dim>, CallEntered, CallDecided,
         RecursionStopped, Finished>;

/// What fits spheres.
[[nodiscard]] std::span<const Algorithm> rows_of(const Sphere<double, 3>*);

}  // namespace snug::fit
