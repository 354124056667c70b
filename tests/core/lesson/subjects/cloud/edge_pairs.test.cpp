// How far the exact search for the smallest box has come, in figures and in its sentence.
#include "lesson/subjects/cloud/edge_pairs.hpp"

#include <doctest/doctest.h>

#include "core/lesson/lesson_files.hpp"
#include "lesson/session.hpp"

using namespace snug;
using namespace snug::lesson;

TEST_CASE("the pairs of edges that are left fall to none, and each sentence says how many there are") {
  Session session = test::session_of("obb-fitting");
  REQUIRE(session.player().choose(0, "exact").has_value());
  const auto figure = [&](std::string_view key) {
    for (const Figure& one : session.telling().figures())
      if (one.key == key) return one.value;
    return -1.0;
  };
  double before = figure("pairs_left");
  int edges = 0;
  for (int step = 1; step <= session.player().steps(); ++step) {
    session.jump(step);
    const double left = figure("pairs_left");
    REQUIRE(left >= 0);
    CHECK((before < 0 || left <= before));
    before = left;
    if (session.player().run(0).fact(step - 1) != "edge_searched") continue;
    ++edges;
    const std::string sentence = session.player().run(0).sentence(step - 1, {});
    CAPTURE(sentence);
    const std::string text = left == 0 ? "no pair is left" : std::to_string(static_cast<int>(left)) + " of ";
    CHECK(sentence.find(text) != std::string::npos);
    CHECK(sentence.find("Best so far: volume ") != std::string::npos);
  }
  CHECK(edges > 10);
  CHECK(before == 0);
  CHECK(figure("halvings") > 0);
  CHECK(figure("pairs_ruled_out") > 0);
  REQUIRE(session.player().choose(0, "pca").has_value());
  session.jump(session.player().steps());
  CHECK(figure("pairs_left") == -1);
}
