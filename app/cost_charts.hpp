// What accuracy costs, as charts: from the tables that core/measure makes.
#pragma once

#include <span>

#include "app/chart.hpp"
#include "measure/report.hpp"

namespace snug::app {

/// Accuracy against time, a mark an algorithm, with the front that none undercuts. then: an earlier result that lies
/// over it; null for none. Rows of more than one volume are compared by the hull's measure, of one by the smallest of
/// its kind.
[[nodiscard]] Chart cost_chart(const cost::Table<cost::CostRow>& now, const cost::Table<cost::CostRow>* then = nullptr);

/// Time against the number of points, with the fitted power and theory's in the name.
[[nodiscard]] Chart growth_chart(const cost::Table<cost::GrowthRow>& now,
                                 const cost::Table<cost::GrowthRow>* then = nullptr);

/// Slack over a full turn.
[[nodiscard]] Chart turn_chart(const cost::Table<cost::TurnRow>& now, const cost::Table<cost::TurnRow>* then = nullptr);

}  // namespace snug::app
