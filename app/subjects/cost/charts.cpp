#include "app/subjects/cost/charts.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <string_view>
#include <utility>

#include "fit/catalogue.hpp"
#include "fit/update/updates.hpp"
#include "lesson/say.hpp"
#include "measure/growth.hpp"

namespace snug::app {
namespace {

/// A volume that is larger by less counts as the tightest.
constexpr double kRounding = 1e-6;

std::string one_number(const char* format, double value) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

/// Cycles through shapes, then rims, so that colours are free for their meanings.
void set_look(Chart& chart, ChartSeries& series, std::size_t i) {
  chart.looks = std::max(chart.looks, static_cast<int>(i) + 1);
  series.shape = static_cast<ChartShape>(i % kChartShapes);
  series.rim = static_cast<ChartRim>(i / kChartShapes % kChartRims);
}

/// The index of the matching series in the current result; series that only the earlier result has come after those.
template <class Series, class Same>
std::size_t look_index(const Series& now, const typename Series::value_type& own, std::size_t i, Same same) {
  const auto found = std::find_if(now.begin(), now.end(), [&](const auto& one) { return same(one, own); });
  return found != now.end() ? static_cast<std::size_t>(found - now.begin()) : now.size() + i;
}

/// The title without the number of points, which the axis or the table shows: "cube" for "cube:1000".
std::string title_of(const std::string& what, const cost::Provenance& p) {
  return p.points.empty() ? what : what + ", " + p.points.substr(0, p.points.find(':'));
}

std::string note_of(const cost::Provenance& p) {
  if (p.platform.empty()) return "Nothing has been measured yet.";
  return p.scalar + ", seed " + std::to_string(p.seed) + "; " + p.platform + ", " + p.build +
         (p.processor.empty() ? "" : ", " + p.processor);
}

template <class Row>
bool of_one_volume(const std::vector<Row>& rows) {
  return std::all_of(rows.begin(), rows.end(), [&](const Row& row) { return row.volume == rows[0].volume; });
}

/// one: whether the chart has one volume, which need not be named then.
template <class Row>
std::string series_name(bool one, const Row& row) {
  return one ? algorithm_title(row.volume, row.algorithm) : lesson::title_among_volumes(row.volume, row.algorithm);
}

/// "OBB", "Sphere"
std::string heading_of(const std::string& volume) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kShort{
      {{"obb", "OBB"}, {"aabb", "AABB"}, {"kdop", "k-DOP"}}};
  for (const auto& [name, text] : kShort)
    if (name == volume) return std::string(text);
  return static_cast<char>(std::toupper(static_cast<unsigned char>(volume[0]))) + volume.substr(1);
}

/// A point with a bar of half the spread to either side; without a spread, no bar.
ChartPoint point_of(const cost::Timing& time, double y) {
  if (!time.spread) return {time.median, y, time.median, time.median};
  return {time.median, y, time.median * (1 - std::min(*time.spread, 1.8) / 2), time.median * (1 + *time.spread / 2)};
}

/// What a size is compared with: the smallest of its kind, the hull, or the smallest in the table.
enum class Against : std::uint8_t { kSmallest, kHull, kFound };

struct CostLook {
  bool one;  // volume
  Against against;
  double found;  // the smallest measure in the table
  [[nodiscard]] std::optional<double> y(const cost::CostRow& row) const {
    if (against == Against::kFound) return row.is_flat() ? std::nullopt : std::optional(row.measure / found);
    return against == Against::kSmallest ? row.tightness : row.over_hull;
  }
};

/// What is known for every row: if an exact run takes too long, the smallest volume is known only for fewer points.
CostLook look_of(const std::vector<cost::CostRow>& rows) {
  const auto all = [&](auto known) { return std::all_of(rows.begin(), rows.end(), known); };
  CostLook look{of_one_volume(rows), Against::kFound, std::numeric_limits<double>::infinity()};
  for (const cost::CostRow& row : rows)
    if (!row.is_flat() && row.points == row.of) look.found = std::min(look.found, row.measure);
  if (look.one && all([](const cost::CostRow& row) { return row.tightness.has_value(); }))
    look.against = Against::kSmallest;
  else if (!look.one || all([](const cost::CostRow& row) { return row.over_hull.has_value(); }))
    look.against = Against::kHull;
  return look;
}

bool of_same_algorithm(const cost::CostRow& a, const cost::CostRow& b) {
  return a.volume == b.volume && a.algorithm == b.algorithm;
}

/// then: whether the rows are from an earlier result; now: those of the current result, whose looks they share.
void add_costs(Chart& chart, const std::vector<cost::CostRow>& rows, const CostLook& look,
               const std::vector<cost::CostRow>& now, bool then) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const cost::CostRow& row = rows[i];
    const auto y = look.y(row);
    if (!y || !(*y > 0) || !(row.time.median > 0)) continue;
    ChartSeries series{.name = then ? "" : series_name(look.one, row),
                       .hollow = row.points < row.of || !row.time.trusted,
                       .points = {point_of(row.time, *y)},
                       .row = then ? -1 : static_cast<int>(i)};
    set_look(chart, series, look_index(now, row, i, of_same_algorithm));
    if (then) series.role = ChartRole::kThen;
    else if (look.against == Against::kSmallest && *y <= 1) series.role = ChartRole::kExact;
    else if (row.on_front) series.role = ChartRole::kChosen;
    if (row.points < row.of && !then) series.name += " (" + std::to_string(row.points) + " points)";
    if (row.on_front && !then) {
      const ChartPoint& own = series.points[0];
      chart.front.insert(
          std::find_if(chart.front.begin(), chart.front.end(), [&](const ChartPoint& p) { return p.x > own.x; }), own);
    }
    chart.series.push_back(std::move(series));
  }
}

/// Splits a table into lines: consecutive rows that are the same by `same`.
template <class Row, class Same>
std::vector<std::span<const Row>> cut(const std::vector<Row>& rows, Same same) {
  std::vector<std::span<const Row>> lines;
  for (std::size_t first = 0, end = 0; first < rows.size(); first = end) {
    while (end < rows.size() && same(rows[end], rows[first])) ++end;
    lines.push_back(std::span<const Row>(rows).subspan(first, end - first));
  }
  return lines;
}

/// look: the index of its look.
ChartSeries line_series(Chart& chart, std::size_t line, std::size_t look, bool then) {
  ChartSeries series{
      .role = then ? ChartRole::kThen : ChartRole::kChosen, .line = true, .row = then ? -1 : static_cast<int>(line)};
  set_look(chart, series, look);
  return series;
}

using GrowthLine = std::span<const cost::GrowthRow>;
using TurnLine = std::span<const cost::TurnRow>;
bool of_same_growth(GrowthLine a, GrowthLine b) {
  return a[0].volume == b[0].volume && a[0].algorithm == b[0].algorithm;
}
bool of_same_update(TurnLine a, TurnLine b) { return a[0].volume == b[0].volume && a[0].strategy == b[0].strategy; }

void add_growth(Chart& chart, const std::vector<cost::GrowthRow>& rows, const std::vector<cost::GrowthRow>& now,
                bool then) {
  const bool one = of_one_volume(rows);
  const auto lines = lines_of(rows), present = lines_of(now);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    ChartSeries series = line_series(chart, i, look_index(present, lines[i], i, of_same_growth), then);
    const cost::GrowthRow& first = lines[i][0];
    for (const cost::GrowthRow& row : lines[i]) {
      const auto n = static_cast<double>(row.points);
      if (row.time.median > 0) series.points.push_back({n, row.time.median, n, n});
    }
    if (!then) {
      series.name = series_name(one, first);
      if (first.exponent) series.figure = one_number("n^%.2f", *first.exponent);
      else if (is_fitted(lines[i])) series.figure = cost::kTooFewToTell;
      series.beside = theory_words(first);
      series.slope = first.theory_exponent;
    }
    chart.series.push_back(std::move(series));
  }
}

void add_turn(Chart& chart, const std::vector<cost::TurnRow>& rows, const std::vector<cost::TurnRow>& now, bool then) {
  const auto lines = lines_of(rows), present = lines_of(now);
  const auto tight = std::count_if(lines.begin(), lines.end(), always_tight);
  bool tight_is_there = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool of_many = tight > 1 && always_tight(lines[i]);
    if (of_many && std::exchange(tight_is_there, true)) continue;
    ChartSeries series = line_series(chart, i, look_index(present, lines[i], i, of_same_update), then);
    if (!then)
      series.name = of_many ? std::to_string(tight) + " that are always tight"
                            : update_title(lines[i][0].volume, lines[i][0].strategy);
    for (const cost::TurnRow& row : lines[i])
      if (row.slack) series.points.push_back({row.degrees, *row.slack, row.degrees, row.degrees});
    if (series.points.empty()) continue;
    chart.series.push_back(std::move(series));
  }
}

}  // namespace

std::vector<std::span<const cost::GrowthRow>> lines_of(const std::vector<cost::GrowthRow>& rows) {
  return cut(rows, [](const cost::GrowthRow& a, const cost::GrowthRow& b) {
    return a.volume == b.volume && a.algorithm == b.algorithm;
  });
}
std::vector<std::span<const cost::TurnRow>> lines_of(const std::vector<cost::TurnRow>& rows) {
  return cut(rows, [](const cost::TurnRow& a, const cost::TurnRow& b) {
    return a.volume == b.volume && a.strategy == b.strategy;
  });
}

bool is_fitted(std::span<const cost::GrowthRow> line) { return line.back().in_fit; }

bool always_tight(std::span<const cost::TurnRow> line) {
  return std::all_of(line.begin(), line.end(),
                     [](const cost::TurnRow& row) { return row.slack && *row.slack < kRounding; });
}

std::string_view accuracy_against(const std::vector<cost::CostRow>& rows) {
  constexpr std::array<std::string_view, 3> kAgainst{"the smallest", "the hull", "the smallest found"};
  return kAgainst[static_cast<std::size_t>(look_of(rows).against)];
}

AccuracyWords accuracy_words(const std::vector<cost::CostRow>& rows, const cost::CostRow& row) {
  const CostLook look = look_of(rows);
  return {series_name(look.one, row), look.y(row), accuracy_against(rows)};
}

std::string growth_title(const std::vector<cost::GrowthRow>& rows, const cost::GrowthRow& row) {
  return series_name(of_one_volume(rows), row);
}

std::string own_limits(const std::vector<cost::GrowthRow>& rows) {
  std::string said;
  for (const auto line : lines_of(rows))
    if (ends_at_own_limit(line.back()))
      said += " " + growth_title(rows, line.back()) + " ends at " +
              chart_figure(ChartUnit::kCount, static_cast<double>(line.back().points)) + " points, its own limit.";
  return said;
}

std::string algorithm_title(std::string_view volume, std::string_view algorithm) {
  const fit::Algorithm* found = fit::find_algorithm(volume, algorithm);
  return std::string(found != nullptr ? found->title : algorithm);
}

std::string update_title(std::string_view volume, std::string_view strategy) {
  const fit::UpdateStrategy* found = fit::find_update(volume, strategy);
  return std::string(found != nullptr ? found->title : strategy);
}

std::string theory_words(const cost::GrowthRow& row) {
  if (!row.theory_exponent) return {};
  return one_number(row.tight ? "theory %.2f" : "theory at most %.2f", *row.theory_exponent);
}

Chart cost_chart(const cost::Table<cost::CostRow>& now, const cost::Table<cost::CostRow>* then) {
  const CostLook look = look_of(now.rows);
  constexpr std::array kAgainst{"times the smallest of its kind", "times the convex hull’s size",
                                "times the smallest found here"};
  const bool one = look.one && !now.rows.empty();
  Chart chart{.title =
                  title_of(one ? heading_of(now.rows[0].volume) + ": accuracy against time" : "Accuracy against time",
                           now.provenance),
              .note = note_of(now.provenance),
              .x = {"time of one fit", ChartUnit::kTime, true},
              .y = {now.rows.empty() ? "relative size" : kAgainst[static_cast<std::size_t>(look.against)],
                    ChartUnit::kRatio, true}};
  if (then != nullptr) add_costs(chart, then->rows, look, now.rows, true);
  add_costs(chart, now.rows, look, now.rows, false);
  return chart;
}

Chart growth_chart(const cost::Table<cost::GrowthRow>& now, const cost::Table<cost::GrowthRow>* then) {
  const std::string limits = own_limits(now.rows);
  Chart chart{.title = title_of("Time against the number of points", now.provenance),
              .note = note_of(now.provenance) + (limits.empty() ? "" : "." + limits),
              .x = {"points", ChartUnit::kCount, true},
              .y = {"time of one fit", ChartUnit::kTime, true}};
  if (then != nullptr) add_growth(chart, then->rows, now.rows, true);
  add_growth(chart, now.rows, now.rows, false);
  return chart;
}

Chart turn_chart(const cost::Table<cost::TurnRow>& now, const cost::Table<cost::TurnRow>* then) {
  Chart chart{.title = title_of("Looseness over a full turn", now.provenance),
              .note = note_of(now.provenance),
              .x = {"turn of the body", ChartUnit::kDegrees},
              .y = {"larger than the tightest of its kind by", ChartUnit::kPercent}};
  if (then != nullptr) add_turn(chart, then->rows, now.rows, true);
  add_turn(chart, now.rows, now.rows, false);
  return chart;
}

}  // namespace snug::app
