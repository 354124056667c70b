// What the two lectures claim of time, storage and tightness, and what this program measures of it: each claim a run.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "fit/catalogue.hpp"
#include "measure/rows.hpp"

namespace snug::cost {

struct ClaimContext {
  const AnyPointSet& points;  // of the student, in 3-D: looked at beside the clouds that every run makes
  std::uint64_t seed = 1;
  Clock clock;
  double longest = 2e8;  // of one run where times are taken, ns
};

struct Claim {
  std::string_view name, lecture, slide;
  std::string_view says;  // in our words
  /// Sets what was measured, the figure and the verdict: "holds", "typical" (but no bound), "false"; "unknown" stays
  /// where this machine is too slow to tell.
  void (*run)(const ClaimContext& context, ClaimRow& row);
};

[[nodiscard]] std::span<const Claim> claims();
[[nodiscard]] ClaimRow run_claim(const Claim& claim, const ClaimContext& context);

}  // namespace snug::cost
