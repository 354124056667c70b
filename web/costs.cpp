#include "web/costs.hpp"

#include <algorithm>
#include <span>

#include "app/subjects/cost/charts.hpp"
#include "app/subjects/cost/costs.hpp"
#include "lesson/subjects/cost/cost.hpp"
#include "measure/turn_run.hpp"

namespace snug::web {
namespace {

using emscripten::val;

std::string time_of(const cost::Timing& timing) { return app::chart_figure(app::ChartUnit::kTime, timing.median); }
std::string percent_of(double share) { return app::chart_figure(app::ChartUnit::kPercent, share); }

val row_object(const cost::CostRow& row) {
  val object = val::object();
  object.set("algorithm", row.algorithm);
  object.set("title", app::algorithm_title(row.volume, row.algorithm));
  object.set("time", time_of(row.time));
  object.set("size", row.tightness ? app::chart_figure(app::ChartUnit::kRatio, *row.tightness) : "");
  object.set("points", row.points);
  object.set("of", row.of);
  object.set("front", row.on_front);
  object.set("trusted", row.time.trusted);
  return object;
}

/// A line as an object: its last point and its power.
val row_object(std::span<const cost::GrowthRow> line) {
  const cost::GrowthRow& last = line.back();
  val object = val::object();
  object.set("algorithm", last.algorithm);
  object.set("title", app::algorithm_title(last.volume, last.algorithm));
  object.set("points", last.points);
  object.set("time", time_of(last.time));
  object.set("trusted", last.time.trusted);
  object.set("exponent", last.exponent ? val(*last.exponent) : val::null());
  object.set("theory", last.theory_exponent ? val(*last.theory_exponent) : val::null());
  object.set("bound", last.theory);
  object.set("tight", last.tight);
  object.set("stopped", last.stopped);
  return object;
}

/// A line as an object: its least and greatest looseness.
val row_object(std::span<const cost::TurnRow> line) {
  const auto range = cost::slack_range(line);
  val object = val::object();
  object.set("volume", line[0].volume);
  object.set("strategy", line[0].strategy);
  object.set("title", app::update_title(line[0].volume, line[0].strategy));
  object.set("angles", static_cast<int>(line.size()));
  object.set("least", range ? percent_of(range->least) : "not known");
  object.set("most", range ? percent_of(range->most) : "not known");
  object.set("time", line[0].updated.median > 0 ? time_of(line[0].updated) : "");
  return object;
}

val array_of_rows(const auto& rows) {
  val array = val::array();
  for (const auto& row : rows) array.call<void>("push", row_object(row));
  return array;
}

val shown_rows(const app::Costs& costs) {
  if (costs.view() == app::CostView::kGrowth) return array_of_rows(app::lines_of(costs.growth().rows));
  if (costs.view() == app::CostView::kTurn) return array_of_rows(app::lines_of(costs.turn().rows));
  return array_of_rows(costs.table().rows);
}

/// Shows an earlier result. Returns "" or why that is impossible.
template <class Row>
std::string lay_over_as(app::App& app, const std::string& csv, const std::string& name) {
  auto table = cost::read_csv<Row>(csv, name);
  if (!table) return table.error().message();
  return app::costs_of(app)->lay_over(*app.session(), std::move(*table)) ? "" : std::string(app::kPredictFirst);
}

}  // namespace

cost::Provenance web_provenance(const std::string& processor) {
  return {.version = SNUG_VERSION, .build = SNUG_BUILD, .platform = "WebAssembly", .processor = processor};
}

val costs_object(app::App& app) {
  const lesson::Session& session = *app.session();
  const app::Costs* const measured = app::costs_of(app);
  if (measured == nullptr) return val::null();
  const app::Costs& costs = *measured;
  const auto view = static_cast<std::size_t>(costs.view());
  val object = val::object();
  object.set("chart", std::string(app::kCostViewNames[view]));
  object.set("shown", costs.shown());
  object.set("running", costs.running());
  object.set("progress", costs.progress());
  object.set("ready", session.asked() == nullptr);
  object.set("decided", lesson::costs_of(session) != nullptr);
  object.set("size", costs.size(session));
  object.set("of", costs.sheet().about().points);
  object.set("says", costs.status(session));
  object.set("rows", shown_rows(costs));
  object.set("then", costs.sheet().then() != nullptr ? val(costs.sheet().then()->points) : val::null());
  return object;
}

std::string costs_file(app::App& app, const std::string& format) {
  const app::Costs* const costs = app::costs_of(app);
  if (costs == nullptr) return "";
  return format == "csv" ? costs->sheet().csv() : costs->sheet().json();
}

std::string lay_over(app::App& app, const std::string& csv, const std::string& name) {
  if (app::costs_of(app) == nullptr) return "this lesson has no chart to lay it over";
  const auto is = [&](std::string_view table) { return csv.substr(0, csv.find('\n')).ends_with(table); };
  if (is(cost::GrowthRow::kTable)) return lay_over_as<cost::GrowthRow>(app, csv, name);
  if (is(cost::TurnRow::kTable)) return lay_over_as<cost::TurnRow>(app, csv, name);
  return lay_over_as<cost::CostRow>(app, csv, name);
}

}  // namespace snug::web
