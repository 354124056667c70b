// What a chart says: its ticks, its figures, and what is made of a table.
#include "app/chart.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "app/subjects/cost/captions.hpp"
#include "app/subjects/cost/charts.hpp"
#include "geometry/random.hpp"

namespace snug::app {
namespace {

std::vector<std::string> labels(const ChartAxis& axis, double from, double to, int most) {
  std::vector<std::string> list;
  for (const ChartTick& tick : chart_ticks(axis, from, to, most)) list.push_back(tick.label);
  return list;
}

cost::CostRow row(const char* algorithm, double time, double tightness, bool front) {
  cost::CostRow made{.volume = "sphere",
                     .algorithm = algorithm,
                     .points = 9,
                     .of = 9,
                     .tightness = tightness,
                     .over_hull = 2 * tightness,
                     .on_front = front};
  made.time = {.median = time, .min = time, .spread = 0.2, .repeats = 9, .batch = 1, .trusted = true};
  return made;
}

}  // namespace

TEST_CASE("ticks are whole powers of ten, or what is between where there is room") {
  const ChartAxis time{"", ChartUnit::kTime, true}, ratio{"", ChartUnit::kRatio, true},
      count{"", ChartUnit::kCount, true};
  CHECK(labels(time, 900, 2e9, 9) ==
        std::vector<std::string>{"1 µs", "10 µs", "100 µs", "1 ms", "10 ms", "100 ms", "1 s"});
  CHECK(labels(time, 900, 2e9, 4) == std::vector<std::string>{"10 µs", "1 ms", "100 ms"});
  CHECK(labels(time, 37e3, 44e6, 4) == std::vector<std::string>{"100 µs", "1 ms", "10 ms"});
  CHECK(labels(time, 90, 240e6, 2) == std::vector<std::string>{"10 µs", "10 ms"});  // and not "200 ms" alone
  CHECK(labels(count, 9, 1100, 9) == std::vector<std::string>{"10", "100", "1,000"});
  CHECK(labels(ratio, 0.9, 4.7, 8) == std::vector<std::string>{"1", "1.5", "2", "3", "4"});
  CHECK(labels(ratio, 1.1, 9.9, 4) == std::vector<std::string>{"2", "5"});  // no room for more
  CHECK(labels(ratio, 0.9, 12, 9) == std::vector<std::string>{"1", "2", "5", "10"});
  CHECK(labels(ratio, 0.98, 1.31, 4) == std::vector<std::string>{"1", "1.1", "1.2", "1.3"});
  CHECK(labels({"", ChartUnit::kDegrees}, -5, 365, 5) == std::vector<std::string>{"0°", "90°", "180°", "270°", "360°"});
  CHECK(labels({"", ChartUnit::kDegrees}, -5, 365, 9).at(1) == "45°");
}

TEST_CASE("ticks are in the range, rising, and no more than wanted but by a few") {
  Random random(3);
  for (int round = 0; round < 2000; ++round) {
    const bool log = random.below(2) == 0;
    const double from = log ? 1e-3 + random.between(0, 100) : random.between(-50, 50),
                 to = from * (log ? 1 + random.between(0.01, 1e4) : 1) + (log ? 0 : random.between(0.01, 1e3));
    const int most = 2 + static_cast<int>(random.below(10));
    const auto ticks = chart_ticks({"", ChartUnit::kRatio, log}, from, to, most);
    INFO(from << " to " << to << ", at most " << most << (log ? ", log" : ""));
    CHECK(static_cast<int>(ticks.size()) <= most + 1);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      CHECK(ticks[i].at >= from);
      CHECK(ticks[i].at <= to);
      if (i > 0) CHECK(ticks[i].at > ticks[i - 1].at);
    }
  }
}

TEST_CASE("figures have their units") {
  CHECK(chart_figure(ChartUnit::kTime, 1234) == "1.23 µs");
  CHECK(chart_figure(ChartUnit::kTime, 2.5e9) == "2.5 s");
  CHECK(chart_figure(ChartUnit::kCount, 1000000) == "1,000,000");
  CHECK(chart_figure(ChartUnit::kCount, 316) == "316");
  CHECK(chart_figure(ChartUnit::kPercent, 0.35) == "35 %");
  CHECK(chart_figure(ChartUnit::kPercent, 12.5) == "1,250 %");
  CHECK(chart_figure(ChartUnit::kRatio, 1.23456) == "1.235");
}

TEST_CASE("a table of costs has a mark an algorithm, its spread, and the front by time") {
  const cost::Table<cost::CostRow> table{
      {.points = "cube:9"}, {row("slow", 300, 1, true), row("quick", 100, 1.2, true), row("worse", 200, 1.4, false)}};
  const Chart chart = cost_chart(table);
  REQUIRE(chart.series.size() == 3);
  CHECK(chart.series[0].name == "slow");
  CHECK(chart.series[0].role == ChartRole::kExact);
  CHECK(chart.series[1].role == ChartRole::kChosen);
  CHECK(chart.series[2].role == ChartRole::kPlain);
  CHECK(chart.series[0].shape != chart.series[1].shape);
  CHECK(chart.series[1].points[0].x_low == doctest::Approx(90));
  CHECK(chart.series[1].points[0].x_high == doctest::Approx(110));
  REQUIRE(chart.front.size() == 2);
  CHECK(chart.front[0].x == 100);
  CHECK(chart.title.ends_with(", cube"));
  CHECK(cost_chart(table, &table).series.size() == 6);
  cost::Table<cost::CostRow> once = table;
  once.rows[0].time.spread.reset();  // of a single batch: no bar, and none that reaches down to 0
  CHECK(cost_chart(once).series[0].points[0].x_low == 300);
}

TEST_CASE("volumes of several kinds are held against the hull, and what was sampled says so") {
  cost::Table<cost::CostRow> table{{}, {row("a", 300, 1, true), row("b", 100, 1.2, true)}};
  table.rows[1].volume = "obb";
  table.rows[1].of = 100;
  const Chart chart = cost_chart(table);
  CHECK(chart.series[0].points[0].y == 2);
  CHECK(chart.series[1].name == "obb b (9 points)");
  CHECK(chart.series[1].hollow);
}

TEST_CASE("growth and turns are a line each") {
  const cost::Table<cost::GrowthRow> growth{
      {},
      {{.volume = "sphere",
        .algorithm = "ritter",
        .points = 10,
        .time = {.median = 5},
        .exponent = 1.04,
        .theory_exponent = 1,
        .tight = true},
       {.volume = "sphere",
        .algorithm = "ritter",
        .points = 100,
        .time = {.median = 50},
        .exponent = 1.04,
        .theory_exponent = 1,
        .tight = true},
       {.volume = "obb", .algorithm = "pca", .points = 10, .time = {.median = 7}}}};
  const Chart lines = growth_chart(growth);
  REQUIRE(lines.series.size() == 2);
  CHECK(full_name(lines.series[0]) == "Sphere: Ritter: n^1.04, theory 1.00");
  CHECK(lines.series[0].slope == 1);
  CHECK(full_name(lines.series[1]) == "OBB: PCA of the points");  // not yet measured to its end
  const cost::Table<cost::GrowthRow> few{
      {}, {{.volume = "obb", .algorithm = "pca", .points = 10, .time = {.median = 7}, .in_fit = true}}};
  CHECK(growth_chart(few).series.at(0).figure == "too few points to tell");
  CHECK(!lines.series[1].slope);
  CHECK(lines.series[0].points.size() == 2);
  const cost::Table<cost::TurnRow> turn{{},
                                        {{.volume = "aabb", .strategy = "loose", .degrees = 0, .slack = 0.5},
                                         {.volume = "aabb", .strategy = "loose", .degrees = 5, .slack = 0.6}}};
  CHECK(turn_chart(turn).series.at(0).points.at(1).y == 0.6);
}

TEST_CASE(
    "as many looks as there can be series are all different, and an earlier result has those of the present one") {
  cost::Table<cost::CostRow> table, then;
  for (int i = 0; i < kChartLooks; ++i)
    table.rows.push_back(row(("a" + std::to_string(i)).c_str(), 100 + i, 1.5, false));
  then.rows = {table.rows[9], row("gone", 100, 1.2, false)};
  const Chart chart = cost_chart(table);
  std::set<std::pair<ChartShape, ChartRim>> looks;
  for (const ChartSeries& series : chart.series) looks.emplace(series.shape, series.rim);
  CHECK(looks.size() == kChartLooks);
  CHECK(chart.looks == kChartLooks);
  const Chart both = cost_chart(table, &then);
  CHECK(both.series[0].shape == both.series[2 + 9].shape);
  CHECK(both.series[0].rim == both.series[2 + 9].rim);
  CHECK(both.looks > kChartLooks);  // what is gone would look like another
}

TEST_CASE("a line that ends at its own limit is named, with its number of points") {
  const auto table_of = [](const char* why) {
    cost::Table<cost::GrowthRow> table{{.platform = "here"}, {}};
    for (const Index points : {1000, 1023})
      table.rows.push_back({.volume = "sphere", .algorithm = "welzl_recursive", .points = points, .stopped = why});
    table.rows.push_back({.volume = "sphere", .algorithm = "ritter", .points = 2000});
    return table;
  };
  const auto own = table_of("a run on more than 1023 points is stopped by its own limit");
  const std::string says = algorithm_title("sphere", "welzl_recursive") + " ends at 1,023 points, its own limit.";
  CHECK(growth_chart(own).note.ends_with(". " + says));
  CHECK(growth_caption(own, 1e9) == "1 of 2 is measured to the end. " + says);
  const auto slow = table_of("one run of 2000 points would take about 2 s");
  CHECK_FALSE(growth_chart(slow).note.ends_with("limit."));
  CHECK(growth_caption(slow, 1e9).find("would take over") != std::string::npos);
}

TEST_CASE("words of a picture grow and shrink with it, and stay readable") {
  CHECK(picture_scale(2560, 1600) == 2);
  CHECK(picture_scale(1280, 800) == 1);
  CHECK(picture_scale(1152, 720) == doctest::Approx(0.9));
  CHECK(picture_scale(640, 400) == 0.75);
}

TEST_CASE("before anything is measured a chart is its axes") {
  for (const Chart& chart : {cost_chart({}), growth_chart({}), turn_chart({})}) {
    CHECK(chart.series.empty());
    CHECK_FALSE(chart.title.ends_with(", "));
    CHECK(chart.note == "Nothing has been measured yet.");
  }
}

TEST_CASE("updates that are always tight share a line, and an earlier result adds one that has no name") {
  const auto at = [](const char* volume, const char* strategy, double degrees, double slack) {
    return cost::TurnRow{.volume = volume, .strategy = strategy, .degrees = degrees, .slack = slack};
  };
  const cost::Table<cost::TurnRow> turn{{},
                                        {at("aabb", "rebuild", 0, 0), at("aabb", "rebuild", 5, 1e-12),
                                         at("aabb", "loose", 0, 0), at("aabb", "loose", 5, 0.6),
                                         at("kdop", "k6_hill_climb", 0, 0)}};
  const Chart chart = turn_chart(turn, &turn);
  REQUIRE(chart.series.size() == 4);
  CHECK(chart.series[0].row == -1);
  CHECK(chart.series[0].name.empty());
  CHECK(chart.series[2].name == "2 that are always tight");
  CHECK(chart.series[2].row == 0);
  CHECK(chart.series[3].name == "Loose AABB");
  CHECK(chart.series[3].row == 1);
  CHECK(update_title("kdop", "k6_hill_climb") == "6-DOP by hill climbing");
}

TEST_CASE("the figures of a mark hide no curve where a corner of the chart is empty") {
  const Rect frame{10, 20, 300, 200};
  std::vector<ImVec2> rising;
  for (int i = 0; i < 40; ++i)
    rising.push_back({15 + 7.2f * static_cast<float>(i), 210 - 0.11f * static_cast<float>(i * i)});
  const auto hides = [](const Rect& box, ImVec2 mark) {
    return mark.x >= box.x && mark.x <= box.x + box.width && mark.y >= box.y && mark.y <= box.y + box.height;
  };
  for (const ImVec2 about : {rising.front(), rising[20], rising.back()}) {
    const Rect box = clear_place({190, 50}, frame, about, rising);
    for (const ImVec2 mark : rising) CHECK_FALSE(hides(box, mark));
    CHECK(box.x >= frame.x);
    CHECK(box.y >= frame.y);
    CHECK(box.x + box.width <= frame.x + frame.width);
    CHECK(box.y + box.height <= frame.y + frame.height);
  }
  const Rect beside = clear_place({60, 30}, frame, {100, 100}, {});  // nothing to hide
  CHECK(beside.x == 112);
  CHECK(beside.y == 58);
}

}  // namespace snug::app
