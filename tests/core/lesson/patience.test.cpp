// How long a lesson would take is estimated from a few of its points, and what takes long goes in pieces.
#include "lesson/patience.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cmath>

#include "check/check_lesson.hpp"
#include "core/lesson/small_lesson.hpp"
#include "lesson/session.hpp"

using namespace snug;
using namespace snug::lesson;
using namespace snug::test;

namespace {

double g_now = 0;
/// Each look at the clock is so much later.
double g_step = 0;

double ticking() { return g_now += g_step; }
double standing() { return g_now; }

/// How often the clock was looked at, and at which looks the machine is slow.
int g_looks = 0, g_slow_from = 0, g_slow_until = 0;

double hindered() {
  const bool slow = g_looks >= g_slow_from && g_looks < g_slow_until;
  ++g_looks;
  return g_now += slow ? 3e9 : 1e3;
}

Session open_small(Clock clock) {
  auto lesson = read_lesson(kSmallLesson, "small.toml");
  REQUIRE(lesson.has_value());
  auto session = Session::open(*std::move(lesson), {}, clock);
  REQUIRE(session.has_value());
  return *std::move(session);
}

/// Begins an edit that stays to be done, because every piece takes longer than is given at once.
void begin_long_edit(Session& session) {
  g_step = 0.15e9;
  session.stage().give_way(true);
  REQUIRE(session.stage().set_generator("cube", 3'000, 2, 3).has_value());
  REQUIRE(session.stage().preparing() != nullptr);
}

}  // namespace

TEST_CASE("the growth of a time is followed to all points") {
  for (const double power : {1.0, 1.5, 2.0, 3.0}) {
    const auto time_of = [&](Index n) { return 1000 * std::pow(n, power); };
    GrowingTime growth;
    for (const Index some : {250, 500, 1000}) growth.add(some, time_of(some));
    CHECK(growth.on(8000) == doctest::Approx(time_of(8000)).epsilon(0.01));
    const double possible = std::pow(kLongestShown / 1000, 1 / power);
    const auto most = static_cast<double>(growth.most_in(kLongestShown));
    CHECK((most <= possible * 1.01 && most > possible / 2));
  }
}

TEST_CASE("of a method that takes next to no time, as many points as there can be are shown") {
  GrowingTime growth;
  for (const Index some : {250, 500, 1000}) growth.add(some, 1);
  CHECK(growth.most_in(kLongestShown) == 2'000'000'000);
}

TEST_CASE("times that are noise tell nothing") {
  GrowingTime growth;
  for (const Index some : {250, 500}) growth.add(some, 1e9);
  CHECK_FALSE(growth.tells());  // two times have no growth
  growth.add(1000, 1e9);
  CHECK(growth.tells());
  growth.add(2000, 1e3);
  CHECK_FALSE(growth.tells());
}

TEST_CASE("points that a lesson cannot show in time are refused with how many it can, and the stage stays") {
  Session session = open_small(&ticking);
  g_step = 3e9;  // each measured piece takes three seconds
  const Index before = session.stage().subject().size();
  const Done done = session.stage().set_generator("cube", 50'000, 2, 3);
  REQUIRE_FALSE(done.has_value());
  CHECK(done.error().what.find("would take about") != std::string::npos);
  CHECK(done.error().what.find("50,000 such points") != std::string::npos);
  CHECK(session.stage().subject().size() == before);
  g_step = 1;
  CHECK(session.stage().set_generator("cube", 5'000, 2, 3).has_value());
  CHECK(session.stage().subject().size() == 5'000);
}

TEST_CASE("a slow moment of the machine refuses nothing: before that, the same points are measured again") {
  Session session = open_small(&hindered);
  g_looks = 0, g_slow_from = 0, g_slow_until = 1 << 30;
  REQUIRE_FALSE(session.stage().set_generator("cube", 50'000, 2, 3).has_value());
  const int round = g_looks / 4;  // three times more and more points, and the last of them again
  g_looks = 0, g_slow_from = 2 * round, g_slow_until = 3 * round;
  CHECK(session.stage().set_generator("cube", 50'000, 2, 3).has_value());
  CHECK(g_looks > g_slow_until);
}

TEST_CASE("an edit that takes long goes in pieces, and the stage stays until all is there") {
  Session session = open_small(&ticking);
  Session at_once = open_small(&standing);
  const Index before = session.stage().subject().size();
  begin_long_edit(session);
  double share = 0;
  int pieces = 0;
  bool moves = true;
  for (; session.stage().preparing() != nullptr; ++pieces) {
    REQUIRE(pieces < 1000);
    moves = moves && session.stage().preparing()->share() >= share && session.stage().preparing()->share() <= 1;
    share = session.stage().preparing()->share();
    CHECK(session.stage().preparing()->says().find("Working on 3,000 points") == 0);
    CHECK(session.stage().subject().size() == before);
    g_step = 1e6;
    REQUIRE(session.stage().go_on(0).has_value());
  }
  CHECK(moves);
  CHECK(pieces > 5);
  CHECK(session.stage().subject().size() == 3'000);
  // What was computed in pieces is what is computed at once.
  REQUIRE(at_once.stage().set_generator("cube", 3'000, 2, 3).has_value());
  CHECK(session.player().trace_hash() == at_once.player().trace_hash());
  REQUIRE(session.player().rivals().size() == at_once.player().rivals().size());
  for (std::size_t i = 0; i < session.player().rivals().size(); ++i) {
    CHECK(session.player().rivals()[i].method == at_once.player().rivals()[i].method);
    CHECK(session.player().rivals()[i].size == at_once.player().rivals()[i].size);
  }
  session.stage().undo();
  CHECK(session.stage().subject().size() == before);
  CHECK(session.stage().is_own());
}

TEST_CASE("an edit that is given up changes nothing, and can be made again") {
  Session session = open_small(&ticking);
  const std::uint64_t trace = session.player().trace_hash();
  begin_long_edit(session);
  session.stage().give_up();
  CHECK(session.stage().preparing() == nullptr);
  CHECK(session.player().trace_hash() == trace);
  CHECK(session.stage().is_own());
  CHECK_FALSE(session.stage().can_undo());
  g_step = 1;
  CHECK(session.stage().set_generator("cube", 3'000, 2, 3).has_value());
  CHECK(session.stage().subject().size() == 3'000);
}

TEST_CASE("undo and redo of many points go in pieces as well, and giving one up keeps both ways") {
  Session session = open_small(&ticking);
  session.stage().give_way(true);
  g_step = 1;
  REQUIRE(session.stage().set_generator("cube", 3'000, 2, 3).has_value());
  REQUIRE(session.stage().set_generator("cube", 4'000, 2, 3).has_value());
  g_step = 0.15e9;
  session.stage().undo();
  REQUIRE(session.stage().preparing() != nullptr);
  session.stage().give_up();
  CHECK(session.stage().subject().size() == 4'000);
  CHECK((session.stage().can_undo() && !session.stage().can_redo()));
  g_step = 1;
  session.stage().undo();
  CHECK(session.stage().subject().size() == 3'000);
  session.stage().redo();
  CHECK(session.stage().subject().size() == 4'000);
}

TEST_CASE("a door that waits longer shows more points, and says what can be done with more than that") {
  struct OfPage {
    ~OfPage() { patience() = {}; }
  } again;
  const auto fit = [](double step) {
    Session session = open_small(&ticking);
    session.stage().give_way(true);
    g_step = step;
    Done done = session.stage().set_generator("cube", 3'000, 2, 3);
    double left = 0;
    for (; done && session.stage().preparing() != nullptr; done = session.stage().go_on(0))
      left = std::max(left, session.stage().preparing()->left());
    return std::pair(done ? std::string() : done.error().what, left);
  };
  CHECK(fit(1e9).first.find("take less than 10 s here") != std::string::npos);
  patience() = {.shown = 900e9, .held = 60e9, .instead = "; try less"};
  const auto [refused, left] = fit(1e9);
  CHECK(refused.empty());
  CHECK(left > 10e9);  // it is told how long it takes still
  const std::string what = fit(100e9).first;
  CAPTURE(what);
  CHECK(what.find("take less than 15 min here; try less") != std::string::npos);
}

TEST_CASE("one piece that would hold the page is refused, with how many points can be shown") {
  Session session = open_small(&ticking);
  session.stage().give_way(true);
  g_step = 0.1e9;  // of each piece at an eighth of the points: less than ten seconds for all, but too long for one
  Done done = session.stage().set_generator("cube", 3'000, 2, 3);
  while (done && session.stage().preparing() != nullptr) done = session.stage().go_on(0);
  REQUIRE_FALSE(done.has_value());
  CAPTURE(done.error().what);
  CHECK(done.error().what.find("would take about 3.2 s for 3,000 such points, and could not be stopped") !=
        std::string::npos);
  CHECK(done.error().what.find("up to about 1,000 can be shown here") != std::string::npos);
  CHECK(session.stage().is_own());
  CHECK_FALSE(session.stage().can_undo());
}
