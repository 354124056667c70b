// The two lectures' claims about time, storage and tightness, and what this program measures: one run for each.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "fit/catalogue.hpp"
#include "measure/rows.hpp"

namespace snug::cost {

struct ClaimContext {
  const AnyPointSet& points;  // the student's, in 3-D; measured beside the clouds that every run generates
  std::uint64_t seed = 1;
  Clock clock;
  double longest = 2e8;  // the longest timed run, ns
};

struct Claim {
  std::string_view name, lecture, slide;
  std::string_view says;  // in our words
  /// Sets what was measured, the figure and the verdict: "holds", "typical" (but not a bound) or "false". The verdict
  /// stays "unknown" if this machine is too slow to tell.
  void (*run)(const ClaimContext& context, ClaimRow& row);
};

[[nodiscard]] std::span<const Claim> claims();
[[nodiscard]] ClaimRow run_claim(const Claim& claim, const ClaimContext& context);

}  // namespace snug::cost
