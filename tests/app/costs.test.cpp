// The measurement that an app drives in slices, without a window.
#include "app/costs.hpp"

#include <doctest/doctest.h>

#include <chrono>

#include "app/commands.hpp"

namespace snug::app {
namespace {

constexpr std::string_view kLesson = R"(version = 1
group = "Tests"
title = "Chart"
summary = "A chart for tests."
order = 1
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

double now() { return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

lesson::Session opened(Costs& costs) {
  auto lesson = lesson::read_lesson(kLesson, "chart.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  auto session = lesson::Session::open(*std::move(lesson));
  REQUIRE(session.has_value());
  costs.open();
  return *std::move(session);
}

void finish(Costs& costs, lesson::Session& session) {
  for (int slices = 0; costs.running() && slices < 10'000; ++slices) costs.work(session, 1e6);
  REQUIRE_FALSE(costs.running());
}

io::PointFile cloud(std::size_t n) {
  io::PointFile file{.dim = 2, .points = {}, .triangles = {}};
  for (std::size_t i = 0; i < n; ++i) file.points.emplace_back(static_cast<double>(i % 97), static_cast<double>(i % 89), 0);
  return file;
}

TEST_CASE("first the prediction, then a run in slices, then what the session makes of it") {
  Costs costs({.clock = now, .here = {.version = "9"}});
  lesson::Session session = opened(costs);
  CHECK_FALSE(costs.shown());  // the shape is what the predictions are of
  CHECK(costs.caption(session) == "Predict first, then measure.");
  CHECK_FALSE(costs.command(session, "measure"));
  REQUIRE(session.answer({lesson::Answer::Kind::kChoice, 1}));
  REQUIRE(costs.command(session, "measure"));
  CHECK(costs.shown());
  costs.work(session, 0);
  CHECK(costs.running());
  CHECK(session.costs() == nullptr);
  const int version = costs.version();
  finish(costs, session);
  CHECK(costs.version() != version);
  REQUIRE(session.costs() != nullptr);
  CHECK(session.costs()->size() == 2);
  CHECK_FALSE(session.outcomes()[0].pending);
  CHECK(costs.table().provenance.points == "own");
  CHECK(costs.table().provenance.version == "9");
  CHECK(costs.table().provenance.clock_resolution_ns > 0);
  CHECK(costs.table().rows[1].time.batch >= 1);
  CHECK(costs.caption(session).find("lie on the front") != std::string::npos);

  CHECK(costs.command(session, "chart_next"));
  CHECK(costs.caption(session).find(" s") != std::string::npos);  // a time with its unit
  CHECK(costs.command(session, "chart_next"));
  CHECK(costs.command(session, "chart_load"));
  CHECK_FALSE(costs.shown());
  CHECK(session.step() == session.steps());
}

TEST_CASE("what is ready stays when it is stopped, and other points are other figures") {
  Costs costs({.clock = now, .here = {}});
  lesson::Session session = opened(costs);
  session.answer({});
  REQUIRE(costs.command(session, "measure"));
  for (int slices = 0; costs.table().rows.empty() && slices < 10'000; ++slices) costs.work(session, 0);
  REQUIRE(costs.command(session, "stop_measuring"));
  CHECK(costs.table().rows.size() == 1);
  CHECK_FALSE(costs.running());
  CHECK(session.costs() == nullptr);
  REQUIRE(costs.command(session, "measure"));
  REQUIRE(session.move(0, {7, 7, 0}).has_value());
  finish(costs, session);
  CHECK(costs.table().rows.size() == 2);
  CHECK(session.costs() == nullptr);
}

TEST_CASE("a large file is measured whole and shown in part; above two million points it is refused") {
  Costs costs({.clock = now, .here = {}});
  lesson::Session session = opened(costs);
  session.answer({});
  REQUIRE(costs.load(session, cloud(6000), "large.xyz").has_value());
  CHECK(session.size() == 5000);
  CHECK(costs.size(session) == 6000);
  REQUIRE(costs.command(session, "measure"));
  finish(costs, session);
  CHECK(costs.table().rows[0].of == 6000);
  CHECK(costs.table().provenance.points == "large.xyz");
  const auto refused = costs.load(session, cloud(2'000'001), "huge.xyz");
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().message().find("2,000,001 points, and costs are measured on at most 2,000,000") != std::string::npos);
  CHECK(costs.size(session) == 6000);
  session.reset();
  CHECK(costs.size(session) == 5);
}

TEST_CASE("an earlier result lies over the present one, with marks of no row") {
  Costs costs({.clock = now, .here = {}});
  lesson::Session session = opened(costs);
  cost::CostRow row;
  row.volume = "sphere", row.algorithm = "ritter", row.time.median = 5, row.tightness = 1.1;
  costs.lay_over({{.points = "before"}, {row}});
  REQUIRE(costs.then() != nullptr);
  CHECK(costs.then()->provenance.points == "before");
  CHECK(costs.command(session, "chart_next"));
  CHECK_FALSE(costs.command(session, "chart_load"));  // it is no algorithm of this measurement
}

TEST_CASE("on the chart the arrow keys go from mark to mark") {
  CHECK(chart_command_for("ArrowRight", true) == "chart_next");
  CHECK(chart_command_for("ArrowRight", false).empty());
  CHECK(chart_command_for("Enter", true) == "chart_load");
  CHECK(chart_command_for("c", false) == "toggle_chart");
  CHECK(chart_command_for("m", false) == "measure");
}

}  // namespace
}  // namespace snug::app
