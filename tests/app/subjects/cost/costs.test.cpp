// The measurement that an app drives in slices, without a window.
#include "app/subjects/cost/costs.hpp"

#include <doctest/doctest.h>

#include <chrono>

#include "app/subjects/cost/captions.hpp"
#include "app/subjects/cost/charts.hpp"
#include "lesson/subjects/cost/cost.hpp"

namespace snug::app {
namespace {

constexpr std::string_view kLesson = R"(version = 2
title = "Chart"
summary = "A chart for tests."
minutes = 1
chart = "cost"
algorithms = ["ritter", "welzl"]
generators = ["cube"]

[points]
list = [[0, 0], [4, 1], [3, 3], [1, 2], [2, 5]]

[[section]]
title = "One"
text = "Prose."

[[question]]
id = "slowest"
asks = "slowest"
prompt = "Which one?"
because = "So."
)";

double now() {
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

lesson::Session opened() {
  auto lesson = lesson::read_lesson(kLesson, "chart.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  auto session = lesson::Session::open(*std::move(lesson));
  REQUIRE(session.has_value());
  return *std::move(session);
}

void finish(Costs& costs, lesson::Session& session) {
  for (int slices = 0; costs.running() && slices < 10'000; ++slices) costs.work(session, 1e6);
  REQUIRE_FALSE(costs.running());
}

io::PointFile cloud(std::size_t n) {
  io::PointFile file{.dim = 2, .points = {}, .triangles = {}};
  for (std::size_t i = 0; i < n; ++i)
    file.points.emplace_back(static_cast<double>(i % 97), static_cast<double>(i % 89), 0);
  return file;
}

TEST_CASE("first the prediction, then a run in slices, then what the session makes of it") {
  Costs costs({.clock = now, .here = {.version = "9"}});
  lesson::Session session = opened();
  CHECK(costs.shown());  // empty
  CHECK(costs.caption(session) == "Press Measure: first you predict, then it is measured.");
  CHECK(costs.status(session) == costs.caption(session));
  CHECK(session.conversation().asked() == nullptr);  // first seen, then asked
  REQUIRE(costs.command(session, "measure"));
  CHECK_FALSE(costs.running());
  CHECK(costs.caption(session) == "Predict first, then measure.");
  CHECK_FALSE(costs.command(session, "measure"));
  REQUIRE(session.conversation().give(lesson::OneChoice{1}));
  CHECK(costs.caption(session) == "Your predictions are in: now press Measure.");
  CHECK(costs.status(session) == "Now press Measure: 5 points.");
  REQUIRE(costs.command(session, "measure"));
  CHECK(costs.shown());
  costs.work(session, 0);
  CHECK(costs.running());
  CHECK(lesson::costs_of(session) == nullptr);
  const int version = costs.version();
  finish(costs, session);
  CHECK(costs.version() != version);
  REQUIRE(lesson::costs_of(session) != nullptr);
  CHECK(lesson::costs_of(session)->size() == 2);
  CHECK_FALSE(session.log().outcomes()[0].pending);
  CHECK(costs.accuracy().provenance.points == "own");
  CHECK(costs.accuracy().provenance.version == "9");
  CHECK(costs.accuracy().provenance.clock_resolution_ns > 0);
  CHECK(costs.accuracy().rows[1].time.batch >= 1);
  CHECK(costs.caption(session).find(" on the front") != std::string::npos);

  CHECK(costs.command(session, "chart_next"));
  CHECK(costs.caption(session).find(" s") != std::string::npos);  // a time with its unit
  CHECK(costs.command(session, "chart_next"));
  CHECK(costs.command(session, "chart_load"));
  CHECK_FALSE(costs.shown());
  CHECK(session.player().step() == session.player().steps());
}

TEST_CASE("a front with a time that could not be measured reliably is told with a reservation") {
  cost::CostRow row{.volume = "sphere", .algorithm = "ritter", .on_front = true};
  row.points = row.of = 5;
  row.time.trusted = true;
  cost::Table<cost::CostRow> table;
  table.rows = {row, row};
  CHECK(accuracy_caption(table).starts_with("2 of 2 lie on the front. "));
  table.rows[1].time.trusted = false;
  CHECK(accuracy_caption(table).starts_with("2 of 2 lie on the front, as far as the times can be trusted. "));
}

TEST_CASE("what is ready stays when it is stopped, and other points are other figures") {
  Costs costs({.clock = now, .here = {}});
  lesson::Session session = opened();
  session.conversation().ask_predictions();
  session.conversation().give({});
  REQUIRE(costs.command(session, "measure"));
  for (int slices = 0; costs.accuracy().rows.empty() && slices < 10'000; ++slices) costs.work(session, 0);
  REQUIRE(costs.command(session, "stop_measuring"));
  CHECK(costs.accuracy().rows.size() == 1);
  CHECK_FALSE(costs.running());
  CHECK(lesson::costs_of(session) == nullptr);
  REQUIRE(costs.command(session, "measure"));
  REQUIRE(session.stage().move(0, {7, 7, 0}).has_value());
  finish(costs, session);
  CHECK(costs.accuracy().rows.size() == 2);
  CHECK(lesson::costs_of(session) == nullptr);
  CHECK(costs.status(session) == "2 measured. Points: own. The points have changed since.");
  REQUIRE(costs.command(session, "measure"));
  finish(costs, session);
  CHECK(costs.status(session) == "2 measured. Points: own.");
  REQUIRE(session.stage().move(0, {8, 7, 0}).has_value());
  CHECK(costs.status(session) == "2 measured. Points: own. The points have changed since.");
}

TEST_CASE("a large file is measured whole and shown in part; above two million points it is refused") {
  Costs costs({.clock = now, .here = {}});
  lesson::Session session = opened();
  session.conversation().ask_predictions();
  session.conversation().give({});
  REQUIRE(costs.load(session, cloud(6000), "large.xyz").has_value());
  CHECK(session.stage().subject().size() == 5000);
  CHECK(costs.size(session) == 6000);
  REQUIRE(costs.command(session, "measure"));
  finish(costs, session);
  CHECK(costs.accuracy().rows[0].of == 6000);
  CHECK(costs.accuracy().provenance.points == "large.xyz");
  const auto refused = costs.load(session, cloud(2'000'001), "huge.xyz");
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().message().find("2,000,001 points, and costs are measured on at most 2,000,000") !=
        std::string::npos);
  CHECK(costs.size(session) == 6000);
  session.stage().reset();
  CHECK(costs.size(session) == 5);
}

TEST_CASE("points of a dimension that an algorithm does not take are refused by name") {
  Costs costs({.clock = now, .here = {}});
  std::string text(kLesson);
  text.replace(text.find("[\"ritter\", \"welzl\"]"), 19, "[\"sphere/welzl\", \"kdop/k14\"]");
  text.replace(text.find("list = [[0, 0], [4, 1], [3, 3], [1, 2], [2, 5]]"), 47,
               "dim = 3\nlist = [[0, 0, 0], [4, 1, 1], [3, 3, 2], [1, 2, 5]]");
  auto lesson = lesson::read_lesson(text, "chart.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  auto session = lesson::Session::open(*std::move(lesson));
  REQUIRE(session.has_value());
  REQUIRE(costs.load(*session, cloud(20), "flat.csv").has_value());
  CHECK(costs.command(*session, "measure"));
  CHECK_FALSE(costs.running());
  CHECK(costs.caption(*session).ends_with("takes points with three coordinates, and these have two."));
}

TEST_CASE("an earlier result lies over the present one, with marks of no row") {
  Costs costs({.clock = now, .here = {}});
  lesson::Session session = opened();
  cost::CostRow row;
  row.volume = "sphere", row.algorithm = "ritter", row.time.median = 5, row.tightness = 1.1;
  REQUIRE(costs.lay_over(session, CostTable{{.points = "before"}, {row}}));
  REQUIRE(costs.sheet().then() != nullptr);
  CHECK(costs.sheet().then()->points == "before");
  CHECK(costs.command(session, "chart_next"));
  CHECK_FALSE(costs.command(session, "chart_load"));  // it is no algorithm of this measurement
}

TEST_CASE("beside a chart of several volumes, words name each with its volume, and say its size over the hull's as the "
          "chart does") {
  cost::CostRow sphere, capsule;
  sphere.volume = "sphere", sphere.algorithm = "ritter", sphere.tightness = 1, sphere.over_hull = 250;
  capsule.volume = "capsule", capsule.algorithm = "pca", capsule.over_hull = 4;
  const std::vector<cost::CostRow> both{sphere, capsule}, one{sphere};
  CHECK(accuracy_words(both, sphere).title == "Sphere: Ritter");
  CHECK(accuracy_words(both, sphere).size == 250.0);
  CHECK(accuracy_words(both, capsule).title == "Capsule: PCA");
  CHECK(accuracy_words(both, capsule).size == 4.0);
  CHECK(accuracy_against(both) == "the hull");
  CHECK(accuracy_words(one, sphere).title == "Ritter");
  CHECK(accuracy_words(one, sphere).size == 1.0);
  CHECK(accuracy_against(one) == "the smallest");
}

TEST_CASE("the other charts are not to be had before the predictions, whose answers they would give away") {
  Costs costs({.clock = now, .here = {}});
  lesson::Session session = opened();
  for (const char* name : {"show_growth", "show_turn", "show_other"}) CHECK_FALSE(costs.command(session, name));
  CHECK_FALSE(costs.command(session, "show_nothing"));
  CHECK(costs.command(session, "show_accuracy"));
  CHECK_FALSE(costs.may_see(session, CostView::kGrowth));
  cost::GrowthRow row{.volume = "sphere", .algorithm = "ritter", .points = 10, .time = {.median = 5}};
  CHECK_FALSE(costs.lay_over(session, GrowthTable{{}, {row}}));
  CHECK(costs.view() == CostView::kAccuracy);
  session.conversation().ask_predictions();
  session.conversation().give({});
  CHECK(costs.command(session, "show_other"));
  CHECK(costs.view() == CostView::kGrowth);
  CHECK(costs.sheet().then() == nullptr);  // what was refused is not there either
  CHECK(costs.lay_over(session, GrowthTable{{}, {row}}));
  CHECK(costs.sheet().then() != nullptr);
}

TEST_CASE("growth is measured on a kind of points; what is ready stays, and figures are to be had by key") {
  Costs costs({.clock = now, .longest_run = 2e4, .here = {}});
  lesson::Session session = opened();
  session.conversation().ask_predictions();
  session.conversation().give({});
  REQUIRE(costs.command(session, "show_growth"));
  CHECK(costs.shown());
  REQUIRE(costs.command(session, "measure"));
  finish(costs, session);
  const GrowthTable& table = costs.growth();
  CHECK(table.provenance.points == "cube:1000000");  // the lesson's own are too few to grow
  REQUIRE(lines_of(table.rows).size() == 2);
  for (const auto& line : lines_of(table.rows)) {
    CHECK(line[0].points == 10);
    CHECK(line.back().points < 1'000'000);
    CHECK(line[0].stopped.find("one run of") == 0);
  }
  CHECK(lesson::costs_of(session) == nullptr);  // the questions are of the other chart
  CHECK(costs.accuracy().rows.empty());
  CHECK(costs.sheet().csv().find("# snug table: growth\n") == 0);
  CHECK(costs.caption(session).find("end where one run would take over 20 µs") != std::string::npos);
  REQUIRE(costs.command(session, "chart_next"));
  CHECK(costs.caption(session).find(": 10 points, ") != std::string::npos);
  REQUIRE(costs.command(session, "chart_next"));
  CHECK(costs.caption(session).find(": 32 points, ") != std::string::npos);
  const std::string first = costs.caption(session);
  REQUIRE(costs.command(session, "chart_down"));
  CHECK(costs.caption(session) != first);
  CHECK(costs.caption(session).find(": 32 points, ") != std::string::npos);
  CHECK_FALSE(costs.command(session, "chart_load"));
}

TEST_CASE("a generated set grows as its kind, a large file's by samples of itself") {
  Costs costs({.clock = now, .longest_run = 1e4, .here = {}});
  lesson::Session session = opened();
  session.conversation().ask_predictions();
  session.conversation().give({});
  REQUIRE(costs.command(session, "show_growth"));
  REQUIRE(session.stage().set_generator("gaussian", 50, 2, 7).has_value());
  REQUIRE(costs.command(session, "measure"));
  REQUIRE(costs.command(session, "stop_measuring"));
  CHECK(costs.growth().provenance.points == "gaussian:1000000");
  CHECK(costs.growth().provenance.seed == 7);
  REQUIRE(costs.load(session, cloud(12'000), "large.xyz").has_value());
  REQUIRE(costs.command(session, "measure"));
  finish(costs, session);
  CHECK(costs.growth().provenance.points == "large.xyz");
  CHECK(costs.growth().rows.size() > 2);
}

TEST_CASE("a turn has each update at every angle; another chart can be looked at while it is measured") {
  Costs costs({.clock = now, .here = {}});
  lesson::Session session = opened();
  session.conversation().ask_predictions();
  session.conversation().give({});
  REQUIRE(costs.command(session, "show_turn"));
  REQUIRE(costs.command(session, "measure"));
  while (costs.turn().rows.empty()) costs.work(session, 0);
  REQUIRE(costs.command(session, "show_growth"));
  CHECK(costs.running());
  CHECK_FALSE(costs.command(session, "measure"));
  CHECK(costs.caption(session).find("Another chart") == 0);
  finish(costs, session);
  CHECK(costs.growth().rows.empty());
  REQUIRE(costs.command(session, "show_turn"));
  const auto lines = lines_of(costs.turn().rows);
  CHECK(lines.size() == 12);  // of the plane
  for (const auto& line : lines) {
    CHECK(line.size() == 72);
    CHECK(line[0].updated.median > 0);
    for (const cost::TurnRow& row : line) CHECK(row.contains);
  }
  CHECK(costs.caption(session).find(" of 12 updates are always the tightest") != std::string::npos);
  CHECK(costs.command(session, "chart_next"));
  CHECK(costs.sheet().json().find("{\"table\":\"turn\"") == 0);
}

TEST_CASE("on the chart the arrow keys go from mark to mark") {
  Costs costs({.clock = now, .here = {}});
  CHECK(costs.command_of_key("ArrowRight") == "chart_next");
  CHECK(costs.command_of_key("ArrowDown") == "chart_down");
  CHECK(costs.command_of_key("Enter") == "chart_load");
  costs.show(false);
  CHECK(costs.command_of_key("ArrowRight").empty());
  CHECK(costs.command_of_key("v") == "show_other");
  CHECK(costs.command_of_key("c") == "toggle_chart");
  CHECK(costs.command_of_key("m") == "measure");
}

}  // namespace
}  // namespace snug::app
