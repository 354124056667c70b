// How often a 14-DOP is tighter than an oriented box: counted over many random clouds.
#pragma once

#include <string_view>
#include <vector>

namespace snug::cost {

/// The clouds of one kind.
struct CensusRow {
  std::string_view kind;              // of generator_kinds()
  std::vector<double> ratios;         // the 14-DOP's volume over the smallest box's, a number for each cloud
  [[nodiscard]] int tighter() const;  // in how many the 14-DOP is the smaller one
};

inline constexpr int kCensusClouds = 40, kCensusPoints = 30;  // of each kind; in each cloud

/// Five kinds of clouds in space, with the seeds 1 to kCensusClouds: always the same numbers. Takes about a quarter of
/// a millisecond for each cloud.
[[nodiscard]] const std::vector<CensusRow>& census();

}  // namespace snug::cost
