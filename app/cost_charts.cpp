#include "app/cost_charts.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <limits>
#include <string_view>
#include <utility>

#include "fit/catalogue.hpp"

namespace snug::app {
namespace {

std::string said(const char* format, double value) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

/// Shapes go round, in the order of the names: what is told apart by its shape keeps its colour for what it means.
ChartShape shape_of(std::size_t i) { return static_cast<ChartShape>(i % kChartShapes); }

std::string title_of(const char* what, const cost::Provenance& p) { return std::string(what) + p.points; }

std::string note_of(const cost::Provenance& p) {
  return p.scalar + ", seed " + std::to_string(p.seed) + "; " + p.platform + ", " + p.build +
         (p.processor.empty() ? "" : ", " + p.processor);
}

bool of_one_volume(const std::vector<cost::CostRow>& rows) {
  return std::all_of(rows.begin(), rows.end(), [&](const cost::CostRow& row) { return row.volume == rows[0].volume; });
}

/// "OBB", "Sphere"
std::string heading_of(const std::string& volume) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kShort{{{"obb", "OBB"}, {"aabb", "AABB"}, {"kdop", "k-DOP"}}};
  for (const auto& [name, text] : kShort)
    if (name == volume) return std::string(text);
  return static_cast<char>(std::toupper(static_cast<unsigned char>(volume[0]))) + volume.substr(1);
}

/// Half of the spread to either side.
ChartPoint point_of(const cost::Timing& time, double y) {
  return {time.median, y, time.median * (1 - std::min(time.spread, 1.8) / 2), time.median * (1 + time.spread / 2)};
}

/// What a size is held against: the smallest of its kind, the hull, or the smallest that there is in the table.
enum class Against : std::uint8_t { kSmallest, kHull, kFound };

struct CostLook {
  bool one;  // volume
  Against against;
  double found;  // the smallest measure of a row
  [[nodiscard]] std::optional<double> y(const cost::CostRow& row) const {
    if (against == Against::kFound) return row.measure / found;
    return against == Against::kSmallest ? row.tightness : row.over_hull;
  }
  [[nodiscard]] std::string name(const cost::CostRow& row) const {
    if (!one) return row.volume + " " + row.algorithm;
    const fit::Algorithm* algorithm = fit::find_algorithm(row.volume, row.algorithm);
    return algorithm != nullptr ? std::string(algorithm->title) : row.algorithm;
  }
};

/// What is known of every row: where a run takes too long, the exact one is known of few of the points alone.
CostLook look_of(const std::vector<cost::CostRow>& rows) {
  const auto all = [&](auto known) { return std::all_of(rows.begin(), rows.end(), known); };
  CostLook look{of_one_volume(rows), Against::kFound, std::numeric_limits<double>::infinity()};
  for (const cost::CostRow& row : rows)
    if (row.measure > 0 && row.points == row.of) look.found = std::min(look.found, row.measure);
  if (look.one && all([](const cost::CostRow& row) { return row.tightness.has_value(); })) look.against = Against::kSmallest;
  else if (!look.one || all([](const cost::CostRow& row) { return row.over_hull.has_value(); })) look.against = Against::kHull;
  return look;
}

void add_costs(Chart& chart, const std::vector<cost::CostRow>& rows, const CostLook& look, bool then) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const cost::CostRow& row = rows[i];
    const auto y = look.y(row);
    if (!y || !(*y > 0) || !(row.time.median > 0)) continue;
    ChartSeries series{.name = then ? "" : look.name(row),
                       .shape = shape_of(i),
                       .hollow = row.points < row.of || !row.time.trusted,
                       .points = {point_of(row.time, *y)},
                       .row = then ? -1 : static_cast<int>(i)};
    if (then)
      series.role = ChartRole::kThen;
    else if (look.against == Against::kSmallest && *y <= 1)
      series.role = ChartRole::kExact;
    else if (row.on_front)
      series.role = ChartRole::kChosen;
    if (row.points < row.of && !then) series.name += " (" + std::to_string(row.points) + " points)";
    if (row.on_front && !then) chart.front.push_back(series.points[0]);
    chart.series.push_back(std::move(series));
  }
}

/// A row's key tells one line from the next.
template <class Row, class Key, class Add>
void each_line(const std::vector<Row>& rows, Key key, Add add) {
  for (std::size_t first = 0, line = 0; first < rows.size(); ++line) {
    std::size_t end = first;
    while (end < rows.size() && key(rows[end]) == key(rows[first]))
      ++end;
    add(line, std::span(rows).subspan(first, end - first));
    first = end;
  }
}

void add_growth(Chart& chart, const std::vector<cost::GrowthRow>& rows, bool then) {
  const auto key = [](const cost::GrowthRow& row) { return row.volume + " " + row.algorithm; };
  each_line(rows, key, [&](std::size_t line, std::span<const cost::GrowthRow> own) {
    ChartSeries series{.name = key(own[0]),
                       .shape = shape_of(line),
                       .role = then ? ChartRole::kThen : ChartRole::kChosen,
                       .line = true};
    for (const cost::GrowthRow& row : own)
      if (row.time.median > 0)
        series.points.push_back({static_cast<double>(row.points), row.time.median, static_cast<double>(row.points),
                                 static_cast<double>(row.points)});
    if (own[0].exponent) series.name += said(": n^%.2f", *own[0].exponent);
    if (own[0].theory_exponent)
      series.name += said(own[0].tight ? ", theory %.2f" : ", theory at most %.2f", *own[0].theory_exponent);
    if (then) series.name.clear();
    chart.series.push_back(std::move(series));
  });
}

void add_turn(Chart& chart, const std::vector<cost::TurnRow>& rows, bool then) {
  const auto key = [](const cost::TurnRow& row) { return row.volume + " " + row.strategy; };
  each_line(rows, key, [&](std::size_t line, std::span<const cost::TurnRow> own) {
    ChartSeries series{.name = then ? "" : key(own[0]),
                       .shape = shape_of(line),
                       .role = then ? ChartRole::kThen : ChartRole::kChosen,
                       .line = true};
    for (const cost::TurnRow& row : own)
      series.points.push_back({row.degrees, row.slack, row.degrees, row.degrees});
    chart.series.push_back(std::move(series));
  });
}

}  // namespace

Chart cost_chart(const cost::Table<cost::CostRow>& now, const cost::Table<cost::CostRow>* then) {
  const CostLook look = look_of(now.rows);
  constexpr std::array kAgainst{"times the smallest of its kind", "times the convex hull’s size", "times the smallest found here"};
  Chart chart{.title = title_of(look.one && !now.rows.empty() ? (heading_of(now.rows[0].volume) + ": accuracy against time, ").c_str()
                                                         : "Accuracy against time, ",
                                now.provenance),
              .note = note_of(now.provenance),
              .x = {"time of one fit", ChartUnit::kTime, true},
              .y = {kAgainst[static_cast<std::size_t>(look.against)], ChartUnit::kRatio, true}};
  if (then != nullptr) add_costs(chart, then->rows, look, true);
  add_costs(chart, now.rows, look, false);
  std::sort(chart.front.begin(), chart.front.end(), [](const ChartPoint& a, const ChartPoint& b) { return a.x < b.x; });
  return chart;
}

Chart growth_chart(const cost::Table<cost::GrowthRow>& now, const cost::Table<cost::GrowthRow>* then) {
  Chart chart{.title = title_of("Time against points, ", now.provenance),
              .note = note_of(now.provenance),
              .x = {"points", ChartUnit::kCount, true},
              .y = {"time of one fit", ChartUnit::kTime, true}};
  if (then != nullptr) add_growth(chart, then->rows, true);
  add_growth(chart, now.rows, false);
  return chart;
}

Chart turn_chart(const cost::Table<cost::TurnRow>& now, const cost::Table<cost::TurnRow>* then) {
  Chart chart{.title = title_of("Slack over a full turn, ", now.provenance),
              .note = note_of(now.provenance),
              .x = {"turn of the body", ChartUnit::kDegrees},
              .y = {"larger than the tightest of its kind by", ChartUnit::kPercent}};
  if (then != nullptr) add_turn(chart, then->rows, true);
  add_turn(chart, now.rows, false);
  return chart;
}

}  // namespace snug::app
