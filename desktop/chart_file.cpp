#include "desktop/chart_file.hpp"

#include "app/cost_charts.hpp"
#include "desktop/cli/cost_file.hpp"
#include "desktop/cli/files.hpp"

namespace snug::desktop {
namespace {

template <class Row>
tl::expected<app::Chart, InputError> chart_of(const std::string& path, const std::string& then,
                                              app::Chart (*draw)(const cost::Table<Row>&, const cost::Table<Row>*)) {
  const auto now = read_table<Row>(path);
  if (!now) return tl::unexpected(now.error());
  if (then.empty()) return draw(*now, nullptr);
  const auto before = read_table<Row>(then);
  if (!before) return tl::unexpected(before.error());
  return draw(*now, &*before);
}

}  // namespace

tl::expected<app::Chart, InputError> read_chart(const std::string& path, const std::string& then) {
  const auto text = read_file(path);
  if (!text) return tl::unexpected(text.error());
  const std::string table = table_name(*text);
  if (table == cost::GrowthRow::kTable) return chart_of<cost::GrowthRow>(path, then, app::growth_chart);
  if (table == cost::TurnRow::kTable) return chart_of<cost::TurnRow>(path, then, app::turn_chart);
  return chart_of<cost::CostRow>(path, then, app::cost_chart);
}

}  // namespace snug::desktop
