// What is said of a frame of a moving scene: of its pairs, which stage told them apart; of its volumes, what they cost.
#pragma once

#include <array>
#include <string_view>
#include <tuple>
#include <variant>

#include "fit/any_step.hpp"

namespace snug::lesson {

/// A frame was taken. Pairs count bodies two by two: all there are, those whose boxes overlap, those whose loose
/// volumes do, those that touch.
struct FrameTaken {
  static constexpr std::string_view kName = "frame_taken";
  int frame = 0;  // counted from 1
  double all_pairs = 0, compared = 0, after_broad = 0, after_loose = 0, touching = 0;
  double slack = 0;      // of the updated volumes together, over the tightest of their kind: 0.5 is half as much again
  double cost = 0;       // points that the updates looked at
  double energy = 0;     // of all bodies that move: kinetic and in the field of gravity, kg (scene units / s)^2
  bool resting = false;  // nothing moved and nothing will
  int hash_high = 0, hash_low = 0;  // of the state, to the last bit
  static constexpr std::array<std::string_view, 12> kFields{"frame",       "all_pairs", "compared",  "after_broad",
                                                            "after_loose", "touching",  "slack",     "cost",
                                                            "energy",      "resting",   "hash_high", "hash_low"};
  static auto tie(auto& own) {
    return std::tie(own.frame, own.all_pairs, own.compared, own.after_broad, own.after_loose, own.touching, own.slack,
                    own.cost, own.energy, own.resting, own.hash_high, own.hash_low);
  }
};

struct FrameStep {
  int line = 0;             // of the method's pseudocode, counted from 0
  bool has_volume = false;  // whether the first body's volume is measured
  fit::Volume3 volume;      // that, in the world
  std::variant<FrameTaken> fact;
};

}  // namespace snug::lesson
