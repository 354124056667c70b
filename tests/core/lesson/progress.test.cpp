// When a lesson is done: once everything that it asks, in all of its runs, was answered.
#include "lesson/progress.hpp"

#include <doctest/doctest.h>

#include <string>

#include "core/lesson/small_lesson.hpp"
#include "lesson/kept_answers.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

/// The small lesson, whose last question is asked in another run.
std::string two_runs() {
  return test::small_lesson_with("id = \"number\"\nalgorithm = \"ritter\"", "id = \"number\"\nalgorithm = \"welzl\"");
}

/// Answers what is asked next, and goes on.
void answer_one(Session& session) {
  for (int turns = 0; session.conversation().asked() == nullptr; ++turns) {
    REQUIRE(turns < 1000);
    session.forward();
  }
  REQUIRE(session.conversation().give(model_answer(*session.conversation().asked(), session.player().run(0))));
}

}  // namespace

TEST_CASE("as many answers as another run asks do not make a lesson done") {
  Session session = test::open(two_runs());
  CHECK_FALSE(progress_of(session).begun);
  answer_one(session);
  REQUIRE(session.player().choose(0, "welzl"));  // whose run asks one question
  CHECK(progress_of(session).begun);
  CHECK(progress_of(session).answered == 1);
  CHECK(progress_of(session).asked == 4);
  CHECK_FALSE(progress_of(session).done);

  test::play_to_end(session);
  CHECK(progress_of(session).answered == 2);
  CHECK_FALSE(progress_of(session).done);
  REQUIRE(session.player().choose(0, "ritter"));
  session.go(0);
  test::play_to_end(session);
  CHECK(progress_of(session).answered == 4);
  CHECK(progress_of(session).done);
  REQUIRE(session.player().choose(0, "brute_force"));  // which asks nothing
  CHECK(progress_of(session).done);
}

TEST_CASE("skipped questions are not done, and are taken over as skipped") {
  Session session = test::open_small();
  answer_one(session);
  for (int turns = 0; session.player().step() < session.player().steps() || session.conversation().asked() != nullptr;
       ++turns) {
    REQUIRE(turns < 1000);
    if (session.conversation().asked() != nullptr) REQUIRE(session.conversation().give({}, false));
    session.forward();
  }
  CHECK(progress_of(session).answered == 1);
  CHECK_FALSE(progress_of(session).done);
  Session later = test::open_small();
  take_up(later, kept_answers_of(kept_text(answers_of(session))));
  CHECK(progress_of(later).answered == 1);
  CHECK_FALSE(progress_of(later).done);
}

TEST_CASE("a lesson that is about a slider is done once it was moved, and its summary says so before") {
  const std::string text = test::small_lesson_with(
      "[[section]]",
      "[[slider]]\ntitle = \"Offset\"\ndrives = \"offset\"\nfrom = 0\nto = 10\nmust_move = true\n\n[[section]]");
  Session session = test::open(text);
  test::play_to_end(session);
  CHECK(progress_of(session).answered == 4);
  CHECK_FALSE(progress_of(session).done);
  CHECK(session.conversation().score().find("Still to do: move the slider “Offset”.") != std::string::npos);
  REQUIRE(session.stage().slide(0, 4));
  CHECK(progress_of(session).done);
  Session later = test::open(text);
  take_up(later, kept_answers_of(kept_text(answers_of(session))));
  CHECK(progress_of(later).done);
  CHECK(later.log().to_move().empty());
}
