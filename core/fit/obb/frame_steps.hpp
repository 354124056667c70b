// What is said of a frame of a moving scene: of its pairs, which stage told them apart; of its volumes, what they cost.
#pragma once

#include <string_view>
#include <variant>

namespace snug::fit {

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
  void fields(auto&& see) const {
    see("frame", frame), see("all_pairs", all_pairs), see("compared", compared), see("after_broad", after_broad),
        see("after_loose", after_loose);
    see("touching", touching), see("slack", slack), see("cost", cost), see("energy", energy), see("resting", resting);
    see("hash_high", hash_high), see("hash_low", hash_low);
  }
};

struct FrameStep {
  using Fact = std::variant<FrameTaken>;
};

}  // namespace snug::fit
