// The claims of two lectures about time, storage and tightness. trials.hpp tries one on hundreds of clouds, and
// claim_runs.hpp measures one on a student's points; some have both.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "fit/catalogue.hpp"

namespace snug::cost {

struct Claim {
  std::string_view name, lecture, slide;
  std::string_view says;  // in our words
  // What follows is empty where it is not tried on clouds.
  std::string_view title = {};                // two or three words
  std::string_view value = {};                // what is measured on each cloud: a ratio
  std::string_view claimed = {};              // the limit in words: "at most 10 % larger"
  double limit = 0;                           // it holds on a cloud if the value is no greater
  std::string_view volume = {}, algorithm{};  // what shows a counter-example
  Index points = 0;                           // in each cloud
  /// The value on one cloud; null if it is not tried.
  double (*measure)(const Claim& claim, const AnyPointSet& points, std::uint64_t seed) = nullptr;
};

[[nodiscard]] std::span<const Claim> claims();
/// Null if there is none of that name.
[[nodiscard]] const Claim* find_claim(std::string_view name);

/// Those that are tried on clouds.
[[nodiscard]] const std::vector<const Claim*>& tried_claims();
/// Null if none of that name is tried.
[[nodiscard]] const Claim* find_trial(std::string_view name);

}  // namespace snug::cost
