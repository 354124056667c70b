#include "lesson/stand.hpp"

#include "core/lesson/small_lesson.hpp"
#include "lesson/subjects.hpp"

using namespace snug;
using namespace snug::lesson;
using snug::test::open_small;

namespace {

std::string refusal(const Standpoint& at) {
  Session session = open_small();
  const auto stands = stand_at(session, at);
  return stands ? "" : stands.error().what;
}

}  // namespace

TEST_CASE("a step is one of the algorithm that is named") {
  Session session = open_small();
  REQUIRE(stand_at(session, {.algorithm = "welzl", .step = 3}));
  CHECK(session.step() == 3);
  CHECK(name_in(session.lesson(), *session.method(0)) == "welzl");
  REQUIRE(stand_at(session, {.step = Standpoint::kLastStep}));
  CHECK(session.step() == session.steps());
  CHECK(refusal({.algorithm = "wezl"}) ==
        "the lesson's algorithm is none of ritter, welzl or brute_force: wezl; did you mean welzl?");
  CHECK(refusal({.step = 12}) == "there is no step 12: ritter has 11");
}

TEST_CASE("a question stands open where it is asked, or with the outcome of its model answer") {
  for (const char* const id : {"pair", "growth", "again", "number"}) {
    CAPTURE(id);
    Session session = open_small();
    REQUIRE(stand_at(session, {.question = id}));
    REQUIRE(session.asked() != nullptr);
    CHECK(session.asked()->question->id == id);
    REQUIRE(stand_at(session, {.question = id, .answered = true}));
    REQUIRE(session.outcome() != nullptr);
    CHECK(session.outcome()->question == id);
    CHECK(session.outcome()->right);
  }
}

TEST_CASE("a question that cannot stand is refused with the reason") {
  CHECK(refusal({.question = "gowth"}) ==
        "the question is none of pair, growth, again or number: gowth; did you mean growth?");
  CHECK(refusal({.algorithm = "welzl", .question = "growth"}) ==
        "the question growth is about ritter, not about welzl");
  Session scattered = open_small();
  scattered.scatter(6);
  const auto stands = stand_at(scattered, {.question = "number"});  // asked on the lesson's own points alone
  REQUIRE_FALSE(stands);
  CHECK(stands.error().what == "the question number does not come on what is on the stage");
}
