// The tables that `snug cost` prints for people, with units.
#pragma once

#include <span>
#include <string>

#include "measure/report.hpp"
#include "measure/trials.hpp"

namespace snug::desktop {

/// A time with three digits and a suitable unit.
[[nodiscard]] std::string time_text(double ns);

/// then: an earlier result to compare with; empty if there is none.
[[nodiscard]] std::string text_of(const cost::Provenance& provenance, std::span<const cost::CostRow> rows,
                                  const cost::Table<cost::CostRow>* then);
[[nodiscard]] std::string text_of(const cost::Provenance& provenance, std::span<const cost::GrowthRow> rows);
[[nodiscard]] std::string text_of(const cost::Provenance& provenance, std::span<const cost::TurnRow> rows);
[[nodiscard]] std::string text_of(const cost::Provenance& provenance, std::span<const cost::ClaimRow> rows);
[[nodiscard]] std::string text_of(const cost::Provenance& provenance, std::span<const cost::WhichRow> rows);
[[nodiscard]] std::string text_of(const cost::Provenance& provenance, std::span<const cost::TrialRow> rows);

}  // namespace snug::desktop
