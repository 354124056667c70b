// The figures by which bodies rest, sleep and are kept apart, all of them relative: lengths as parts of the thinner
// body's half thickness, speeds as parts of what gravity adds in a round.
#pragma once

namespace snug::physics::limits {

/// The penetration at which bodies at rest are not pushed apart, so that contacts last from round to round. Tested by
/// "ten boxes come to rest and stay for ten minutes".
inline constexpr double kSlop = 2e-3;

/// The part of any deeper penetration that is corrected in a round, where no impact pays for all of it.
inline constexpr double kMended = 0.2;

/// A body is not pushed against a firmer one by more than the first part of its half thickness, nor sideways if less
/// than the second part (squared) is left. Tested by "what pushes a body does not push it into what is fixed".
inline constexpr double kShared = 0.1, kLeastFree = 0.25;

/// Bodies that approach more slowly than this do not bounce.
inline constexpr double kRestitutionThreshold = 3;

/// A body may sleep once it is slower than this, at every point, for so many rounds, and its average velocity over them
/// is below the third figure: then it is not about to roll, slide or fall over. Tested by "what has no support, or is
/// about to move, does not sleep".
inline constexpr double kStill = 0.25;
inline constexpr int kStillRounds = 30;
inline constexpr double kDrifts = 0.01;

/// Without gravity, these speeds are relative to this.
inline constexpr double kUsualGravity = 9.81;

/// A frame of a solid scene is divided into rounds: none longer than the first number, in seconds, and none in which
/// gravity moves a body by more than the second, as a fraction of its half thickness. Tested by "small bodies stand as
/// large ones do" and "a frame may be a second".
inline constexpr double kLongestRound = 0.02, kFallInRound = 0.0055;
inline constexpr int kMostRounds = 1000;

/// Iterations stop once no speed is wrong by more than this, or after so many, times the root of the ratio of masses. A
/// stack of ten needs about as many to carry its weight down; warm starts do the rest.
inline constexpr double kSettled = 5e-3;
inline constexpr int kIterations = 24, kMostIterations = 400;

/// Contact points of successive rounds no farther apart than this, in parts of the thinner half thickness, are the same
/// point: the new one starts with the impulse of the old one.
inline constexpr double kSamePoint = 0.2;

/// An axis of two edges is chosen for the contact of boxes only where its separation is this much larger than that of a
/// face: faces give more points to rest on. Tested by "ten boxes come to rest and stay for ten minutes".
inline constexpr double kEdgeOverFace = 0.05;

/// Edges whose directions have a sine below this are parallel: their faces meet as well.
inline constexpr double kParallelEdges = 1e-3;

/// Halvings that find the moment at which a fast body meets another: within 2^-20 of its path.
inline constexpr int kHalvings = 20;

/// The most steps in which a fast body's path is examined: at 200 a second a ball of radius 0.01 takes 1,333 at most.
inline constexpr int kMostSteps = 20000;

/// The most of its own thicknesses that a body may cross in a frame at the start: a ball of radius 0.1 at 2,000 a
/// second crosses 167. So its whole path can be examined in bounded time.
inline constexpr double kMostCrossed = 1000;

/// How deep a body may start in a fixed one, as a fraction of its half thickness. Tested by "a body that starts deep in
/// what is fixed is refused by name".
inline constexpr double kDeepestStart = 0.02;

/// How far a fast body that already touches another may go into it, as a fraction of its half thickness, before it is
/// stopped. Tested by "a slender body flung into the corner of two walls stays before both".
inline constexpr double kDeepest = 0.5;

}  // namespace snug::physics::limits
