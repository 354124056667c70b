// What accuracy costs, as charts: from the tables that core/measure makes.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/chart.hpp"
#include "measure/report.hpp"

namespace snug::app {

/// Accuracy against time, a mark an algorithm, with the front that none undercuts. then: an earlier result that lies
/// over it; null for none. Rows of more than one volume are compared by the hull's measure, of one by the smallest of
/// its kind.
[[nodiscard]] Chart cost_chart(const cost::Table<cost::CostRow>& now, const cost::Table<cost::CostRow>* then = nullptr);

/// Time against the number of points, a line an algorithm, with the fitted power beside theory's.
[[nodiscard]] Chart growth_chart(const cost::Table<cost::GrowthRow>& now,
                                 const cost::Table<cost::GrowthRow>* then = nullptr);

/// Slack over a full turn, a line an update; those that are always tight are one.
[[nodiscard]] Chart turn_chart(const cost::Table<cost::TurnRow>& now, const cost::Table<cost::TurnRow>* then = nullptr);

/// The rows of one algorithm, or of one update, as they follow each other: a chart's line.
[[nodiscard]] std::vector<std::span<const cost::GrowthRow>> lines_of(const std::vector<cost::GrowthRow>& rows);
[[nodiscard]] std::vector<std::span<const cost::TurnRow>> lines_of(const std::vector<cost::TurnRow>& rows);
/// Whether the line is measured to its end, and its power was looked for.
[[nodiscard]] bool is_fitted(std::span<const cost::GrowthRow> line);
/// Whether the update's volume is the tightest of its kind at every angle.
[[nodiscard]] bool always_tight(std::span<const cost::TurnRow> line);

/// As people say them: "PCA of the points", "AABB, hill climbing". What there is none of by that name keeps it.
[[nodiscard]] std::string algorithm_title(std::string_view volume, std::string_view algorithm);
[[nodiscard]] std::string update_title(std::string_view volume, std::string_view strategy);
/// "theory 1.00", or of what is a mere bound "theory at most 2.00"; empty where there is none.
[[nodiscard]] std::string theory_words(const cost::GrowthRow& row);

}  // namespace snug::app
