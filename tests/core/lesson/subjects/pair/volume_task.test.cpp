// What tasks on two volumes ask for, to the last digit; and what is asked of the boxes' tests.
#include <doctest/doctest.h>

#include <cmath>

#include "check/check_lesson.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects/pair/volumes.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

Session task_session(const std::string& algorithm, const std::string& volumes, const std::string& more = "") {
  auto lesson = check::checked_lesson(
      "version = 2\ntitle = \"Two\"\nsummary = \"Two.\"\nminutes = 1\nvolume = \"volume_pair\"\nalgorithms = [\"" +
          algorithm + "\"]\n[volumes]\n" + volumes + "[[section]]\ntitle = \"One\"\ntext = \"A text.\"\n" + more,
      "two.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  auto session = Session::open(*std::move(lesson));
  REQUIRE(session.has_value());
  return *std::move(session);
}

/// Two boxes in the plane: A from (0, 0) to (1, 1), and B with these bounds.
const Subject& put(Session& session, double x, double y, double right, double top) {
  REQUIRE(session.stage().set_rows({{0, 0, 1, 1}, {x, y, right, top}}).has_value());
  return session.stage().subject();
}

constexpr const char* kBoxes =
    "a = { aabb = { min = [0, 0], max = [1, 1] } }\nb = { aabb = { min = [0.5, 0.5], max = [2, 2] } }\n";

}  // namespace

TEST_CASE("boxes that only the last axis separates are apart along it by any gap, and along no other") {
  Session session = task_session("min_max", kBoxes);
  CHECK_FALSE(session.stage().subject().goals()->reaches("only_last_axis"));
  CHECK(put(session, 0.5, std::nextafter(1.0, 2.0), 2, 2).goals()->reaches("only_last_axis"));
  CHECK_FALSE(put(session, 0.5, 1, 2, 2).goals()->reaches("only_last_axis"));    // they touch
  CHECK_FALSE(put(session, 1.5, 1.5, 2, 2).goals()->reaches("only_last_axis"));  // along x as well
  CHECK_FALSE(put(session, 1.5, 0.5, 2, 2).goals()->reaches("only_last_axis"));  // along x alone
  CHECK(session.stage().subject().goals()->goal_says("only_last_axis") ==
        "Along x the intervals are apart; along y the intervals overlap.");
}

TEST_CASE("boxes touch along an axis where two bounds are equal to the last bit") {
  Session session = task_session("min_max", kBoxes);
  CHECK_FALSE(session.stage().subject().goals()->reaches("touch_on_one_axis"));
  CHECK(put(session, 1, 0.5, 2, 2).goals()->reaches("touch_on_one_axis"));
  CHECK(put(session, -1, -0.5, 0, 2).goals()->reaches("touch_on_one_axis"));
  CHECK_FALSE(put(session, std::nextafter(1.0, 2.0), 0.5, 2, 2).goals()->reaches("touch_on_one_axis"));
  CHECK_FALSE(put(session, std::nextafter(1.0, 0.0), 0.5, 2, 2).goals()->reaches("touch_on_one_axis"));
  CHECK_FALSE(put(session, 1, 1, 2, 2).goals()->reaches("touch_on_one_axis"));  // along both
  CHECK_FALSE(put(session, 1, 3, 2, 4).goals()->reaches("touch_on_one_axis"));  // and apart along the other
}

TEST_CASE("a slider lets two boxes touch to the last bit, however one was dragged before") {
  Session session = task_session("min_max",
                                 "a = { aabb = { min = [-1.25, -0.75], max = [0.75, 0.75] } }\n"
                                 "b = { aabb = { min = [-0.25, 0.25], max = [1.75, 1.25] } }\n",
                                 "[[slider]]\ntitle = \"Up\"\ndrives = \"A y\"\nfrom = -2\nto = 2\nsteps = 32\n");
  for (const double by : {0.1, 0.3, -0.7}) {
    REQUIRE(session.stage().move(0, session.stage().subject().at(0) + Vector<double, 3>(by / 3, by, 0)).has_value());
    REQUIRE(session.stage().slide(0, -0.5).has_value());
    CHECK(session.stage().subject().goals()->reaches("touch_on_one_axis"));
  }
}

TEST_CASE("spheres mislead a test that adds the squares of their radii where they overlap and it says no") {
  Session session = task_session("spheres", "a = { sphere = { center = [0, 0], radius = 1 } }\n"
                                            "b = { sphere = { center = [1, 0], radius = 1 } }\n");
  const auto at = [&](double x) {
    REQUIRE(session.stage().set_rows({{0, 0, 1}, {x, 0, 1}}).has_value());
    return session.stage().subject().goals()->reaches("sum_of_squares");
  };
  CHECK_FALSE(at(1.4));  // both say that they overlap
  CHECK(at(1.5));
  CHECK(at(2));  // they touch
  CHECK_FALSE(at(2.5));
  CHECK_FALSE(session.stage().subject().goals()->reaches("only_last_axis"));
}

TEST_CASE("two volumes overlap where the sum of their radii reaches from core to core") {
  Session session = task_session("swept_spheres", "a = { capsule = { a = [0, 0], b = [0, 1], radius = 0.5 } }\n"
                                                  "b = { capsule = { a = [1.5, 0], b = [1.5, 1], radius = 0.5 } }\n");
  CHECK_FALSE(session.stage().subject().goals()->reaches("overlap"));
  CHECK(session.stage().subject().goals()->goal_says("overlap") == "The volumes are apart by 0.500 units.");
  REQUIRE(session.stage().set_rows({{0, 0, 0, 1, 1.0625}, {1.5, 0, 1.5, 1, 0.5}}).has_value());
  CHECK(session.stage().subject().goals()->reaches("overlap"));  // though the radii add up to less than 1.6
  CHECK(session.stage().subject().goals()->goal_says("overlap") == "The volumes overlap.");
}

TEST_CASE("the first axis with a gap is asked of a test of two boxes, and of no other test") {
  const std::string question =
      "[[question]]\nid = \"q\"\nalgorithm = \"ALGORITHM\"\nbefore = \"overlap_decided\"\nafter = \"start\"\n"
      "asks = \"first_axis\"\nprompt = \"Which?\"\nbecause = \"So.\"\n";
  const auto asking = [&](const std::string& algorithm) {
    std::string text = question;
    return text.replace(text.find("ALGORITHM"), 9, algorithm);
  };
  for (const char* algorithm : {"min_max", "min_widths", "center_radius", "slabs"}) {
    Session session = task_session(algorithm, kBoxes, asking(algorithm));
    const auto truth = [&] {
      const Asked* asked = session.conversation().asked();
      REQUIRE(asked != nullptr);
      CHECK(asked->choices == std::vector<std::string>{"x", "y", "none"});
      return std::get<OneChoice>(model_answer(*asked, session.player().run(0))).choice;
    };
    session.jump(0);
    CHECK(truth() == 2);
    put(session, 0.5, 1.5, 2, 2), session.jump(0);
    CHECK(truth() == 1);
    put(session, 1.5, 1.5, 2, 2), session.jump(0);
    CHECK(truth() == 0);
  }
  const auto lesson = check::checked_lesson(
      "version = 2\ntitle = \"Two\"\nsummary = \"Two.\"\nminutes = 1\nvolume = \"volume_pair\"\n"
      "algorithms = [\"gjk\"]\n[volumes]\n" +
          std::string(kBoxes) + "[[section]]\ntitle = \"One\"\ntext = \"A text.\"\n" + asking("gjk"),
      "two.toml");
  REQUIRE_FALSE(lesson.has_value());
  CHECK(lesson.error().message().find("\"first_axis\" can only be asked of") != std::string::npos);
}
