// A claim that was tried on hundreds of clouds, as a chart: a line for each kind of cloud, its clouds by rising value,
// beside the value that is claimed.
#pragma once

#include <span>

#include "app/chart.hpp"
#include "measure/report.hpp"
#include "measure/trials.hpp"

namespace snug::app {

/// rows: those of any claims, of which the claim's own are shown. With none of them, an empty chart.
[[nodiscard]] Chart trial_chart(const cost::Claim& claim, std::span<const cost::TrialRow> rows);

/// The rows of one line of the chart, in the order of its points. line: the series' row.
[[nodiscard]] std::vector<const cost::TrialRow*> trials_of_line(const cost::Claim& claim,
                                                                std::span<const cost::TrialRow> rows, int line);

/// A kind of cloud in words: "sphere’s surface" for "sphere".
[[nodiscard]] std::string_view kind_title(std::string_view kind);

}  // namespace snug::app
