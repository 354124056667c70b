#include "core/lesson/lesson_files.hpp"
#include "core/lesson/small_lesson.hpp"
#include "lesson/subjects/cloud/cloud.hpp"

using namespace snug;
using namespace snug::lesson;
using test::open_small;

namespace {

using V = Vector<double, 3>;

std::vector<V> all_points(const Session& session) {
  std::vector<V> all;
  for (Index i = 0; i < session.stage().subject().size(); ++i) all.push_back(session.stage().subject().at(i));
  return all;
}

io::PointFile tetrahedron() {
  return {3, {V(0, 0, 0), V(1, 0, 0), V(0, 1, 0), V(0, 0, 1)}, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
}

double radius(const Session& session) { return ball_of(recording_of(session, 0)->result).radius; }

double smallest(const Session& session) {
  return as<CloudSubject>(session.stage().subject())->reference(session.player().view()).size.value();
}

}  // namespace

TEST_CASE("moving a point runs everything anew and can be undone") {
  Session session = open_small();
  CHECK(radius(session) == 2.25);
  CHECK_FALSE(session.stage().edited());
  const auto revision = session.revision();
  REQUIRE(session.stage().move(4, V(0, 1.5, 0)).has_value());
  CHECK(session.revision() != revision);
  CHECK(session.stage().edited());
  CHECK(radius(session) == 2);
  CHECK(smallest(session) == doctest::Approx(2));
  session.stage().undo();
  CHECK(radius(session) == 2.25);
  CHECK_FALSE(session.stage().edited());
  CHECK_FALSE(session.stage().can_undo());
  session.stage().redo();
  CHECK(session.stage().subject().at(4) == V(0, 1.5, 0));
  CHECK_FALSE(session.stage().can_redo());
}

TEST_CASE("bad moves, points and indices are refused and change nothing") {
  Session session = open_small();
  const auto before = all_points(session);
  CHECK_FALSE(session.stage().move(6, V(0, 0, 0)).has_value());
  CHECK_FALSE(session.stage().move(-1, V(0, 0, 0)).has_value());
  CHECK_FALSE(session.stage().move(0, V(std::nan(""), 0, 0)).has_value());
  CHECK_FALSE(session.stage().add(V(0, HUGE_VAL, 0)).has_value());
  CHECK_FALSE(session.stage().remove(17).has_value());
  CHECK_FALSE(session.stage().set_generator("blob", 10, 2, 1).has_value());
  CHECK_FALSE(session.stage().set_generator("cube", 0, 2, 1).has_value());
  CHECK_FALSE(session.stage().set_generator("cube", 10, 4, 1).has_value());
  CHECK_FALSE(session.player().choose(0, "fastest").has_value());
  CHECK_FALSE(session.player().choose(0, "").has_value());
  CHECK(all_points(session) == before);
  CHECK_FALSE(session.stage().can_undo());
}

TEST_CASE("a drag is one entry of undo, whatever its length; one that moves nothing is none") {
  Session session = open_small();
  session.stage().begin_drag();
  session.stage().end_drag();
  CHECK_FALSE(session.stage().can_undo());
  session.stage().begin_drag();
  for (int i = 0; i < 20; ++i) REQUIRE(session.stage().move(5, V(0.1 * i, 0, 0)).has_value());
  CHECK(session.stage().can_undo());
  session.stage().end_drag();
  CHECK(session.stage().subject().at(5) == V(0.1 * 19, 0, 0));
  session.stage().undo();
  CHECK(session.stage().subject().at(5) == V(0.5, 0.2, 0));
  CHECK_FALSE(session.stage().can_undo());
  session.stage().redo();
  CHECK(session.stage().subject().at(5) == V(0.1 * 19, 0, 0));
}

TEST_CASE("undo in the middle of a drag ends it and takes it back") {
  Session session = open_small();
  session.stage().begin_drag();
  REQUIRE(session.stage().move(5, V(1, 1, 0)).has_value());
  session.stage().undo();
  CHECK(session.stage().subject().at(5) == V(0.5, 0.2, 0));
  REQUIRE(session.stage().move(5, V(1, 0, 0)).has_value());
  session.stage().undo();
  CHECK(session.stage().subject().at(5) == V(0.5, 0.2, 0));
}

TEST_CASE("each kind of edit is one entry of undo and comes back bit for bit") {
  Session session = open_small();
  std::vector<std::vector<V>> states{all_points(session)};
  const auto edit = [&](auto&& change) {
    change();
    states.push_back(all_points(session));
    REQUIRE(states.back() != states[states.size() - 2]);
  };
  edit([&] { REQUIRE(session.stage().add(V(3, 3, 0)).has_value()); });
  edit([&] { REQUIRE(session.stage().remove(0).has_value()); });
  edit([&] { session.stage().scatter(77); });
  edit([&] { REQUIRE(session.stage().load(tetrahedron(), "file.obj").has_value()); });
  edit([&] { REQUIRE(session.stage().set_generator("lattice", 9, 2, 4).has_value()); });
  edit([&] { session.stage().reset(); });
  for (std::size_t i = states.size() - 1; i-- > 0;) {
    session.stage().undo();
    CHECK(all_points(session) == states[i]);
  }
  CHECK_FALSE(session.stage().can_undo());
  for (std::size_t i = 1; i < states.size(); ++i) {
    session.stage().redo();
    CHECK(all_points(session) == states[i]);
  }
  CHECK_FALSE(session.stage().can_redo());
}

TEST_CASE("an edit after undo forgets what could be redone") {
  Session session = open_small();
  REQUIRE(session.stage().add(V(3, 3, 0)).has_value());
  session.stage().undo();
  REQUIRE(session.stage().can_redo());
  REQUIRE(session.stage().add(V(4, 4, 0)).has_value());
  CHECK_FALSE(session.stage().can_redo());
}

TEST_CASE("a seed says the points of a lesson, and its own seed brings its own points") {
  Session session = open_small();
  const auto own = all_points(session);
  session.stage().scatter(9);
  const auto scattered = all_points(session);
  CHECK(scattered.size() == own.size());
  CHECK(scattered != own);
  CHECK(session.stage().subject().origin().seed == 9);
  CHECK(session.stage().subject().origin().source == "cube");
  CHECK_FALSE(session.stage().edited());
  session.stage().scatter(5);
  CHECK(all_points(session) == own);
  CHECK_FALSE(session.stage().edited());
  session.stage().scatter(9);
  CHECK(all_points(session) == scattered);
}

TEST_CASE("scattering keeps the kind that the student chose, and says that an address cannot restore it") {
  Session session = open_small();
  REQUIRE(session.stage().set_generator("lattice", 27, 3, 1).has_value());
  CHECK(session.stage().subject().dim() == 3);
  CHECK(session.stage().edited());
  session.stage().scatter(2);
  CHECK(session.stage().subject().size() == 27);
  CHECK(session.stage().subject().origin().source == "lattice");
  CHECK(session.stage().edited());
  session.stage().reset();
  CHECK(session.stage().subject().dim() == 2);
  CHECK_FALSE(session.stage().edited());
}

TEST_CASE("triangles stay while vertices move, go with a point, and come back with undo") {
  Session session = open_small();
  REQUIRE(session.stage().load(tetrahedron(), "tetrahedron.obj").has_value());
  CHECK(session.stage().subject().dim() == 3);
  CHECK(session.stage().subject().origin().source == "tetrahedron.obj");
  CHECK(session.stage().subject().with_points()->triangles().size() == 4);
  REQUIRE(session.stage().move(0, V(0, 0, -1)).has_value());
  CHECK(session.stage().subject().with_points()->triangles().size() == 4);
  REQUIRE(session.stage().remove(0).has_value());
  CHECK(session.stage().subject().with_points()->triangles().empty());
  session.stage().undo();
  CHECK(session.stage().subject().with_points()->triangles().size() == 4);
}

TEST_CASE("the last point cannot be deleted") {
  Session session = open_small();
  while (session.stage().subject().size() > 1) REQUIRE(session.stage().remove(0).has_value());
  const auto refused = session.stage().remove(0);
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().what == "the last point cannot be deleted");
  CHECK(radius(session) == 0);
  CHECK(smallest(session) == 0);
  CHECK(session.player().rivals().front().excess == 0);
}

TEST_CASE("brute force says how many points it takes") {
  Session session = open_small();
  REQUIRE(session.stage().set_generator("cube", 40, 2, 1).has_value());
  REQUIRE(session.player().choose(0, "brute_force").has_value());
  const auto refused = session.stage().add(V(0, 0, 0));
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().what == "Brute force takes at most 40 points");

  REQUIRE(session.player().choose(1, "brute_force").has_value());
  REQUIRE(session.stage().set_generator("cube", 41, 2, 1).has_value());  // both give way
  CHECK(session.player().method(0)->name == "ritter");
  CHECK(session.player().method(1) == nullptr);
  const auto too_many = session.player().choose(0, "brute_force");
  REQUIRE_FALSE(too_many.has_value());
  CHECK(too_many.error().what == "Brute force takes at most 40 points");
  for (const auto& rival : session.player().rivals()) CHECK(rival.method->name != "brute_force");
}

TEST_CASE("rivals and the optimum follow the points") {
  Session session = open_small();
  const auto optimum = [&] { return as<CloudSubject>(session.stage().subject())->optimum(session.player().view()); };
  REQUIRE(session.player().rivals().size() == 3);
  CHECK(session.player().rivals()[0].excess == doctest::Approx(2.25 / 2.05 - 1));
  CHECK(std::abs(*session.player().rivals()[1].excess) < 1e-12);
  CHECK(ball_of(optimum()->result).radius == doctest::Approx(2.05));
  REQUIRE(session.stage().move(4, V(0, 0, 0)).has_value());
  CHECK(std::abs(*session.player().rivals()[0].excess) < 1e-12);
  CHECK(ball_of(optimum()->result).radius == doctest::Approx(2));
  REQUIRE(session.player().choose(0, "pivot").has_value());
  CHECK(optimum() == recording_of(session, 0));
}

TEST_CASE("a lesson that takes no points says just that, whatever stands on its stage") {
  for (const char* id : {"obb-axes", "sphere-overlap", "frustum-2d", "bvh-build"}) {
    CAPTURE(id);
    Session session = test::session_of(id);
    const auto loaded = session.stage().load(tetrahedron(), "mine.ply");
    REQUIRE_FALSE(loaded.has_value());
    CHECK(loaded.error().what == "this lesson takes no point file, and scatters no points");
    CHECK_FALSE(session.stage().set_generator("cube", 9, 3, 1).has_value());
    CHECK(session.stage().is_own());
  }
}
