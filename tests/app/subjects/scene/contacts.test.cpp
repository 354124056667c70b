// Where bodies touch, and that what is drawn of it does not cover a pile.
#include "app/subjects/scene/contacts.hpp"

#include <set>
#include <string>

#include "../../bench.hpp"
#include "../../viewed_lessons.hpp"
#include "app/look.hpp"
#include "lesson/subjects/scene/scene.hpp"
#include "scene/shape.hpp"

namespace snug::app {
namespace {

using Placed = lesson::SceneFrame::Placed;
using V3 = Vector<double, 3>;

scene::Shape box(const V3& half) { return scene::centered(scene::Volume3(Aabb<double, 3>{-half, half})).shape; }

}  // namespace

TEST_CASE("a body touches a floor where it lies, not at the floor's middle") {
  const scene::Shape floor = box({4, 0.2, 4}), small = box({0.25, 0.15, 0.2});
  const Placed ground{{0, -0.2, 0}, {}}, lying{{2.5, 0.15, -1.5}, {}};
  const V3 at = contact_between({small, lying}, {floor, ground});
  CHECK((at - V3(2.5, 0, -1.5)).norm() < 0.01);
  const auto ends = ends_between({small, lying}, {floor, ground});
  CHECK(ends[0] == lying.position);
  CHECK((ends[1] - V3(2.5, 0, -1.5)).norm() < 1e-9);
  const auto other = ends_between({floor, ground}, {small, lying});  // whichever comes first
  CHECK(other[0] == ends[1]);
  const auto alike = ends_between({small, lying}, {small, ground});  // neither is a floor to the other
  CHECK(alike[1] == ground.position);
}

TEST_CASE("so do a sphere, and a capsule, which has no manifold") {
  const scene::Shape floor = box({4, 0.2, 4});
  const Placed ground{{0, -0.2, 0}, {}};
  const scene::Shape ball = scene::centered(scene::Volume3(Sphere<double, 3>{V3::Zero(), 0.3})).shape;
  CHECK((contact_between({floor, ground}, {ball, {{-2, 0.29, 3}, {}}}) - V3(-2, 0, 3)).norm() < 0.02);
  const scene::Shape capsule =
      scene::centered(scene::Volume3(Capsule<double, 3>{{0, -0.5, 0}, {0, 0.5, 0}, 0.25})).shape;
  const Placed standing{{1, 0.74, 2}, {}};  // on its end, a hundredth deep
  const V3 at = contact_between({capsule, standing}, {floor, ground});
  CHECK(std::abs(at[1]) < 0.02);
  CHECK((V3(at[0], 0, at[2]) - V3(1, 0, 2)).norm() < 0.3);
}

TEST_CASE("names stand beside a pile of bodies, not on it") {
  Bench bench(test::falling("zoom = 2.5\nlook_at = \"P0\""));
  bench.session().jump(120);
  bench.frames(3);
  std::vector<DrawnWords> drawn;
  bench.app.note_words(&drawn);
  bench.frames(1);
  const lesson::SceneFrame& frame = *lesson::frame_of(bench.session());
  REQUIRE(frame.touching.size() > 10);
  std::set<std::string> names;  // each is drawn more than once: on its halo
  for (const DrawnWords& one : drawn) {
    if (one.words.size() > 3 || one.words[0] != 'P') continue;
    names.insert(one.words);
    for (const Handle& body : bench.app.handles()) {  // no body's middle is under it
      const bool under = body.x > one.low.x && body.x < one.high.x && body.y > one.low.y && body.y < one.high.y;
      CHECK_MESSAGE(!under, one.words, " on ", body.id);
    }
  }
  CHECK(names.size() > 3);
  CHECK(names.size() < 12);
}

}  // namespace snug::app
