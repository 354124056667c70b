// Turns the tables of core/measure into charts of what accuracy costs.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/chart.hpp"
#include "measure/report.hpp"

namespace snug::app {

/// Accuracy against time, with a mark for each algorithm and the Pareto front. then: an earlier result to show over it;
/// null for none. Rows of more than one kind of volume are compared with the hull, those of one kind with the smallest
/// of its kind.
[[nodiscard]] Chart cost_chart(const cost::Table<cost::CostRow>& now, const cost::Table<cost::CostRow>* then = nullptr);

/// Time against the number of points, with a line for each algorithm, and the fitted power compared with the theory's.
[[nodiscard]] Chart growth_chart(const cost::Table<cost::GrowthRow>& now,
                                 const cost::Table<cost::GrowthRow>* then = nullptr);

/// Looseness over a full turn, with a line for each update; the updates that are always tight share one.
[[nodiscard]] Chart turn_chart(const cost::Table<cost::TurnRow>& now, const cost::Table<cost::TurnRow>* then = nullptr);

/// The rows of each algorithm, or of each update, which are consecutive: one line of the chart each.
[[nodiscard]] std::vector<std::span<const cost::GrowthRow>> lines_of(const std::vector<cost::GrowthRow>& rows);
[[nodiscard]] std::vector<std::span<const cost::TurnRow>> lines_of(const std::vector<cost::TurnRow>& rows);
/// Whether the line is measured to its end, so that its power was fitted.
[[nodiscard]] bool is_fitted(std::span<const cost::GrowthRow> line);
/// Whether the update's volume is the tightest of its kind at every angle.
[[nodiscard]] bool always_tight(std::span<const cost::TurnRow> line);

/// What the chart of accuracy says about one of its rows, for words beside the chart.
struct AccuracyWords {
  std::string title;           // with its volume, where the chart has several
  std::optional<double> size;  // its height on the chart
  std::string_view against;    // what that is a multiple of: "the smallest", "the hull", "the smallest found"
};
[[nodiscard]] AccuracyWords accuracy_words(const std::vector<cost::CostRow>& rows, const cost::CostRow& row);
/// The title of a line of the chart of growth, in the same way.
[[nodiscard]] std::string growth_title(const std::vector<cost::GrowthRow>& rows, const cost::GrowthRow& row);
/// Which lines end at their own limit: " Welzl, recursive ends at 1,023 points, its own limit."; empty if none does.
[[nodiscard]] std::string own_limits(const std::vector<cost::GrowthRow>& rows);
/// What the sizes of a whole table are multiples of.
[[nodiscard]] std::string_view accuracy_against(const std::vector<cost::CostRow>& rows);

/// Titles for people: "PCA of the points", "AABB by hill climbing". An unknown name is returned as it is.
[[nodiscard]] std::string algorithm_title(std::string_view volume, std::string_view algorithm);
[[nodiscard]] std::string update_title(std::string_view volume, std::string_view strategy);
/// "theory 1.00", or for an upper bound "theory at most 2.00"; empty if there is none.
[[nodiscard]] std::string theory_words(const cost::GrowthRow& row);

}  // namespace snug::app
