// A field of boxes in a lesson: its steps, its figures, and the camera that flies over it.
#include "lesson/subjects/field/field.hpp"

#include <doctest/doctest.h>

#include "lesson/session.hpp"
#include "lesson/subjects.hpp"
#include "query/cull/classify.hpp"

using namespace snug;
using namespace snug::lesson;
using hierarchy::FieldWay;
using query::Culling;

namespace {

Session field_session(int objects, std::uint64_t seed = 1) {
  Lesson lesson;
  lesson.id = "test";
  lesson.volume = kFrustumField;
  lesson.seed = seed;
  auto tables = std::make_shared<FieldTables>();
  tables->stage.recipe.objects = objects;
  tables->stage.now = tables->stage.before = {{-30, 8, 10}, {0, 6, 0}};
  lesson.tables = std::move(tables);
  for (const Method& method : field_methods()) lesson.algorithms.emplace_back(method.name);
  auto session = Session::open(std::move(lesson));
  REQUIRE_MESSAGE(session.has_value(), (session ? "" : session.error().message()));
  return *std::move(session);
}

double figure(const Session& session, std::string_view key) {
  for (const Figure& figure : session.telling().figures())
    if (figure.key == key && figure.known) return figure.value;
  return -1;
}

const FieldSubject& field_of(const Session& session) { return *as<FieldSubject>(session.stage().subject()); }

}  // namespace

TEST_CASE("step by step, each way to cull a field comes to the answer of each box, and to its cost") {
  for (const std::uint64_t seed : {1, 2, 3}) {
    Session session = field_session(700, seed);
    REQUIRE(session.stage().move(0, Point3(10, 5, -20 + 9.0 * static_cast<double>(seed))).has_value());
    const FieldStage& stage = field_of(session).stage();
    const auto frustum = *frustum_of(stage.recipe, stage.now);
    for (const Method& method : field_methods()) {
      CAPTURE(method.name);
      REQUIRE(session.player().choose(0, method.name).has_value());
      const FieldRun& run = field_run(session.player().run(0));
      for (std::size_t i = 0; i < 700; ++i) {
        CHECK(run.verdicts()[i] == query::classify(frustum, field_of(session).field().boxes[i]).verdict);
        CHECK(run.knows(i, run.steps()));
        CHECK_FALSE(run.knows(i, 0));
      }
      std::int64_t left = 700;
      for (int step = 1; step <= run.steps(); ++step) {
        const FieldTally &now = run.tally(step), &before = run.tally(step - 1);
        CHECK(now.planes >= before.planes);
        CHECK(now.products >= before.products);
        std::int64_t known = 0;
        for (const std::size_t verdict : {0, 1, 2}) {
          CHECK(now.known[verdict] >= before.known[verdict]);
          known += now.known[verdict];
        }
        CHECK(known >= 700 - left);
        left = 700 - known;
        CHECK(run.line(step - 1) < static_cast<int>(method.pseudocode.size()));
      }
      CHECK(left == 0);
      std::vector<Culling> verdicts(700);
      std::vector<std::int8_t> last(700, -1);
      if (run.way() == FieldWay::kLastPlane)
        hierarchy::cull_field(field_of(session).field(), *frustum_of(stage.recipe, stage.before), run.way(), last,
                              verdicts);
      const auto cost = hierarchy::cull_field(field_of(session).field(), frustum, run.way(), last, verdicts);
      CHECK(run.tally(run.steps()).planes == cost.planes);
      CHECK(run.tally(run.steps()).products == cost.products);
      CHECK(field_of(session).measured(method).cost.planes == cost.planes);
      session.last();
      CHECK(figure(session, "planes") == static_cast<double>(cost.planes));
      CHECK(figure(session, "saved") == doctest::Approx(100 - static_cast<double>(cost.planes) / 42));
      REQUIRE(session.player().proofs().size() == 2);
      CHECK(session.player().proofs().front().holds);
    }
  }
}

TEST_CASE("the careful ways save tests, and all vertices and eight at once save none") {
  Session session = field_session(5000);
  const auto saved = [&](std::string_view method) {
    REQUIRE(session.player().choose(0, method).has_value());
    session.last();
    return figure(session, "saved");
  };
  CHECK(saved("all_vertices") == 0);
  CHECK(saved("at_once") == 0);
  const double one_by_one = saved("p_n_vertex"), tree = saved("tree_masking");
  CHECK(one_by_one > 20);
  CHECK(tree > one_by_one);
  CHECK(tree > 90);
  CHECK(figure(session, "skipped") > 0);
  CHECK(saved("last_plane") > one_by_one);
}

TEST_CASE("a drag is a frame, and the frame before is the camera as it was") {
  Session session = field_session(200);
  const CameraPose first = field_of(session).stage().now;
  REQUIRE(session.stage().move(1, Point3(0, 6, 1)).has_value());
  CHECK(field_of(session).stage().before.aim == first.aim);
  CHECK(field_of(session).stage().now.aim == Point3(0, 6, 1));
  REQUIRE(session.stage().move(0, Point3(-29, 8, 10)).has_value());
  CHECK(field_of(session).stage().before.aim == Point3(0, 6, 1));
  CHECK(field_of(session).stage().before.position == first.position);
  const Rows rows = session.stage().subject().rows();
  Session other = field_session(200);
  REQUIRE(other.stage().set_rows(rows).has_value());
  CHECK(other.stage().subject().rows() == rows);
  CHECK(other.player().trace_hash() == session.player().trace_hash());
  session.stage().undo();
  session.stage().undo();
  CHECK(field_of(session).stage().now.aim == first.aim);
}

TEST_CASE("more objects can be asked for, and another seed scatters them anew") {
  Session session = field_session(200);
  REQUIRE(session.stage().set_numbers(2, 0, std::array{350.0}).has_value());
  CHECK(field_run(session.player().run(0)).objects() == 350);
  CHECK_FALSE(session.stage().set_numbers(2, 0, std::array{200'000.0}).has_value());
  CHECK_FALSE(session.stage().set_numbers(2, 0, std::array{1.0}).has_value());
  session.stage().undo();
  CHECK(field_run(session.player().run(0)).objects() == 200);
  const auto box = field_of(session).field().boxes[0];
  session.stage().scatter(9);
  CHECK(field_of(session).field().boxes[0].min != box.min);
  session.stage().scatter(1);
  CHECK(field_of(session).field().boxes[0].min == box.min);
}

TEST_CASE("a camera that aims at itself, straight down, or from far away is refused") {
  Session session = field_session(50);
  const Rows before = session.stage().subject().rows();
  for (const Point3& place : {Point3(0, 6, 0), Point3(0, 60, 0), Point3(0, -60, 0), Point3(1e5, 0, 0)})
    CHECK_FALSE(session.stage().move(0, place).has_value());
  CHECK(session.stage().subject().rows() == before);
  for (const Rows& rows :
       {Rows{}, Rows{{1, 2, 3}}, Rows{before[0], before[1], {50.5}}, Rows{before[0], before[1], {2}}})
    CHECK_FALSE(session.stage().set_rows(rows).has_value());
}

TEST_CASE(
    "while the camera is dragged, its answers are not compared with those of another way; once it rests they are") {
  Session session = field_session(200);
  session.last();
  session.stage().begin_drag();
  REQUIRE(session.stage().move(1, Point3(0, 6, 2)).has_value());
  REQUIRE(session.player().proofs().size() == 2);
  CHECK_FALSE(session.player().proofs().front().holds);
  CHECK_FALSE(session.player().proofs().front().claimed);
  session.stage().end_drag();
  REQUIRE(session.player().proofs().size() == 2);
  CHECK(session.player().proofs().front().holds);
}

TEST_CASE("a way that takes boxes one by one is measured in parts, and costs what it costs in one") {
  const Session session = field_session(9000);
  for (const Method& method : field_methods()) {
    CAPTURE(method.name);
    FieldMeasuring measuring = field_of(session).measuring(method);
    int parts = 0;
    while (!measuring.done()) measuring.work(0), ++parts;
    const bool alone = hierarchy::one_by_one(way_of(method));
    CHECK(parts == (way_of(method) == FieldWay::kLastPlane ? 6 : alone ? 3 : 1));
    CHECK(measuring.result().cost.planes == field_of(session).measured(method).cost.planes);
    const auto run = field_of(session).run(method, nullptr);
    CHECK(measuring.result().cost.planes == field_run(*run).tally(run->steps()).planes);
    CHECK(measuring.result().cost.products == field_run(*run).tally(run->steps()).products);
  }
}

TEST_CASE("the time of a way is measured by the clock that was passed in") {
  static double now = 0;
  Lesson lesson;
  lesson.id = "test";
  lesson.volume = kFrustumField;
  auto tables = std::make_shared<FieldTables>();
  tables->stage.recipe.objects = 20;
  tables->stage.now = tables->stage.before = {{-30, 8, 10}, {0, 6, 0}};
  lesson.tables = std::move(tables);
  lesson.algorithms = {"p_n_vertex"};
  const auto session = Session::open(
      std::move(lesson), {}, +[] { return now += 500; });
  REQUIRE(session.has_value());
  CHECK(field_of(*session).measured(field_methods()[1]).ns == 500);
  CHECK_FALSE(field_of(field_session(20)).measured(field_methods()[1]).ns.has_value());
}
