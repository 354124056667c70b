#include "app/subjects/claims/trial_chart.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/sort.hpp"

namespace snug::app {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kKindTitles{{{"cube", "in a cube"},
                                                                                    {"ball", "in a sphere"},
                                                                                    {"sphere", "on a sphere"},
                                                                                    {"gaussian", "Gaussian"},
                                                                                    {"clusters", "clusters"},
                                                                                    {"stick", "stick"}}};

ChartSeries trial_series(const cost::Claim& claim, std::span<const cost::TrialRow> rows, int line) {
  const auto own = trials_of_line(claim, rows, line);
  ChartSeries series{.shape = static_cast<ChartShape>(line), .role = ChartRole::kChosen, .line = true, .row = line};
  const auto held = std::count_if(own.begin(), own.end(), [](const cost::TrialRow* row) { return row->holds; });
  series.name = kind_title(cost::trial_kinds()[line]);
  series.figure = std::to_string(held) + " of " + std::to_string(own.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(own.size());
    series.points.push_back({share, own[i]->value, share, share});
    series.names.push_back("cloud " + std::to_string(own[i]->seed) + (own[i]->holds ? ", holds" : ", does not hold"));
  }
  return series;
}

}  // namespace

std::string_view kind_title(std::string_view kind) {
  for (const auto& [name, title] : kKindTitles)
    if (name == kind) return title;
  return kind;
}

std::vector<const cost::TrialRow*> trials_of_line(const cost::Claim& claim, std::span<const cost::TrialRow> rows,
                                                  int line) {
  std::vector<const cost::TrialRow*> own;
  const std::string_view kind = cost::trial_kinds()[line];
  for (const cost::TrialRow& row : rows)
    if (row.claim == claim.name && row.kind == kind) own.push_back(&row);
  sort_stably(own, [](const cost::TrialRow* a, const cost::TrialRow* b) { return a->value < b->value; });
  return own;
}

Chart trial_chart(const cost::Claim& claim, std::span<const cost::TrialRow> rows) {
  Chart chart{.title = std::string(claim.says),
              .note = std::string(claim.lecture) + ", “" + std::string(claim.slide) + "”. " +
                      std::to_string(cost::kTrialSeeds) + " clouds of each kind, " + std::to_string(claim.points) +
                      " points each. Beside each name: on how many of them the claim holds.",
              .x = {"clouds of a kind, by rising value", ChartUnit::kPercent},
              .y = {std::string(claim.value), ChartUnit::kRatio, true},
              .limit = claim.limit,
              .limit_name = "claimed: " + std::string(claim.claimed)};
  const int kinds = static_cast<int>(cost::trial_kinds().size());
  for (int line = 0; line < kinds; ++line)
    if (ChartSeries series = trial_series(claim, rows, line); !series.points.empty())
      chart.series.push_back(std::move(series));
  chart.looks = static_cast<int>(chart.series.size());
  return chart;
}

}  // namespace snug::app
