// The figures by which bodies rest, sleep and are held apart: lengths in scene units, speeds a second.
#pragma once

namespace snug::scene::limits {

/// How deep bodies at rest may lie in each other without being pushed apart: so contacts last from frame to frame. Held by
/// "ten boxes come to rest and stay for ten minutes".
inline constexpr double kSlop = 1e-3;

/// Which part of what is deeper than that is mended in a frame: all at once would throw bodies about.
inline constexpr double kMended = 0.2;

/// Bodies that come slower than this do not bounce; gravity alone adds 0.16 in a frame.
inline constexpr double kBounces = 0.5;

/// Slower than both (scene units, radians a second) for so many frames, and bodies that lean on each other sleep.
inline constexpr double kStillSpeed = 0.04, kStillTurning = 0.06;
inline constexpr int kStillFrames = 30;

/// How often all contacts are gone over in a frame. A stack of ten needs about as many to carry its weight down; warm starts
/// do the rest.
inline constexpr int kSweeps = 24;

/// An axis of two edges is taken for the contact of boxes only where it shows them this much farther apart than a face
/// does, in parts of the thinner box: faces give more points to rest on. Held by the same.
inline constexpr double kEdgeOverFace = 0.05;

/// Edges whose directions have a sine below this are parallel: their faces meet as well.
inline constexpr double kParallelEdges = 1e-3;

/// Halvings by which the moment at which a fast body meets another is found: within 2^-20 of its way.
inline constexpr int kHalvings = 20;

/// The most steps in which a fast body's way is looked at: at 200 a second a ball of radius 0.01 takes 667.
inline constexpr int kMostSteps = 20000;

}  // namespace snug::scene::limits
