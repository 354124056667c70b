#include "measure/census.hpp"

#include <algorithm>

#include "fit/catalogue.hpp"
#include "geometry/generate.hpp"

namespace snug::cost {
namespace {

double ratio_of(const AnyPointSet& points) {
  const auto measure = [&](std::string_view volume, std::string_view algorithm) {
    return fit::measure_of(fit::find_algorithm(volume, algorithm)->fit(points, {}).volume, 3);
  };
  return measure("kdop", "k14") / measure("obb", "exact");
}

std::vector<CensusRow> counted_clouds() {
  std::vector<CensusRow> rows;
  for (const std::string_view kind : {"cube", "ball", "gaussian", "clusters", "stick"}) {
    CensusRow& row = rows.emplace_back(CensusRow{kind, {}});
    for (std::uint64_t seed = 1; seed <= kCensusClouds; ++seed)
      row.ratios.push_back(ratio_of(*PointSet<double, 3>::make(*generate(kind, kCensusPoints, 3, seed))));
  }
  return rows;
}

}  // namespace

int CensusRow::tighter() const {
  return static_cast<int>(std::count_if(ratios.begin(), ratios.end(), [](double ratio) { return ratio < 1; }));
}

const std::vector<CensusRow>& census() {
  static const std::vector<CensusRow> rows = counted_clouds();
  return rows;
}

}  // namespace snug::cost
