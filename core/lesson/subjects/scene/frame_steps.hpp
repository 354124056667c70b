// The fact about a frame of a moving scene: how many pairs each stage left, and what the updates of volumes cost.
#pragma once

#include <string_view>
#include <variant>

#include "fit/any_step.hpp"
#include "trace/fields.hpp"

namespace snug::lesson {

/// A frame was computed. The numbers of pairs of bodies: all of them, those whose AABBs were compared, those whose
/// AABBs overlap, those whose bounding spheres overlap as well, those that touch. swaps: how many neighbours changed
/// places while the AABBs were sorted along an axis.
struct FrameTaken {
  static constexpr std::string_view kName = "frame_taken";
  int frame = 0;  // counted from 1
  double all_pairs = 0, compared = 0, after_broad = 0, after_loose = 0, touching = 0;
  double swaps = 0;
  double slack = 0;      // looseness of all updated volumes together: 0.5 is half as large again as the tightest
  double cost = 0;       // points that the updates examined
  double energy = 0;     // kinetic and potential, of all bodies that move, kg (scene units / s)^2
  bool resting = false;  // nothing moved and nothing will
  int hash_high = 0, hash_low = 0;  // a hash of every bit of the state
  SNUG_FIELDS(frame, all_pairs, compared, after_broad, after_loose, touching, swaps, slack, cost, energy, resting,
              hash_high, hash_low);
};

struct FrameStep {
  int line = 0;             // of the method's pseudocode, counted from 0
  bool has_volume = false;  // whether the first body's volume is measured
  fit::Volume3 volume;      // that volume, in the world frame
  std::variant<FrameTaken> fact;
};

}  // namespace snug::lesson
