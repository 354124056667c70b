#include "measure/load.hpp"

#include <algorithm>

namespace snug::cost {
namespace {

double build_of(const CriteriaRow& row) { return row.costs.whole_ns.value_or(row.costs.time.median); }

}  // namespace

std::optional<TotalCost> total_of(std::span<const CriteriaRow> rows, std::size_t row, const Load& load) {
  const auto hull = std::find_if(rows.begin(), rows.end(), [](const auto& one) { return one.costs.volume == "hull"; });
  if (row >= rows.size() || hull == rows.end()) return std::nullopt;
  const CriteriaRow& own = rows[row];
  const double tests = load.frames * load.pairs;
  return TotalCost{
      load.bodies * build_of(own), load.frames * load.updates * (load.deforms ? build_of(own) : own.update.median),
      tests * own.costs.overlap.median, tests * (1 - load.hit_rate) * own.passes.rate() * hull->costs.overlap.median};
}

std::vector<WhichRow> which_rows(std::span<const CriteriaRow> rows, const Load& load) {
  std::vector<WhichRow> table;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& [costs, update, passes] = rows[i];
    WhichRow& row = table.emplace_back(WhichRow{.volume = costs.volume,
                                                .algorithm = costs.algorithm,
                                                .points = costs.points,
                                                .of = costs.of,
                                                .test = costs.overlap,
                                                .build = costs.time,
                                                .whole_ns = costs.whole_ns,
                                                .update = update,
                                                .over_hull = costs.over_hull,
                                                .bytes = costs.bytes,
                                                .pairs_apart = passes.apart,
                                                .passed = passes.passed,
                                                .false_positives = passes.rate(),
                                                .bodies = load.bodies,
                                                .frames = load.frames,
                                                .updates = load.updates,
                                                .pairs = load.pairs,
                                                .hit_rate = load.hit_rate,
                                                .deforms = load.deforms});
    const auto total = total_of(rows, i, load);
    if (!total) continue;
    row.total_build = total->build;
    row.total_updates = total->updates;
    row.total_tests = total->tests;
    row.total_false_positives = total->false_positives;
    row.total = total->sum();
  }
  return table;
}

}  // namespace snug::cost
