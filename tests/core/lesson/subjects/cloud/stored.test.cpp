// How the volume around a cloud is stored: its numbers fill in as the run finds them.
#include "lesson/stored.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/lesson/lesson_files.hpp"
#include "lesson/session.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

/// How many of its numbers are not known yet.
std::ptrdiff_t dashes(const StoredForm& form) {
  return std::count_if(form.members.begin(), form.members.end(), [](const auto& one) { return one.text == "—"; });
}

}  // namespace

TEST_CASE("the bounds of a k-DOP are stored slab by slab, and then follow the hand") {
  Session session = test::session_of("kdop-slabs");
  int slabs = 0;
  for (int step = 0; step <= session.player().steps(); ++step) {
    session.jump(step);
    if (step > 0 && session.player().run(0).fact(step - 1) == "slab_found") ++slabs;
    const auto volumes = stored_of(session);
    REQUIRE(volumes.size() == 1);
    CHECK(volumes[0].title == "8-DOP");
    const StoredForm& form = volumes[0].forms.front();
    REQUIRE(form.members.size() == 8);
    CHECK(form.bytes() == "32 bytes in float, 64 in double");
    if (slabs != 1) CHECK(dashes(form) == 8 - 2 * slabs);  // one slab alone bounds no area
    for (const StoredMember& member : form.members) CHECK((member.text == "—") == member.lines.empty());
  }
  CHECK(slabs == 4);
  const auto before = stored_of(session)[0].forms[0].members;
  Index rightmost = 0;
  for (Index i = 1; i < session.stage().subject().size(); ++i)
    if (session.stage().subject().name_of(i).front() == 'P' &&
        session.stage().subject().at(i)[0] > session.stage().subject().at(rightmost)[0])
      rightmost = i;
  REQUIRE(session.stage().move(rightmost, session.stage().subject().at(rightmost) + Point3(1, 0, 0)).has_value());
  const auto after = stored_of(session)[0].forms[0].members;
  CHECK(after[0].text == before[0].text);        // min along x
  CHECK_FALSE(after[4].text == before[4].text);  // max along x
}

TEST_CASE("other volumes of that lesson are stored as well; a lesson that does not ask for it stores none") {
  Session session = test::session_of("kdop-slabs");
  REQUIRE(session.player().choose(0, "aabb/min_max").has_value());
  session.jump(session.player().steps());
  const auto volumes = stored_of(session);
  REQUIRE(volumes.size() == 1);
  CHECK(volumes[0].title == "AABB");
  CHECK(volumes[0].forms.size() == 3);
  CHECK(dashes(volumes[0].forms[0]) == 0);
  CHECK(stored_of(test::session_of("kdop-space")).empty());
}
