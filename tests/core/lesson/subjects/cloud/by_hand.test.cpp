// Volumes that are set by hand: they contain every point whatever the hand does, and their state is kept with the
// points.
#include "lesson/subjects/cloud/by_hand.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "core/lesson/small_lesson.hpp"
#include "geometry/random.hpp"
#include "lesson/speaking.hpp"
#include "lesson/subjects/cloud/cloud.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

std::string hand_lesson(const std::string& points, const std::string& methods) {
  return "version = 2\ntitle = \"Hand\"\nsummary = \"A box by hand.\"\nminutes = 3\nalgorithms = [" + methods +
         "]\nreference = \"hull/quickhull\"\n\n[points]\n" + points +
         "\n\n[[section]]\ntitle = \"First\"\ntext = \"Turn it.\"\n";
}
const std::string kEveryHand =
    R"("obb/by_hand", "capsule/by_hand", "lozenge/by_hand", "obb/eigen_by_hand", "obb/pca", "obb/exact")";
const std::string kDiamond = "list = [[2, 0], [0, 1], [-2, 0], [0, -1]]";

const CloudSubject& cloud_of(const Session& session) { return *as<CloudSubject>(session.stage().subject()); }

Index handle_of(const Session& session, std::string_view name) {
  return *handle_named(session.stage().subject(), name);
}

double value_of(const Session& session, std::string_view key) {
  for (const Figure& one : session.telling().figures())
    if (one.key == key) return one.value;
  FAIL("there is no such figure");
  return 0;
}

/// Moves a random handle to a random place near the points.
void move_at_random(Session& session, Random& random) {
  const Index first = count_of(session.stage().subject());
  const auto handles = static_cast<std::uint32_t>(session.stage().subject().size() - first);
  Point3 to = Point3::Zero();
  for (int axis = 0; axis < session.stage().subject().dim(); ++axis) to[axis] = random.between(-2, 2);
  REQUIRE(session.stage().move(first + static_cast<Index>(random.below(handles)), to));
}

void check_every_volume(Session& session) {
  for (const std::string& name : session.lesson().algorithms) {
    REQUIRE(session.player().choose(0, name));
    if (!session.player().method(0)->by_hand) continue;
    session.last();
    const fit::Recording& recording = *recording_of(session, 0);
    CAPTURE(name);
    CHECK(recording.certificate.contains);
    CHECK(recording.certificate.outside == 0);
    CHECK(recording.certificate.on_boundary);
    CHECK_FALSE(recording.result.support.empty());
  }
}

}  // namespace

TEST_CASE("whatever the hand does, the volume contains every point, exactly") {
  for (const std::string dim : {"2", "3"})
    for (const std::string kind : {"gaussian", "stick", "sphere", "line"})
      for (const std::uint64_t seed : {1, 2}) {
        Session session =
            test::open(hand_lesson("dim = " + dim + "\ngenerate = \"" + kind + "\"\ncount = 30", kEveryHand));
        session.stage().scatter(seed);
        Random random(seed);
        for (int moves = 0; moves < 12; ++moves) {
          move_at_random(session, random);
          check_every_volume(session);
        }
      }
}

TEST_CASE("a box by hand has its handle off the box, and is as tight as its axes allow") {
  Session session = test::open(hand_lesson(kDiamond, kEveryHand));
  session.last();
  CHECK(value_of(session, "measure") == doctest::Approx(8));
  const Index turn = handle_of(session, "Box turn");
  REQUIRE(session.stage().move(turn, {1, 0.5, 0}));  // along an edge of the diamond
  CHECK(value_of(session, "measure") == doctest::Approx(2.4 * 8 / 3).epsilon(0.2));
  const auto& box = *std::get_if<Obb<double, 3>>(&recording_of(session, 0)->result.volume);
  CHECK(std::abs(box.axes(1, 0) / box.axes(0, 0)) == doctest::Approx(0.5));
  CHECK((session.stage().subject().at(turn) - box.center).norm() > box.half_extents[0]);
}

TEST_CASE("the radius of a capsule by hand reaches to the farthest point from the segment") {
  Session session = test::open(hand_lesson(kDiamond, kEveryHand));
  REQUIRE(session.player().choose(0, "capsule/by_hand"));
  session.last();
  REQUIRE(session.stage().move(handle_of(session, "Capsule a"), {-1.5, 0, 0}));
  REQUIRE(session.stage().move(handle_of(session, "Capsule b"), {1.5, 0, 0}));
  CHECK(std::get_if<Capsule<double, 3>>(&recording_of(session, 0)->result.volume)->radius == 1);
  CHECK(session.player().support(0) == std::vector<Index>{1, 3});
}

TEST_CASE("a direction is an eigenvector where its image lies along it") {
  Session session = test::open(hand_lesson(kDiamond, kEveryHand));
  REQUIRE(session.player().choose(0, "obb/eigen_by_hand"));
  session.last();
  const Index turn = handle_of(session, "Box turn");
  for (const Point3& along : {Point3(3, 0, 0), Point3(0, 3, 0)}) {
    REQUIRE(session.stage().move(turn, along));
    CHECK(value_of(session, "image_angle") == doctest::Approx(0).epsilon(1e-9));
  }
  CHECK(value_of(session, "image_variance") == doctest::Approx(0.5));
  REQUIRE(session.stage().move(turn, {3, 3, 0}));  // the covariance is diagonal: 2 and 0.5, so the image is (2, 0.5)
  CHECK(value_of(session, "image_angle") == doctest::Approx(45 - 14.0362).epsilon(1e-4));
}

TEST_CASE("what the hand set is in the rows and in undo, and begins again with other points") {
  Session session = test::open(hand_lesson(kDiamond, kEveryHand));
  session.last();
  const Index turn = handle_of(session, "Box turn");
  const Point3 before = session.stage().subject().at(turn);
  session.stage().begin_drag();
  REQUIRE(session.stage().move(turn, {3, 1, 0}));
  REQUIRE(session.stage().move(turn, {3, 2, 0}));
  session.stage().end_drag();
  const Rows rows = session.stage().subject().rows();
  const std::uint64_t hash = session.player().trace_hash();
  CHECK(rows.size() == 4 + 3);
  session.stage().undo();
  CHECK(session.stage().subject().at(turn) == before);
  CHECK(session.player().trace_hash() != hash);
  REQUIRE(session.stage().set_rows(rows));
  CHECK(session.stage().subject().rows() == rows);
  CHECK(session.player().trace_hash() == hash);

  REQUIRE(session.stage().set_rows({{0, 0}, {1, 0}, {0, 1}}));  // an address that knows only points
  CHECK(count_of(session.stage().subject()) == 3);
  CHECK(session.stage().subject().rows()[3].size() == rows[4].size());
  CHECK_FALSE(session.stage().set_rows({{0, 0}, {1, 2, 3, 4}}));
  session.stage().scatter(session.stage().subject().origin().seed);
  CHECK(session.stage().subject().at(turn) == before);
}

TEST_CASE("a point that moves takes the volume along, and only points can be deleted or be an answer") {
  Session session = test::open(hand_lesson(kDiamond, kEveryHand));
  session.last();
  REQUIRE(session.stage().move(0, {5, 0, 0}));
  CHECK(value_of(session, "measure") == doctest::Approx(14));
  CHECK_FALSE(session.stage().remove(handle_of(session, "Box turn")));
  REQUIRE(session.stage().add({0, 3, 0}));
  CHECK(count_of(session.stage().subject()) == 5);
  CHECK(session.stage().subject().name_of(4) == "P4");
  CHECK(session.player().run(0).candidates(0).size() == 5);
  CHECK(session.stage().subject().things().front().size() == 5);
}

namespace {

const std::string kSlabsByHand = R"("kdop/by_hand", "kdop/k4", "kdop/k8", "aabb/min_max")";
const std::string kSlabsInSpace = R"("kdop/by_hand", "kdop/k14", "kdop/k26", "aabb/min_max")";

/// With a slider for the number of slabs.
std::string slabs_lesson(const std::string& points, const std::string& methods) {
  const bool space = points.starts_with("dim = 3");
  return hand_lesson(points, methods) +
         "\n[[slider]]\ntitle = \"Slabs\"\ndrives = \"axes\"\nfrom = " + (space ? "3\nto = 13\n" : "2\nto = 8\n");
}

double measure_by(Session& session, const std::string& method) {
  REQUIRE(session.player().choose(0, method));
  session.last();
  return value_of(session, "measure");
}

void check_same_as(Session& session, double axes, const std::string& method) {
  CAPTURE(method);
  REQUIRE(session.stage().slide(0, axes));
  CHECK(measure_by(session, "kdop/by_hand") == doctest::Approx(measure_by(session, method)).epsilon(1e-12));
}

}  // namespace

TEST_CASE("directions by hand begin as an AABB, and added ones make the k-DOPs of the textbooks") {
  Session plane = test::open(slabs_lesson("generate = \"gaussian\"\ncount = 30", kSlabsByHand));
  check_same_as(plane, 2, "aabb/min_max");
  check_same_as(plane, 4, "kdop/k8");
  Session space = test::open(slabs_lesson("dim = 3\ngenerate = \"gaussian\"\ncount = 30", kSlabsInSpace));
  check_same_as(space, 3, "aabb/min_max");
  check_same_as(space, 7, "kdop/k14");
  check_same_as(space, 13, "kdop/k26");
}

TEST_CASE("slabs in any directions contain every point, exactly, and are no larger than with fewer of them") {
  for (const std::string dim : {"2", "3"})
    for (const std::string kind : {"gaussian", "stick", "sphere", "line", "lattice"}) {
      CAPTURE(kind);
      Session session =
          test::open(slabs_lesson("dim = " + dim + "\ngenerate = \"" + kind + "\"\ncount = 20", R"("kdop/by_hand")"));
      REQUIRE(session.stage().slide(0, 7));
      Random random(1);
      for (int moves = 0; moves < 12; ++moves) {
        const Index first = count_of(session.stage().subject());
        Point3 to = Point3::Zero();
        for (int axis = 0; axis < session.stage().subject().dim(); ++axis) to[axis] = random.between(-9, 9);
        REQUIRE(session.stage().move(first + static_cast<Index>(random.below(7)), to));
        session.last();
        const fit::Recording& recording = *recording_of(session, 0);
        CHECK(recording.certificate.contains);
        CHECK(recording.certificate.on_boundary);
        double before = std::numeric_limits<double>::infinity();
        for (const auto& entry : recording.steps) {
          if (!entry.step.has_volume) continue;
          const double now = fit::measure_of(entry.step.volume, session.stage().subject().dim());
          CHECK(now <= before * (1 + 1e-9) + 1e-12);
          before = now;
        }
      }
    }
}

TEST_CASE("slabs are never endless, a direction can be deleted, and its row and undo bring it back") {
  Session session = test::open(slabs_lesson(kDiamond, R"("kdop/by_hand")"));
  session.last();
  CHECK(value_of(session, "measure") == doctest::Approx(8));
  CHECK_FALSE(session.stage().move(handle_of(session, "Axis 2"), {5, 0.001, 0}));
  CHECK_FALSE(session.stage().remove(handle_of(session, "Axis 2")));
  REQUIRE(session.stage().move(handle_of(session, "Axis 1"), {1, 2, 0}));  // perpendicular to an edge of the diamond
  REQUIRE(session.stage().move(handle_of(session, "Axis 2"), {1, -2, 0}));
  session.last();
  CHECK(value_of(session, "measure") == doctest::Approx(4));
  CHECK(value_of(session, "slabs") == 2);
  CHECK(value_of(session, "bytes") == 16);
  const Rows rows = session.stage().subject().rows();
  CHECK(rows.back().size() == 4);
  REQUIRE(session.stage().slide(0, 5));
  REQUIRE(session.stage().remove(handle_of(session, "Axis 1")));
  CHECK(session.stage().subject().size() == 4 + 4);
  session.stage().undo();
  CHECK(session.stage().subject().size() == 4 + 5);
  REQUIRE(session.stage().set_rows(rows));
  session.last();
  CHECK(session.stage().subject().rows() == rows);
  CHECK(value_of(session, "measure") == doctest::Approx(4));
}

TEST_CASE("a lesson without a method by hand has no more handles than points") {
  const Session session = test::open_small();
  CHECK(cloud_of(session).hand().size() == 0);
  CHECK(session.stage().subject().size() == count_of(session.stage().subject()));
}

TEST_CASE("a slider that moves only what a method by hand starts from is there beside one") {
  Session session = test::open(slabs_lesson(kDiamond, R"("kdop/k8", "kdop/by_hand")"));
  CHECK(session.stage().sliders().empty());
  REQUIRE(session.player().choose(1, "kdop/by_hand").has_value());
  CHECK(session.stage().sliders().size() == 1);
  REQUIRE(session.player().choose(1, "").has_value());
  REQUIRE(session.player().choose(0, "kdop/by_hand").has_value());
  CHECK(session.stage().sliders().size() == 1);
}
