#include "desktop/chart_file.hpp"

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>

#include "app/subjects/claims/trial_chart.hpp"
#include "app/subjects/cost/charts.hpp"
#include "desktop/cli/cost_file.hpp"
#include "desktop/cli/files.hpp"

namespace snug::desktop {
namespace {

template <class Row>
tl::expected<app::Chart, InputError> chart_of(const std::string& text, const std::string& path, const std::string& then,
                                              app::Chart (*draw)(const cost::Table<Row>&, const cost::Table<Row>*)) {
  const auto now = read_table<Row>(text, path);
  if (!now) return tl::unexpected(now.error());
  std::optional<cost::Table<Row>> before;
  if (!then.empty()) {
    auto table = read_file(then).and_then([&](const std::string& earlier) { return read_table<Row>(earlier, then); });
    if (!table) return tl::unexpected(table.error());
    constexpr bool kAnyNumber = std::is_same_v<Row, cost::GrowthRow>;
    if (auto other = of_other_points(now->provenance, table->provenance, then, kAnyNumber))
      return tl::unexpected(std::move(*other));
    before = std::move(*table);
  }
  app::Chart chart = draw(*now, before ? &*before : nullptr);
  if (chart.looks > app::kChartLooks)
    return tl::unexpected(InputError{.what = "has " + std::to_string(chart.looks) + " series, and a chart can tell " +
                                             std::to_string(app::kChartLooks) +
                                             " apart: choose with --volume or --algorithms of snug cost",
                                     .file = path});
  return chart;
}

/// The chart of the claim that the table is about.
tl::expected<app::Chart, InputError> chart_of_trials(const std::string& text, const std::string& path,
                                                     const std::string& then) {
  const auto wrong = [&](std::string what) {
    return tl::unexpected(InputError{.what = std::move(what), .file = path});
  };
  const auto table = read_table<cost::TrialRow>(text, path);
  if (!table) return tl::unexpected(table.error());
  if (!then.empty()) return wrong("is a table of trials, which are the same everywhere: --against has no use for it");
  if (table->rows.empty()) return wrong("has no rows");
  const std::string& name = table->rows.front().claim;
  const cost::Claim* const claim = cost::find_trial(name);
  if (claim == nullptr) return wrong("is about a claim that is not known here: " + name);
  for (const cost::TrialRow& row : table->rows) {
    const auto kinds = cost::trial_kinds();
    if (row.claim != name) return wrong("is about more than one claim: choose one with --trials of snug cost");
    if (std::find(kinds.begin(), kinds.end(), row.kind) == kinds.end())
      return wrong("has a kind of clouds that is not known here: " + row.kind);
    if (!(row.value > 0)) return wrong("has a value that is not above 0");
  }
  return app::trial_chart(*claim, table->rows);
}

}  // namespace

tl::expected<app::Chart, InputError> read_chart(const std::string& path, const std::string& then) {
  const auto text = read_file(path);
  if (!text) return tl::unexpected(text.error());
  const std::string table = table_name(*text);
  if (table == cost::GrowthRow::kTable) return chart_of<cost::GrowthRow>(*text, path, then, app::growth_chart);
  if (table == cost::TurnRow::kTable) return chart_of<cost::TurnRow>(*text, path, then, app::turn_chart);
  if (table == cost::TrialRow::kTable) return chart_of_trials(*text, path, then);
  return chart_of<cost::CostRow>(*text, path, then, app::cost_chart);
}

}  // namespace snug::desktop
