// A lesson on one update: the body is rotated by hand, and each step of a climb is one that can be asked about.
#include "lesson/subjects/update/update.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "check/check_lesson.hpp"
#include "check/play.hpp"
#include "geometry/turn.hpp"
#include "lesson/session.hpp"

using namespace snug;
using lesson::Point3;

namespace {

/// A flat hexagon, rotated by 40 degrees; a question about each kind of step.
std::string text(const std::string& algorithms, const std::string& more = "") {
  return R"(version = 2
title = "Small"
summary = "A lesson for tests."
minutes = 3
volume = "update"
seed = 5
algorithms = [)" +
         algorithms + R"(]

[points]
list = [[2, 0], [1, 1], [-1, 1], [-2, 0], [-1, -1], [1, -1], [0.1, 0]]

[body]
turn = 40

[[section]]
title = "First"
text = "A **term**."
)" + more;
}

lesson::Session opened(const std::string& algorithm, const std::string& more = "") {
  auto lesson = check::checked_lesson(text('"' + algorithm + '"', more), "small.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  auto session = lesson::Session::open(*std::move(lesson));
  REQUIRE(session.has_value());
  return *std::move(session);
}

const lesson::UpdateRun& run_of(const lesson::Session& session) { return lesson::update_run(session.player().run(0)); }

double figure(const lesson::Session& session, std::string_view key) {
  for (const lesson::Figure& figure : session.telling().figures())
    if (figure.key == key && figure.known) return figure.value;
  return -1;
}

Index handle(const lesson::Session& session, std::string_view name) {
  for (Index i = 0; i < session.stage().subject().size(); ++i)
    if (session.stage().subject().name_of(i) == name) return i;
  return kNoIndex;
}

/// The names of the steps.
std::vector<std::string> facts(const lesson::Session& session) {
  std::vector<std::string> names;
  for (int i = 0; i < session.player().steps(); ++i) names.emplace_back(session.player().run(0).fact(i));
  return names;
}

}  // namespace

TEST_CASE("each update's steps are those of the update, once for the body and then for the frame") {
  CHECK(facts(opened("loose")) == std::vector<std::string>{"reach_found", "center_moved", "volume_updated"});
  CHECK(facts(opened("rotated_box")) == std::vector<std::string>{"bounds_rotated", "bounds_rotated", "volume_updated"});
  CHECK(facts(opened("sphere")) == std::vector<std::string>{"center_moved", "volume_updated"});
  const auto rebuilt = facts(opened("rebuild"));
  CHECK(std::count(rebuilt.begin(), rebuilt.end(), "point_placed") >= 3);
  const auto climbed = facts(opened("hill_climb"));
  CHECK(std::count(climbed.begin(), climbed.end(), "extreme_climbed") == 4);
  CHECK(std::count(climbed.begin(), climbed.end(), "neighbors_compared") > 4);
}

TEST_CASE("a climb names the body's points, and ends at the extreme in the world") {
  lesson::Session session = opened("hill_climb");
  const lesson::UpdateRun& run = run_of(session);
  for (const auto& entry : run.trace()) {
    const auto* climbed = std::get_if<fit::ExtremeClimbed>(&entry.step.fact);
    if (climbed == nullptr) continue;
    const double sign = climbed->greatest ? 1 : -1;
    const auto along = [&](Index i) { return sign * session.stage().subject().at(i)[climbed->axis]; };
    for (Index i = 0; i < 7; ++i) CHECK(along(i) <= along(climbed->path.back()));
    for (std::size_t i = 1; i < climbed->path.size(); ++i) {
      CHECK(along(climbed->path[i]) > along(climbed->path[i - 1]));
      const Index apart = std::abs(climbed->path[i] - climbed->path[i - 1]);
      CHECK((apart == 1 || apart == 5));  // the hexagon's points are listed in order around it
    }
  }
  CHECK(run.recording().corners == std::vector<Index>{0, 1, 2, 3, 4, 5});
  const lesson::BodyStep& last = run.trace().back().step;
  const auto& box = *std::get_if<Aabb<double, 3>>(&last.volume);
  for (Index i = 0; i < 7; ++i)
    for (int axis = 0; axis < 2; ++axis) {
      CHECK(session.stage().subject().at(i)[axis] <= box.max[axis]);
      CHECK(session.stage().subject().at(i)[axis] >= box.min[axis]);
    }
}

TEST_CASE("the points that a climb examines are those that its steps name") {
  lesson::Session session = opened("hill_climb");
  std::int64_t examined = 0;
  for (const auto& entry : run_of(session).trace()) {
    if (const auto* walk = std::get_if<fit::NeighborsCompared>(&entry.step.fact))
      examined += std::ssize(walk->neighbors);
    if (std::holds_alternative<fit::ExtremeClimbed>(entry.step.fact)) ++examined;  // where it began
  }
  session.last();
  CHECK(figure(session, "cost") == static_cast<double>(examined));
}

TEST_CASE("the body is rotated by its knob, and moved by its pivot; its local frame stays") {
  lesson::Session session = opened("rebuild");
  const Index turn = handle(session, "Body turn"), body = handle(session, "Body");
  REQUIRE(turn != kNoIndex);
  REQUIRE(body != kNoIndex);
  CHECK(handle(session, "Body roll") == kNoIndex);
  CHECK(session.stage().subject().at(1)[0] == doctest::Approx(std::cos(0.698131700798) - std::sin(0.698131700798)));
  REQUIRE(session.stage().move(turn, {0, 5, 0}));  // straight up: a quarter turn
  session.last();
  CHECK(figure(session, "turn") == doctest::Approx(90));
  CHECK((session.stage().subject().at(0) - Point3(0, 2, 0)).norm() < 1e-12);
  CHECK(figure(session, "measure") == doctest::Approx(8));  // 2 by 4
  CHECK(lesson::body_of(session.stage().subject()).points() != nullptr);
  CHECK(fit::point_of(*session.stage().subject().points(), 0) == Point3(2, 0, 0));
  REQUIRE(session.stage().move(body, {3, 1, 0}));
  CHECK((session.stage().subject().at(0) - Point3(3, 3, 0)).norm() < 1e-12);
  CHECK(figure(session, "measure") == doctest::Approx(8));
  REQUIRE(session.stage().move(0, {3, 4, 0}));  // a point in the world
  CHECK((fit::point_of(*session.stage().subject().points(), 0) - Point3(3, 0, 0)).norm() < 1e-12);
  CHECK_FALSE(session.stage().subject().clone()->with_points()->remove(turn).has_value());
}

TEST_CASE("rows keep the points and the pose, to the last bit") {
  lesson::Session session = opened("loose");
  REQUIRE(session.stage().move(handle(session, "Body turn"), {1.7, -3.1, 0}));
  REQUIRE(session.stage().move(handle(session, "Body"), {0.3, 0.1, 0}));
  auto other = opened("loose").stage().subject().clone();
  REQUIRE(other->set_rows(session.stage().subject().rows()).has_value());
  CHECK(other->rows() == session.stage().subject().rows());
  for (Index i = 0; i < session.stage().subject().size(); ++i) CHECK(other->at(i) == session.stage().subject().at(i));
  lesson::Rows twice = session.stage().subject().rows();
  twice.push_back(twice.back());
  CHECK_FALSE(other->set_rows(twice).has_value());
}

TEST_CASE("a slider rotates the body to so many degrees") {
  const auto subject = opened("loose").stage().subject().clone();
  REQUIRE(subject->drive("turn", 40, -90).has_value());
  CHECK((subject->at(0) - Point3(0, -2, 0)).norm() < 1e-12);
  const auto drives = subject->drives();
  CHECK(std::any_of(drives.begin(), drives.end(), [](const lesson::Drive& one) {
    return one.name == "turn" && one.now && std::abs(*one.now + 90) < 1e-9;
  }));
}

TEST_CASE("the looseness of each is what geometry says, and the tightest is as tight as the rebuilt") {
  const auto slack = [](const char* method, double degrees) {
    lesson::Session session = opened(method);
    const Point3 to = snug::turn(Point3::UnitZ(), degrees * 0.017453292519943295) * Point3(5, 0, 0);
    REQUIRE(session.stage().move(handle(session, "Body turn"), to));
    session.last();
    return figure(session, "slack");
  };
  CHECK(slack("rebuild", 33) == 0);
  CHECK(slack("hill_climb", 33) < 1e-9);
  CHECK(slack("rotated_box", 0) == 0);
  CHECK(slack("loose", 0) == doctest::Approx(100));  // 4 by 4 around 4 by 2
  CHECK(slack("rotated_box", 90) == doctest::Approx(0));
  CHECK(slack("rotated_box", 45) == doctest::Approx(100 * (18.0 / 8 - 1)));  // (4 + 2)^2 / 2 around (2 sqrt 2)^2
}

TEST_CASE("the next vertex is asked for by pointing, among the vertices of the hull") {
  lesson::Session session = opened("hill_climb", R"(
[[question]]
id = "next"
algorithm = "hill_climb"
before = "neighbors_compared"
asks = "point"
prompt = "Which is next?"
because = "It reaches farthest."

[[question]]
id = "extreme"
algorithm = "hill_climb"
before = "neighbors_compared"
nth = 2
asks = "extreme"
prompt = "Is it the extreme?"
because = "No neighbour reaches farther."
)");
  session.go(0);
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK(session.conversation().asked()->on_stage);
  CHECK(session.conversation().asked()->stage_points == std::vector<Index>{0, 1, 2, 3, 4, 5});
  const auto& walk = *std::get_if<fit::NeighborsCompared>(&run_of(session).trace()[0].step.fact);
  const lesson::Answer right = lesson::model_answer(*session.conversation().asked(), session.player().run(0));
  CHECK(lesson::names_handle(right, walk.best));
  const auto& next = *std::get_if<fit::NeighborsCompared>(&run_of(session).trace()[2].step.fact);
  for (const lesson::Asked& asked : session.conversation().questions())
    if (asked.question->id == "extreme")
      CHECK(lesson::model_answer(asked, session.player().run(0)) ==
            lesson::Answer(lesson::OneChoice{next.best == next.vertex ? 0 : 1}));
}

TEST_CASE("the looseness over a whole turn is that of the updates at its poses") {
  lesson::Session session = opened("rotated_box");
  const Index turn = handle(session, "Body turn");
  const auto curve = lesson::body_of(session.stage().subject()).slack_over_turn(*session.player().method(0), 8);
  REQUIRE(curve.size() == 9);
  CHECK(curve.front() == doctest::Approx(curve.back()));
  CHECK(curve[4] == doctest::Approx(0));  // the local AABB itself
  const Point3 pivot = session.stage().subject().at(handle(session, "Body"));
  const double reach = (session.stage().subject().at(turn) - pivot).norm();
  for (int i = 1; i < 8; ++i) {
    const double radians = (i - 4) * std::acos(-1.0) / 4;
    REQUIRE(session.stage().move(turn, pivot + reach * Point3(std::cos(radians), std::sin(radians), 0)).has_value());
    session.last();
    CHECK(figure(session, "slack") == doctest::Approx(100 * curve[i]).epsilon(1e-6));
  }
  for (const double loose : lesson::body_of(session.stage().subject()).slack_over_turn(*session.player().method(0), 8))
    CHECK(loose >= 0);
}
