// Intervals along the axes that a test of two AABBs has not reached: shown, unless a question could be read from them.
#include "../every_step.hpp"
#include "app/subjects/pair/draw.hpp"
#include "lesson/subjects/pair/pair.hpp"

namespace snug::app {
namespace {

std::vector<int> untested_now(const lesson::Session& session) {
  return untested_axes(session, lesson::pair_run(session.player().run(0)).trace().first(session.player().step()));
}

}  // namespace

TEST_CASE("before the test every axis of two AABBs has its intervals, and the test takes its own from them") {
  lesson::Session session = lesson_session("aabb-space", false);
  CHECK(untested_now(session) == std::vector<int>{0, 1, 2});
  for (int step = 1; step <= session.player().steps(); ++step) {
    session.jump(step);
    const std::string fact(session.player().run(0).fact(step - 1));
    if (fact == "slab_tested") CHECK(untested_now(session).size() == static_cast<std::size_t>(3 - step));
  }
  CHECK(untested_now(lesson_session("sphere-overlap", false)).empty());
  CHECK(untested_now(lesson_session("kdop-overlap", false)).empty());
}

TEST_CASE("while a question is open whose answer two intervals show, none is drawn before its step") {
  lesson::Session session = lesson_session("aabb-space", true);
  CHECK(untested_now(session).empty());
  while (session.conversation().asked() != nullptr || session.player().step() < session.player().steps()) {
    if (session.conversation().asked() == nullptr) {
      session.forward();
      continue;
    }
    const std::string asks = session.conversation().asked()->question->asks;
    if (asks == "separates" || asks == "first_axis") CHECK(untested_now(session).empty());
    REQUIRE(
        session.conversation().give(lesson::model_answer(*session.conversation().asked(), session.player().run(0))));
    session.conversation().acknowledge();
  }
  session.jump(0);
  CHECK(untested_now(session) == std::vector<int>{0, 1, 2});
}

}  // namespace snug::app
