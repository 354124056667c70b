// The board of small pictures and tables: measured in slices, sorted, picked, turned.
#include "app/subjects/criteria/criteria_board.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>

namespace snug::app {
namespace {

double ticking() {
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

constexpr std::string_view kCriteriaLesson = R"(version = 2
title = "Criteria"
summary = "For tests."
minutes = 1
chart = "criteria"
algorithms = ["sphere/welzl", "aabb/min_max", "hull/quickhull"]
reference = "hull/quickhull"

[points]
dim = 3
list = [[0, 0, 0], [4, 0, 0], [0, 3, 0], [0, 0, 2], [1, 1, 1]]

[load]
frames = 100

[[slider]]
title = "Frames"
drives = "frames"
from = 1
to = 1000

[[section]]
title = "One"
text = "Prose."

[[question]]
id = "least"
asks = "least"
figure = "total"
prompt = "Which?"
because = "So."
)";

lesson::Session opened_board() {
  auto lesson = lesson::read_lesson(kCriteriaLesson, "criteria.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  return *lesson::Session::open(*std::move(lesson));
}

void finish_board(CriteriaBoard& board, lesson::Session& session) {
  for (int slices = 0; board.running() && slices < 1'000'000; ++slices) board.work(session, 0);
  REQUIRE_FALSE(board.running());
}

std::vector<std::string> column(const WordTable& table, std::size_t i) {
  std::vector<std::string> cells;
  for (const auto& row : table.rows) cells.push_back(row[i]);
  return cells;
}

}  // namespace

TEST_CASE("the table is seen once the question is answered and all is measured, wherever the slider went meanwhile") {
  CriteriaBoard board({.clock = ticking, .here = {.version = "9"}});
  lesson::Session session = opened_board();
  CHECK(board.shown());
  CHECK(session.conversation().asked() == nullptr);
  REQUIRE(board.command(session, "measure"));  // the question comes first
  CHECK_FALSE(board.running());
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK_FALSE(board.command(session, "measure"));
  CHECK(board.table(session).rows.empty());
  REQUIRE(session.conversation().give(lesson::OneChoice{0}));
  CHECK(board.table(session).sorts.empty());
  REQUIRE(board.command(session, "measure"));
  CHECK_FALSE(board.command(session, "measure"));
  board.work(session, 0);
  REQUIRE(session.stage().slide(0, 500));
  finish_board(board, session);
  CHECK(board.decided(session));
  CHECK_FALSE(session.log().outcomes()[0].pending);
  const WordTable table = board.table(session);
  REQUIRE(table.rows.size() == 3);
  CHECK(table.sorts.size() == table.head.size());
  CHECK(table.picks.size() == table.rows.size());
  CHECK(table.picked == 0);
  for (const auto& row : table.rows) CHECK(row.size() == table.head.size());
  for (const auto& row : table.best) CHECK(row.size() == table.head.size());
  CHECK(board.file("csv").find("# snug table: which") == 0);
  CHECK(board.file("csv").find("total_ns.total") != std::string::npos);
  CHECK(board.file("json").find("\"welzl\"") != std::string::npos);
}

TEST_CASE("stopped, it has measured nothing; measured anew, all of it") {
  CriteriaBoard board({.clock = ticking, .here = {}});
  lesson::Session session = opened_board();
  session.conversation().ask_predictions();
  session.conversation().give({}, false);
  REQUIRE(board.command(session, "measure"));
  board.work(session, 0);
  REQUIRE(board.command(session, "stop_measuring"));
  CHECK_FALSE(board.running());
  CHECK_FALSE(board.decided(session));
  CHECK(board.file("csv").empty());
  REQUIRE(board.command(session, "measure"));
  REQUIRE(session.stage().move(0, {7, 7, 7}).has_value());
  finish_board(board, session);
  CHECK_FALSE(board.decided(session));  // other points stand there now
  session.stage().undo();
  CHECK(board.decided(session));
}

TEST_CASE("a column sorts its table, the least first, and once more restores the order; a row chooses its volume") {
  CriteriaBoard board({.clock = ticking, .here = {}});
  lesson::Session session = opened_board();
  session.conversation().ask_predictions();
  session.conversation().give({}, false);
  REQUIRE(board.command(session, "measure"));
  finish_board(board, session);
  const std::vector<std::string> names = column(board.table(session), 0);
  CHECK(names == std::vector<std::string>{"Sphere", "AABB", "Hull"});
  REQUIRE(board.command(session, "sort:2"));  // looseness
  CHECK(board.table(session).sorted == 2);
  const WordTable sorted = board.table(session);
  CHECK(column(sorted, 0).front() == "Hull");
  CHECK(sorted.best[0][2]);
  CHECK_FALSE(sorted.best[1][2]);
  REQUIRE(board.command(session, sorted.picks[0]));
  CHECK(session.player().method(0)->volume == "hull");
  CHECK(board.table(session).picked == 0);
  CHECK(board.caption(session).find("Hull: T = ") == 0);
  REQUIRE(board.command(session, "sort:2"));
  CHECK(column(board.table(session), 0) == names);
  REQUIRE(board.command(session, "next_volume"));  // after the last comes the first
  CHECK(session.player().method(0)->volume == "sphere");
  for (const char* wrong : {"sort:", "sort:x", "sort:8", "sort:-1", "pick:3", "pick:", "show_nothing"})
    CHECK_FALSE(board.command(session, wrong));
  for (const char* kind : {"show_total", "show_ranks"}) {
    REQUIRE(board.command(session, kind));
    CHECK(board.table(session).sorted == -1);  // each table has its own order
  }
}

TEST_CASE("of a large file a part is taken, and a table is no points") {
  CriteriaBoard board({.clock = ticking, .here = {}});
  lesson::Session session = opened_board();
  io::PointFile file;
  for (int i = 0; i < 6000; ++i) file.points.emplace_back(i % 7, i % 11, i % 13);
  REQUIRE(board.load(session, file, "large.xyz").has_value());
  CHECK(session.stage().subject().size() == 5000);
  const auto laid = board.lay_over(session, "# snug table: costs\n", "costs.csv");
  REQUIRE(laid.has_value());
  CHECK_FALSE(laid->has_value());
  CHECK_FALSE(board.lay_over(session, "1 2 3\n", "points.xyz").has_value());
}

TEST_CASE("a drag turns the gaze, not over the poles") {
  const Gaze right = turned({}, 100, 0), up = turned({}, 0, 1e6);
  CHECK(right.yaw < Gaze{}.yaw);
  CHECK(right.pitch == Gaze{}.pitch);
  CHECK(up.pitch < 1.5);
}

}  // namespace snug::app
