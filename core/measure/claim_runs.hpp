// Lectures' claims (claims.hpp), each measured once, on the student's points and on others that are generated.
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

struct MeasuredClaim {
  std::string_view name;  // of claims()
  /// Sets what was measured, the figure and the verdict: "holds", "typical" (but not a bound) or "false". The verdict
  /// stays "unknown" if this machine is too slow to tell.
  void (*run)(const ClaimContext& context, ClaimRow& row);
};

[[nodiscard]] std::span<const MeasuredClaim> measured_claims();
[[nodiscard]] ClaimRow run_claim(const MeasuredClaim& claim, const ClaimContext& context);

}  // namespace snug::cost
