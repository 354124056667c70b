// Three invitations, one at a time, each gone once it was followed.
#include "lesson/invitations.hpp"

#include "core/lesson/small_lesson.hpp"

using namespace snug::lesson;
using snug::test::open_small;

TEST_CASE("a newcomer drags, steps and plays, and is asked no more") {
  Session session = open_small();
  Invitations invitations(0);
  REQUIRE(invitations.due(session, false) == Invited::kDrag);
  CHECK(invitations.due(session, false) == Invited::kDrag);
  CHECK(invitations.followed() == 0);
  REQUIRE(session.stage().move(5, {0.4, 0.1, 0}));
  REQUIRE(invitations.due(session, false) == Invited::kStep);
  CHECK(invitations.followed() == 1);
  session.forward();
  // A question stands there, and what is said of it: nothing invites beside them.
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK_FALSE(invitations.due(session, false));
  CHECK(invitations.followed() == 2);
  REQUIRE(session.conversation().give({}, false));
  REQUIRE(session.conversation().outcome() != nullptr);
  CHECK_FALSE(invitations.due(session, false));
  REQUIRE(session.conversation().acknowledge());
  REQUIRE(session.conversation().asked() != nullptr);
  REQUIRE(session.conversation().give({}, false));
  REQUIRE(session.conversation().acknowledge());
  REQUIRE(session.conversation().asked() == nullptr);
  CHECK(invitations.due(session, false) == Invited::kPlay);
  CHECK_FALSE(invitations.due(session, true));
  CHECK(invitations.followed() == Invitations::kAll);
  session.go(0);
  CHECK_FALSE(invitations.due(session, false));
}

TEST_CASE("what was done before an invitation was shown follows none") {
  Session session = open_small();
  REQUIRE(session.stage().move(5, {0.4, 0.1, 0}));
  session.forward();
  Invitations invitations(0);
  CHECK_FALSE(invitations.due(session, false));  // to drag is the first thing, before the first step
  CHECK(invitations.followed() == 0);
}

TEST_CASE("none invites to step where no step is left") {
  Session session = open_small();
  Invitations invitations(0);
  REQUIRE(invitations.due(session, false) == Invited::kDrag);
  session.jump(session.player().steps());
  REQUIRE(session.stage().move(5, {0.4, 0.1, 0}));
  REQUIRE(session.player().step() == session.player().steps());
  if (session.conversation().at_summary()) session.conversation().close_summary();
  CHECK_FALSE(invitations.due(session, false));
  CHECK(invitations.followed() == 1);
  session.go(0);
  CHECK(invitations.due(session, false) == Invited::kStep);
}

TEST_CASE("those that were followed before are not shown again") {
  Session session = open_small();
  Invitations second(1);
  CHECK(second.due(session, false) == Invited::kStep);
  Invitations none(Invitations::kAll);
  CHECK_FALSE(none.due(session, false));
}

TEST_CASE("an invitation names what it points at") {
  CHECK(invitation_text(Invited::kDrag, "P12", "Step") == "Drag P12");
  CHECK(invitation_text(Invited::kStep, "P12", "Next") == "Now press Next");
}
