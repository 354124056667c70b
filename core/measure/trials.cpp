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

const TrialClaim* find_trial(std::string_view name) {
  for (const TrialClaim& claim : trial_claims())
    if (claim.name == name) return &claim;
  return nullptr;
}

AnyPointSet trial_cloud(std::string_view kind, Index points, std::int64_t seed) {
  // Finite, for the kind is one of trial_kinds().
  return *PointSet<double, 3>::make(*generate(kind, points, 3, static_cast<std::uint64_t>(seed)));
}

std::string_view TrialTally::verdict() const {
  if (clouds == 0) return "unknown";
  return held == clouds ? "holds" : 2 * held > clouds ? "typical" : "false";
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

std::vector<const TrialClaim*> every_trial() {
  std::vector<const TrialClaim*> claims;
  for (const TrialClaim& claim : trial_claims()) claims.push_back(&claim);
  return claims;
}

const std::vector<TrialRow>& all_trials() {
  static const std::vector<TrialRow> rows = [] {
    TrialRun run(every_trial());
    while (!run.done()) run.step();
    return run.rows();
  }();
  return rows;
}

void TrialRun::step() {
  if (done()) return;
  const TrialClaim& claim = *claims_[at_];
  const std::string_view kind = kTrialKinds[cloud_ / kTrialSeeds];
  TrialRow row{.claim = std::string(claim.name),
               .kind = std::string(kind),
               .seed = 1 + cloud_ % kTrialSeeds,
               .points = claim.points};
  row.value = claim.measure(trial_cloud(kind, claim.points, row.seed), static_cast<std::uint64_t>(row.seed));
  row.holds = row.value <= claim.limit;
  rows_.push_back(std::move(row));
  if (++cloud_ == kTrialClouds) cloud_ = 0, ++at_;
}

double TrialRun::progress() const {
  const auto all = static_cast<double>(claims_.size() * static_cast<std::size_t>(kTrialClouds));
  return done() ? 1 : (static_cast<double>(at_) * kTrialClouds + cloud_) / all;
}

}  // namespace snug::cost
