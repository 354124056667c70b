#include "web/costs.hpp"

#include "app/costs.hpp"

namespace snug::web {
namespace {

using emscripten::val;

std::string title_of(const cost::CostRow& row) {
  const fit::Algorithm* algorithm = fit::find_algorithm(row.volume, row.algorithm);
  return std::string(algorithm != nullptr ? algorithm->title : std::string_view(row.algorithm));
}

val row_object(const cost::CostRow& row) {
  val object = val::object();
  object.set("algorithm", row.algorithm);
  object.set("title", title_of(row));
  object.set("time", app::chart_figure(app::ChartUnit::kTime, row.time.median));
  object.set("size", row.tightness ? app::chart_figure(app::ChartUnit::kRatio, *row.tightness) : "");
  object.set("points", row.points);
  object.set("of", row.of);
  object.set("front", row.on_front);
  object.set("trusted", row.time.trusted);
  return object;
}

}  // namespace

cost::Provenance web_provenance(const std::string& processor) {
  return {.version = SNUG_VERSION, .build = SNUG_BUILD, .platform = "WebAssembly", .processor = processor};
}

val costs_object(app::App& app) {
  const lesson::Session& session = *app.session();
  if (!session.lesson().measures) return val::null();
  const app::Costs& costs = app.costs();
  val object = val::object(), rows = val::array();
  for (const cost::CostRow& row : costs.table().rows) rows.call<void>("push", row_object(row));
  object.set("shown", costs.shown());
  object.set("running", costs.running());
  object.set("progress", costs.progress());
  object.set("ready", session.asked() == nullptr);
  object.set("decided", session.costs() != nullptr);
  object.set("size", costs.size(session));
  object.set("of", costs.table().provenance.points);
  object.set("rows", rows);
  object.set("then", costs.then() != nullptr ? val(costs.then()->provenance.points) : val::null());
  return object;
}

std::string costs_file(app::App& app, const std::string& format) {
  const app::CostTable& table = app.costs().table();
  const std::span<const cost::CostRow> rows(table.rows);
  return format == "csv" ? cost::csv_of(table.provenance, rows) : cost::json_of(table.provenance, rows);
}

std::string lay_over(app::App& app, const std::string& csv, const std::string& name) {
  if (!app.session()->lesson().measures) return "this lesson has no chart to lay it over";
  auto table = cost::read_csv<cost::CostRow>(csv, name);
  if (!table) return table.error().message();
  app.costs().lay_over(std::move(*table));
  return "";
}

}  // namespace snug::web
