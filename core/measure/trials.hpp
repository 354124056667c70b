// A claim of the lectures, tried on hundreds of clouds: a number for each cloud, and whether the claim holds there. All
// numbers are sizes or counted operations, so that they are the same on every machine.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "measure/claims.hpp"
#include "measure/rows.hpp"

namespace snug::cost {

/// One cloud of a claim.
struct TrialRow {
  static constexpr std::string_view kTable = "trials";
  std::string claim, kind;  // the claim's name; of generator_kinds()
  std::int64_t seed = 1;    // of the cloud
  Index points = 0;
  double value = 0;    // the ratio that the claim is about, on this cloud
  bool holds = false;  // whether it holds there
  void fields(auto&& see) { SNUG_SEE(see, claim, kind, seed, points, value, holds); }
};

/// How many clouds of each kind a claim is tried on, with the seeds from 1, and the kinds.
inline constexpr int kTrialSeeds = 40;
[[nodiscard]] std::span<const std::string_view> trial_kinds();
[[nodiscard]] AnyPointSet trial_cloud(std::string_view kind, Index points, std::int64_t seed);
/// A claim on one cloud.
[[nodiscard]] TrialRow trial_of(const Claim& claim, std::string_view kind, Index points, std::int64_t seed);

/// What came of a claim's clouds.
struct TrialTally {
  int clouds = 0, held = 0;
  std::optional<TrialRow> worst;  // that of the greatest value, if the claim does not hold there
  /// "holds": on every cloud; "typical": on more than half; "false"; "unknown" if there are no clouds.
  [[nodiscard]] std::string_view verdict() const;
};
[[nodiscard]] TrialTally tally_trials(std::string_view claim, std::span<const TrialRow> rows);

/// All of the claims on all of their clouds: computed once, when first needed, in about a second.
[[nodiscard]] const std::vector<TrialRow>& all_trials();

/// How often a 14-DOP is tighter than an oriented box, on the clouds of one kind.
struct CensusRow {
  std::string_view kind;              // of trial_kinds()
  std::vector<double> ratios;         // the 14-DOP's volume over the smallest box's, a number for each cloud
  [[nodiscard]] int tighter() const;  // in how many the 14-DOP is the smaller one
};
inline constexpr int kCensusPoints = 30;  // in each cloud
/// The trials of "kdop_tighter" on clouds of kCensusPoints, of all kinds but the surface of a sphere: always the same
/// numbers. Takes about a quarter of a millisecond for each cloud.
[[nodiscard]] const std::vector<CensusRow>& census();

/// Tries claims on all clouds, one cloud after the other (see cost::advance).
class TrialRun {
 public:
  explicit TrialRun(std::vector<const Claim*> claims) : claims_(std::move(claims)) {}

  void step();
  [[nodiscard]] bool done() const { return at_ == claims_.size(); }
  [[nodiscard]] double progress() const;
  void stop() { at_ = claims_.size(); }
  [[nodiscard]] const std::vector<TrialRow>& rows() const { return rows_; }

 private:
  std::vector<const Claim*> claims_;
  std::size_t at_ = 0;  // of claims_
  int cloud_ = 0;
  std::vector<TrialRow> rows_;
};

}  // namespace snug::cost
