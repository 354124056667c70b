// The sentences below a cost chart.
#pragma once

#include <string>

#include "measure/report.hpp"

namespace snug::app {

/// all: 0 if it is not mentioned.
[[nodiscard]] std::string measuring_caption(int done, int all);
/// The sentences of one row, and of all rows.
[[nodiscard]] std::string accuracy_caption(const cost::Table<cost::CostRow>& table, const cost::CostRow& row);
[[nodiscard]] std::string accuracy_caption(const cost::Table<cost::CostRow>& table);
/// The sentences of a point on a line, and of all lines. longest: what one run may take, ns.
[[nodiscard]] std::string growth_caption(const cost::Table<cost::GrowthRow>& table, int line, std::size_t point);
[[nodiscard]] std::string growth_caption(const cost::Table<cost::GrowthRow>& table, double longest);
[[nodiscard]] std::string turn_caption(const cost::Table<cost::TurnRow>& table, int line, std::size_t point);
[[nodiscard]] std::string turn_caption(const cost::Table<cost::TurnRow>& table);

}  // namespace snug::app
