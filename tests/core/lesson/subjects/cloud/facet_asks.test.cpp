// Questions that an edge, a face or a slab answers, on points whose answers can be worked out by hand.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "check/check_lesson.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects/cloud/calipers_turn.hpp"
#include "lesson/subjects/cloud/fit_run.hpp"
#include "lesson/words.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

std::string lesson_of(const std::string& points, const std::string& algorithm, const std::string& before,
                      const std::string& asks, int nth = 1) {
  return "version = 2\ntitle = \"T\"\nsummary = \"S.\"\nminutes = 1\ncovers = []\nalgorithms = [\"" + algorithm +
         "\"]\n[points]\n" + points + "\n[[section]]\ntitle = \"A\"\ntext = \"Words.\"\n[[question]]\nid = \"own\"\n" +
         "algorithm = \"" + algorithm + "\"\nbefore = \"" + before + "\"\nnth = " + std::to_string(nth) +
         "\nasks = \"" + asks + "\"\nprompt = \"Which?\"\nbecause = \"So.\"\n";
}

Session opened(const std::string& text) {
  Draft draft = check::checked_draft(text, "own.toml");
  REQUIRE_MESSAGE(draft.mistakes.empty(), draft.mistakes.front().message());
  auto session = Session::open(*std::move(draft.lesson));
  REQUIRE(session.has_value());
  return *std::move(session);
}

/// The session at its question.
Session at_question(const std::string& text) {
  Session session = opened(text);
  session.last();
  REQUIRE(session.conversation().asked() != nullptr);
  return session;
}

std::vector<std::string> right_choices(const Session& session) {
  const Asked& asked = *session.conversation().asked();
  std::vector<std::string> right;
  for (const int choice : asked.kind->truth(asked, session.player().run(0)).choices)
    right.push_back(asked.choices[choice]);
  return right;
}

}  // namespace

TEST_CASE("an edge: that of the hull on which the smallest rectangle lies") {
  // Each edge of this trapezium but P1 to P2 has a rectangle of area 4 on it.
  Session session =
      at_question(lesson_of("list = [[0, 0], [4, 0], [3, 1], [0, 1]]", "obb/pca_rectangle", "rectangle_found", "edge"));
  CHECK(session.conversation().asked()->choices.size() == 4);
  const auto right = right_choices(session);
  REQUIRE(right.size() == 1);
  CHECK(right.front() != "P1 to P2");
  CHECK(session.conversation()
            .asked()
            ->kind->truth(*session.conversation().asked(), session.player().run(0))
            .sentence.ends_with("with area 4.000."));
}

TEST_CASE("an edge in space: that of the projection on which the calipers found the smallest rectangle") {
  Session session = at_question(
      lesson_of("dim = 3\ngenerate = \"clusters\"\ncount = 12", "obb/pca_rectangle", "rectangle_found", "edge"));
  const Asked asked = *session.conversation().asked();
  const auto turn = calipers_turn(fit_run(session.player().run(0)).trace(), asked.fact);
  REQUIRE(turn.size() >= 3);
  CHECK(asked.choices.size() == turn.size());
  const auto least =
      std::min_element(turn.begin(), turn.end(), [](const auto* a, const auto* b) { return a->area < b->area; });
  const auto right = right_choices(session);
  CHECK(std::find(right.begin(), right.end(), asked.choices[static_cast<std::size_t>(least - turn.begin())]) !=
        right.end());
  CHECK(right.size() < turn.size());
}

TEST_CASE("smaller: whether the next edge of the calipers' turn has a smaller rectangle than all before it") {
  for (const int nth : {1, 2, 3}) {
    Session session = at_question(lesson_of("dim = 3\ngenerate = \"clusters\"\ncount = 12", "obb/pca_rectangle",
                                            "calipers_turned", "smaller", nth));
    const auto turn = calipers_turn(fit_run(session.player().run(0)).trace(), session.conversation().asked()->fact + 1);
    REQUIRE(static_cast<int>(turn.size()) == nth);
    double before = std::numeric_limits<double>::infinity();
    for (int i = 0; i + 1 < nth; ++i) before = std::min(before, turn[i]->area);
    CHECK(right_choices(session) == std::vector<std::string>{turn.back()->area < before ? "yes" : "no"});
  }
}

TEST_CASE("faces: those that the eye lies beyond, all of them and no other") {
  Session session = at_question(lesson_of(
      "dim = 3\nlist = [[0, 0, 0], [8, 0, 0], [0, 8, 0], [0, 0, 8], [5, 5, 5], [1, 1, 1], [7, 4, -1], [-1, 2, 3]]",
      "hull/quickhull", "horizon_found", "faces"));
  const Asked asked = *session.conversation().asked();
  const Index eye = fact_of<fit::HorizonFound>(asked, session.player().run(0)).eye;
  std::vector<std::string> seen;
  for (std::size_t i = 0; i < asked.choices.size(); ++i) {
    const auto& face = asked.choice_handles[i];
    REQUIRE(face.size() == 3);
    const Point3 a = session.stage().subject().at(face[0]), b = session.stage().subject().at(face[1]),
                 c = session.stage().subject().at(face[2]);
    if ((b - a).cross(c - a).dot(session.stage().subject().at(eye) - a) > 0)
      seen.push_back(asked.choices[i]);  // small integers
  }
  CHECK(!seen.empty());
  CHECK(seen.size() < asked.choices.size());
  CHECK(right_choices(session) == seen);
}

TEST_CASE("a slab: the narrowest, and each of several that are") {
  Session diagonal =
      at_question(lesson_of("list = [[0, 0], [3, 3], [0.2, 0], [3, 2.8]]", "kdop/k8", "finished", "slab"));
  CHECK(right_choices(diagonal) == std::vector{axis_name({1, -1, 0})});
  Session square = at_question(lesson_of("list = [[0, 0], [2, 0], [0, 2], [2, 2]]", "kdop/k8", "finished", "slab"));
  CHECK(right_choices(square) == std::vector{axis_name({1, 0, 0}), axis_name({0, 1, 0})});
}

TEST_CASE("they are refused of steps that have no edge or slab") {
  const auto refused = [](const std::string& text, const std::string& why) {
    const Draft draft = check::checked_draft(text, "own.toml");
    REQUIRE(draft.mistakes.size() == 1);
    CHECK_MESSAGE(draft.mistakes.front().what.find(why) != std::string::npos, draft.mistakes.front().message());
  };
  const std::string plane = "list = [[0, 0], [4, 0], [3, 1], [0, 1]]";
  refused(lesson_of(plane, "obb/pca", "finished", "slab"), "can only be asked of a k-DOP");
  refused(lesson_of("dim = 3\nlist = [[0, 0, 0], [1, 2, 3]]", "obb/pca_rectangle", "rectangle_found", "edge"),
          "calipers turned step by step");
}
