#include "measure/trials.hpp"

#include <algorithm>
#include <array>

#include "geometry/generate.hpp"

namespace snug::cost {
namespace {

constexpr std::array<std::string_view, 6> kTrialKinds{"cube", "ball", "sphere", "gaussian", "clusters", "stick"};
constexpr int kTrialClouds = kTrialSeeds * static_cast<int>(kTrialKinds.size());

}  // namespace

std::span<const std::string_view> trial_kinds() { return kTrialKinds; }

AnyPointSet trial_cloud(std::string_view kind, Index points, std::int64_t seed) {
  // Finite, for the kind is one of trial_kinds().
  return *PointSet<double, 3>::make(*generate(kind, points, 3, static_cast<std::uint64_t>(seed)));
}

TrialRow trial_of(const Claim& claim, std::string_view kind, Index points, std::int64_t seed) {
  TrialRow row{.claim = std::string(claim.name), .kind = std::string(kind), .seed = seed, .points = points};
  row.value = claim.measure(claim, trial_cloud(kind, points, seed), static_cast<std::uint64_t>(seed));
  row.holds = row.value <= claim.limit;
  return row;
}

std::string_view TrialTally::verdict() const {
  if (clouds == 0) return "unknown";
  if (held == clouds) return "holds";
  return 2 * held > clouds ? "typical" : "false";
}

TrialTally tally_trials(std::string_view claim, std::span<const TrialRow> rows) {
  TrialTally tally;
  for (const TrialRow& row : rows) {
    if (row.claim != claim) continue;
    ++tally.clouds;
    if (row.holds) ++tally.held;
    else if (!tally.worst || row.value > tally.worst->value) tally.worst = row;
  }
  return tally;
}

const std::vector<TrialRow>& all_trials() {
  static const std::vector<TrialRow> rows = [] {
    TrialRun run(tried_claims());
    while (!run.done()) run.step();
    return run.rows();
  }();
  return rows;
}

int CensusRow::tighter() const {
  return static_cast<int>(std::count_if(ratios.begin(), ratios.end(), [](double ratio) { return ratio < 1; }));
}

const std::vector<CensusRow>& census() {
  static const std::vector<CensusRow> rows = [] {
    std::vector<CensusRow> counted;
    for (const std::string_view kind : kTrialKinds) {
      if (kind == "sphere") continue;
      CensusRow& row = counted.emplace_back(CensusRow{kind, {}});
      for (int seed = 1; seed <= kTrialSeeds; ++seed)
        row.ratios.push_back(trial_of(*find_trial("kdop_tighter"), kind, kCensusPoints, seed).value);
    }
    return counted;
  }();
  return rows;
}

void TrialRun::step() {
  if (done()) return;
  const Claim& claim = *claims_[at_];
  rows_.push_back(trial_of(claim, kTrialKinds[cloud_ / kTrialSeeds], claim.points, 1 + cloud_ % kTrialSeeds));
  if (++cloud_ < kTrialClouds) return;
  cloud_ = 0;
  ++at_;
}

double TrialRun::progress() const {
  const auto all = static_cast<double>(claims_.size() * static_cast<std::size_t>(kTrialClouds));
  return done() ? 1 : (static_cast<double>(at_) * kTrialClouds + cloud_) / all;
}

}  // namespace snug::cost
