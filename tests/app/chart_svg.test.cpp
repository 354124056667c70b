// A chart as SVG: the same words as on the screen, colours for both grounds, well-formed.
#include "app/chart_svg.hpp"

#include <algorithm>
#include <vector>

#include "app/chart_pen.hpp"
#include "app/subjects/claims/trial_chart.hpp"
#include "app/subjects/cost/charts.hpp"
#include "bench.hpp"
#include "viewed_lessons.hpp"

namespace snug::app {
namespace {

cost::Table<cost::GrowthRow> growth_table() {
  cost::Table<cost::GrowthRow> table{{.processor = "<a & b>", .points = "cube:1000"}, {}};
  for (const Index n : {10, 100, 1000})
    table.rows.push_back({.volume = "sphere",
                          .algorithm = "ritter",
                          .points = n,
                          .time = {.median = 20.0 * n, .min = 20.0 * n, .spread = 0.1, .repeats = 9, .trusted = true},
                          .in_fit = true,
                          .exponent = 1.02,
                          .theory_exponent = 1,
                          .tight = true});
  table.provenance.platform = "native";
  return table;
}

std::size_t count(const std::string& text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

std::string escaped_words(std::string words) {
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}})
    for (std::size_t at = words.find(from); at != std::string::npos; at = words.find(from, at + to.size()))
      words.replace(at, from.size(), to);
  return words;
}

/// The words that the screen's pen draws, with their places.
std::vector<DrawnWords> drawn_on_screen(Bench& bench, const Chart& chart, const Rect& rect) {
  std::vector<DrawnWords> drawn;
  ImGui::NewFrame();
  Look look = bench.app.look();
  look.drawn = &drawn;
  ScreenPen pen(ImGui::GetBackgroundDrawList());
  ImGui::GetIO().AddMousePosEvent(-FLT_MAX, -FLT_MAX);
  draw_chart(pen, look, rect, chart);
  ImGui::EndFrame();
  return drawn;
}

std::vector<std::string> words_on_screen(Bench& bench, const Chart& chart) {
  std::vector<std::string> words;
  for (const DrawnWords& one : drawn_on_screen(bench, chart, {0, 0, 1280, 800})) words.push_back(one.words);
  return words;
}

std::string svg_in_frame(Bench& bench, const Look& look, const Chart& chart) {
  static_cast<void>(bench);
  ImGui::NewFrame();
  std::string svg = chart_svg(look, 1280, 800, chart);
  ImGui::EndFrame();
  return svg;
}

}  // namespace

TEST_CASE("names stand at the ends of lines, and in a legend where there is no room for that") {
  Bench bench(test::flat_kdop());
  const Chart chart = growth_chart(growth_table());
  const auto place = [&](const Rect& rect) {
    for (const DrawnWords& one : drawn_on_screen(bench, chart, rect))
      if (one.words.starts_with("Ritter: n")) return one.low;
    return ImVec2(0, 0);
  };
  const ImVec2 beside = place({0, 0, 960, 600}), below = place({0, 0, 250, 600});
  CHECK(beside.x > 600);
  CHECK(beside.y < 300);
  CHECK(below.y > 500);
  CHECK(below.x > 0);
}

TEST_CASE("a chart's picture has the address of what shows it, and may have no ground") {
  Bench bench(test::flat_kdop());
  const Chart chart = growth_chart(growth_table());
  ImGui::NewFrame();
  const std::string usual = chart_svg(bench.app.look(), 1280, 800, chart);
  const std::string clear = chart_svg(bench.app.look(), 1280, 800, chart, "?lesson=a&step=0", false);
  ImGui::EndFrame();
  constexpr std::string_view kGround = "width=\"1280\" height=\"800\"/>";
  CHECK(usual.find("<metadata>") == std::string::npos);
  CHECK(usual.find(kGround) != std::string::npos);
  CHECK(clear.find("<metadata>?lesson=a&amp;step=0</metadata>") != std::string::npos);
  CHECK(clear.find(kGround) == std::string::npos);
}

TEST_CASE("words and marks grow with a picture larger than the screen's") {
  Bench bench(test::flat_kdop());
  const Chart chart = growth_chart(growth_table());
  ImGui::NewFrame();
  const std::string large = chart_svg(bench.app.look(), 2560, 1600, chart);
  const std::string usual = chart_svg(bench.app.look(), 1280, 800, chart);
  ImGui::EndFrame();
  CHECK(large.find("width=\"2560\" height=\"1600\" viewBox=\"0 0 1280 800\"") != std::string::npos);
  CHECK(large.substr(large.find("<title")) == usual.substr(usual.find("<title")));
}

TEST_CASE("a small picture has smaller words, and names those on the front rather than a legend") {
  Bench bench(test::flat_kdop());
  cost::Table<cost::CostRow> table{{.platform = "native"}, {}};
  for (const fit::Algorithm& one : fit::algorithms()) {
    const auto i = static_cast<double>(table.rows.size());
    cost::CostRow row{.volume = std::string(one.volume),
                      .algorithm = std::string(one.name),
                      .points = 9,
                      .of = 9,
                      .tightness = 1.0,
                      .over_hull = 3 - 0.04 * i,
                      .on_front = i == 0};
    row.time = {.median = 1000 + 10 * i, .min = 1000, .spread = 0.1, .repeats = 9, .batch = 1, .trusted = true};
    table.rows.push_back(row);
  }
  const Chart chart = cost_chart(table);
  ImGui::NewFrame();
  const std::string small = chart_svg(bench.app.look(), 640, 400, chart);
  ImGui::EndFrame();
  CHECK(small.find("viewBox=\"0 0 853.33 533.33\"") != std::string::npos);
  const auto named = [&](const ChartSeries& one) {
    return small.find('>' + escaped_words(one.name) + "</text>") != std::string::npos;
  };
  CHECK(named(chart.series[0]));
  CHECK_FALSE(std::all_of(chart.series.begin(), chart.series.end(), named));
}

TEST_CASE("an SVG has every word of the screen's chart, as text") {
  Bench bench(test::flat_kdop());
  for (const Chart& chart :
       {growth_chart(growth_table()), trial_chart(*cost::find_trial("four_points"), cost::all_trials())}) {
    const std::string svg = svg_in_frame(bench, bench.app.look(), chart);
    const auto words = words_on_screen(bench, chart);
    CHECK(words.size() >= 10);
    for (const std::string& one : words)
      CHECK_MESSAGE(svg.find('>' + escaped_words(one) + "</text>") != std::string::npos, one);
    CHECK(svg.find("<title id=\"title\">" + escaped_words(chart.title) + "</title>") != std::string::npos);
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
    CHECK(count(svg, "<text ") == count(svg, "</text>"));
    CHECK(count(svg, "textLength=\"") == count(svg, "<text "));
  }
}

TEST_CASE("an SVG has the colours of both grounds, one of high contrast its own alone") {
  Bench bench(test::flat_kdop());
  const Chart chart = growth_chart(growth_table());
  Look look = bench.app.look();
  look.palette = &kLight;
  const std::string light = svg_in_frame(bench, look, chart);
  look.palette = &kDark;
  CHECK(svg_in_frame(bench, look, chart) == light);
  CHECK(light.find("fill=\"#faf8f3\"") != std::string::npos);
  const std::size_t dark = light.find("@media (prefers-color-scheme:dark){");
  REQUIRE(dark != std::string::npos);
  for (const char* const color : {"#10141b", "#6fb1ff", "#e9edf4"}) CHECK(light.find(color, dark) != std::string::npos);
  look.palette = &kHighContrast;
  const std::string contrast = svg_in_frame(bench, look, chart);
  CHECK(contrast.find("@media") == std::string::npos);
  CHECK(contrast.find("#000000") != std::string::npos);
}

TEST_CASE("a claim's chart has a line for each kind of cloud, and each mark is the cloud that its row names") {
  const cost::Claim& claim = *cost::find_trial("hull_helps");
  const Chart chart = trial_chart(claim, cost::all_trials());
  REQUIRE(chart.series.size() == cost::trial_kinds().size());
  REQUIRE(chart.limit.has_value());
  CHECK(*chart.limit == claim.limit);
  for (const ChartSeries& series : chart.series) {
    const auto rows = trials_of_line(claim, cost::all_trials(), series.row);
    REQUIRE(rows.size() == series.points.size());
    CHECK(series.names.size() == series.points.size());
    int held = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      CHECK(series.points[i].y == rows[i]->value);
      if (i > 0) CHECK(series.points[i].y >= series.points[i - 1].y);
      held += rows[i]->holds ? 1 : 0;
    }
    CHECK(series.figure == std::to_string(held) + " of 40");
  }
  CHECK(trial_chart(claim, {}).series.empty());
}

TEST_CASE("what is claimed stands below its line where the line is at the chart's top, and over no words") {
  Bench bench(test::flat_kdop());
  const Chart chart = trial_chart(*cost::find_trial("as_much_memory"), cost::all_trials());
  const auto drawn = drawn_on_screen(bench, chart, {0, 0, 390, 390});
  const auto claimed =
      std::find_if(drawn.begin(), drawn.end(), [&](const DrawnWords& one) { return one.words == chart.limit_name; });
  REQUIRE(claimed != drawn.end());
  for (const DrawnWords& one : drawn) {
    const bool apart = one.high.x <= claimed->low.x || claimed->high.x <= one.low.x || one.high.y <= claimed->low.y ||
                       claimed->high.y <= one.low.y;
    if (one.words != chart.limit_name) CHECK_MESSAGE(apart, one.words);
  }
}

}  // namespace snug::app
