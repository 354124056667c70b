// The lesson kind with the chart of costs: read, asked before it is measured, decided by what was measured, graded.
#include "lesson/subjects/cost/cost.hpp"

#include "check/check_lesson.hpp"
#include "check/play.hpp"
#include "core/lesson/small_lesson.hpp"
#include "lesson/kept_answers.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

constexpr std::string_view kChart = R"(version = 2
title = "Chart"
summary = "A chart for tests."
minutes = 1
volume = "obb"
chart = "cost"
algorithms = ["pca", "aabb", "exact"]
generators = ["stick"]

[points]
list = [[0, 0], [4, 1], [3, 3], [1, 2]]

[[section]]
title = "One"
text = "Prose."

[[question]]
id = "front"
asks = "on_front"
prompt = "Which?"
because = "So."

[[question]]
id = "slowest"
asks = "slowest"
prompt = "Which one?"
because = "So."

[[question]]
id = "times"
asks = "times_slower"
prompt = "How many times?"
because = "So."

[[task]]
prompt = "Tighter."
algorithm = "aabb"
points = 12
hint = "Click."
model = [[0, 0], [4, 4], [3, 4.5], [-0.5, 0.5]]

[[task.require]]
figure = "tighter"
at_least = 5
)";

Session opened() {
  auto lesson = check::checked_lesson(kChart, "chart.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  auto session = Session::open(*std::move(lesson));
  REQUIRE(session.has_value());
  return *std::move(session);
}

std::string with(std::string_view old_words, std::string_view new_words) {
  std::string text(kChart);
  const std::size_t at = text.find(old_words);
  REQUIRE(at != std::string::npos);
  return text.replace(at, old_words.size(), new_words);
}

cost::CostRow row(const char* algorithm, double time, double size, Index points = 4, Index of = 4) {
  cost::CostRow row;
  row.volume = "obb", row.algorithm = algorithm, row.time.median = time, row.points = points, row.of = of;
  row.time.repeats = 9, row.time.spread = 0.01, row.time.trusted = true;
  row.size = row.measure = size;
  return row;
}

void measured(Session& session, const std::vector<cost::CostRow>& rows) {
  REQUIRE(session.inform<CostSubject>([&](CostSubject& chart) { chart.measured(rows); }));
}

std::vector<cost::CostRow> rows() { return {row("pca", 100, 12), row("aabb", 50, 10), row("exact", 9000, 8)}; }

}  // namespace

TEST_CASE("a lesson with the chart is read, and its model answers are sound by operations alone") {
  Session session = opened();
  CHECK(session.lesson().subject == &kCostRow);
  session.last();
  for (const Figure& figure : session.telling().figures())
    CHECK(figure.key != "excess");  // the chart tells it, and what it costs
  session.go(0);
  CHECK(session.player().rivals().empty());
  const auto played = check::play(session);
  REQUIRE(played.has_value());
  CHECK(played->sound());
  CHECK(played->algorithms.front().outcomes.size() == 3);
}

TEST_CASE("a chart can be asked a choice of one's own, which waits for the measurement as well") {
  const std::string text = with("[[question]]\nid = \"front\"\nasks = \"on_front\"",
                                "[[question]]\nid = \"own\"\nasks = \"choice\"\nchoices = [\"Yes\", \"No\"]\n"
                                "answer = \"No\"\nholds = \"always\"");
  auto lesson = check::checked_lesson(text, "chart.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  auto session = Session::open(*std::move(lesson));
  REQUIRE(session.has_value());
  session->conversation().ask_predictions();
  REQUIRE(session->conversation().give(OneChoice{1}));
  CHECK(session->log().outcomes()[0].pending);
  measured(*session, rows());
  CHECK(session->log().outcomes()[0].right);
}

TEST_CASE("what is decided by counted operations speaks of them, and what is measured of time") {
  Session session = opened();
  const auto played = check::play(session);
  REQUIRE(played.has_value());
  CHECK(played->algorithms.front().outcomes[1].says.find(" times as many operations as ") != std::string::npos);
  CHECK(played->grades[0].says.find(" times the operations. Done.") != std::string::npos);
  CHECK(played->grades[0].says.find("time.") == std::string::npos);
  const std::vector<cost::CostRow> counted = counted_costs(session.lesson(), *session.stage().subject().points());
  CHECK(grade_costs(session.lesson().tasks[0], counted, "aabb").says.find("in the fewest operations.") !=
        std::string::npos);
  CHECK(grade_costs(session.lesson().tasks[0], rows(), "aabb").says.find("in the least time.") != std::string::npos);
  CHECK(grade_costs(session.lesson().tasks[0], rows(), "exact").says.find(" times the time.") != std::string::npos);
}

TEST_CASE("what such a lesson gets wrong is said with its line") {
  const auto line = [](const std::string& text) {
    const auto lesson = check::checked_lesson(text, "chart.toml");
    REQUIRE_FALSE(lesson.has_value());
    return lesson.error().message();
  };
  CHECK(line(with("asks = \"slowest\"", "asks = \"point\"")).find("chart.toml:25: ") == 0);
  CHECK(line(with("chart = \"cost\"", "chart = \"pie\"")).find("chart.toml:6: ") == 0);
  CHECK(line(with("at_least = 5", "at_least = 90")).find("no algorithm's result is smaller by as much") !=
        std::string::npos);
  CHECK(line(with("chart = \"cost\"\n", "")).find("chart.toml:") == 0);
}

TEST_CASE(
    "predictions stand until all is measured, wherever the player is, and then what happened stands beside them") {
  Session session = opened();
  CHECK(session.conversation().asked() == nullptr);  // first seen, then asked
  session.conversation().ask_predictions();
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK(session.conversation().asked()->many);
  CHECK(session.conversation().asked()->choices.size() == 3);
  CHECK_FALSE(session.conversation().give(OneChoice{8}));
  CHECK(session.conversation().give(SeveralChoices{{1, 2}}));
  session.last();
  CHECK(session.player().step() == session.player().steps());  // steps give nothing away
  CHECK(session.conversation().asked()->question->id == "slowest");
  CHECK_FALSE(session.conversation().give(OneChoice{3}));
  CHECK(session.conversation().give(OneChoice{0}));
  CHECK(session.conversation().give(Skipped{}));
  CHECK(session.conversation().asked() == nullptr);
  for (const Outcome& outcome : session.log().outcomes()) CHECK(outcome.pending);
  auto part = rows();
  part.pop_back();
  measured(session, part);
  CHECK(session.log().outcomes()[0].pending);

  measured(session, rows());
  const auto& outcomes = session.log().outcomes();
  CHECK_FALSE(outcomes[0].pending);
  CHECK(outcomes[0].right);
  CHECK(outcomes[0].happened == "Axis-aligned box and Exact minimum");
  CHECK_FALSE(outcomes[1].right);
  CHECK(outcomes[1].happened == "Exact minimum");
  CHECK(outcomes[2].skipped);
  CHECK(outcomes[2].happened == "180 times");
}

TEST_CASE("several choices that were kept as bits are read as the question means them") {
  Session session = opened();
  take_up(session, kept_answers_of("[[answer]]\nquestion = \"front\"\nkind = \"choice\"\nvalue = 6\nfrom_step = 0\n"
                                   "step = 0\npending = true\n"));
  REQUIRE(session.log().outcomes().size() == 1);
  const Outcome kept = session.log().outcomes().front();
  CHECK(kept.given == Answer(SeveralChoices{{1, 2}}));
  CHECK(kept_text({{kept}, {}}).find("kind = \"choice\"\nvalue = 6\n") != std::string::npos);
  measured(session, rows());
  CHECK(session.log().outcomes().front().right);
}

TEST_CASE("a later measurement decides anew, and a front with an unreliable time is not decided") {
  Session session = opened();
  session.conversation().ask_predictions();
  session.conversation().give(SeveralChoices{{1, 2}});
  session.conversation().give(OneChoice{2});
  session.conversation().give(Skipped{});
  measured(session, rows());
  CHECK(session.log().outcomes()[0].right);
  auto without = rows();  // Exact became too slow for all points
  without[2] = row("exact", 20, 1, 2, 4);
  without[2].whole_ns = 1e6;
  measured(session, without);
  CHECK(session.log().outcomes()[0].happened.find(" and ") == std::string::npos);
  CHECK_FALSE(session.log().outcomes()[0].right);

  auto doubtful = rows();
  doubtful[0].time.trusted = false;
  measured(session, doubtful);
  CHECK(session.log().outcomes()[0].pending);
  CHECK(session.log().outcomes()[0].happened.empty());
  CHECK(session.log().outcomes()[0].says.find(" could not be measured reliably") != std::string::npos);
  CHECK(session.log().outcomes()[0].says.find(" and ") == std::string::npos);
  doubtful[1].time.trusted = false;
  measured(session, doubtful);
  CHECK(session.log().outcomes()[0].says.find(" and ") != std::string::npos);  // it names both
  CHECK_FALSE(session.log().outcomes()[1].pending);                            // the slowest is so by far
  measured(session, rows());
  CHECK(session.log().outcomes()[0].right);
}

TEST_CASE("what was measured on fewer points is never on the front, and its time is that of all") {
  Session session = opened();
  session.conversation().ask_predictions();
  session.conversation().give(SeveralChoices{{0, 1}});
  session.conversation().give(OneChoice{2});
  session.conversation().give(OneChoice{3});
  auto few = rows();
  few[1] = row("aabb", 60, 9);
  few[2] = row("exact", 20, 1, 2, 4);
  few[2].whole_ns = 1e6;
  measured(session, few);
  CHECK(session.log().outcomes()[0].happened == "Axis-aligned box");
  CHECK(session.log().outcomes()[1].right);
  CHECK(session.log().outcomes()[2].right);
}

TEST_CASE("the task: a shape of one's own, measured, and the cheapest that is tight enough on the stage") {
  Session session = opened();
  const Task& task = session.lesson().tasks[0];
  CHECK(session.grade()->says.find("lesson's own shape") != std::string::npos);
  measured(session, rows());
  CHECK_FALSE(session.grade()->done);
  session.stage().start_task();
  CHECK(session.stage().subject().size() == 12);
  CHECK(session.conversation().asked() == nullptr);  // the questions are of the lesson's own
  CHECK(session.grade()->says == "Measure this shape.");
  measured(session, rows());
  CHECK(session.grade()->says.find("Axis-aligned box is on the stage") == 0);
  REQUIRE(session.player().choose(0, "exact").has_value());
  CHECK(session.grade()->done);
  CHECK(session.grade()->says == "Exact minimum: 20.0 % smaller than Axis-aligned box, in 180 times the time. Done.");
  REQUIRE(session.player().choose(0, "pca").has_value());
  CHECK_FALSE(session.grade()->done);
  CHECK(session.grade()->says.find("20.0 % larger") != std::string::npos);

  auto cheaper = rows();
  cheaper[0].size = 9.5;
  CHECK(cheapest_of(task, cheaper) == "pca");
  CHECK_FALSE(grade_costs(session.lesson().tasks[0], cheaper, "exact").done);
  auto tied = cheaper;
  tied[2].time.median = 102;  // as fast as the cheapest, but for noise
  CHECK(grade_costs(session.lesson().tasks[0], tied, "exact").done);
  auto flat = cheaper;
  for (cost::CostRow& one : flat) one.noise = 20;
  CHECK(cheapest_of(task, flat).empty());  // sizes that are nothing but rounding are not compared
  cheaper[0].points = 2;                   // of other points nothing can be said
  CHECK(cheapest_of(task, cheaper) == "exact");
  CHECK(grade_costs(session.lesson().tasks[0], cheaper, "pca").says.find("fewer points") != std::string::npos);
  REQUIRE(session.stage().move(0, {9, 9, 0}).has_value());
  CHECK(costs_of(session) == nullptr);  // other points: what was measured is not theirs
  CHECK(session.grade()->says == "Measure this shape.");
}
