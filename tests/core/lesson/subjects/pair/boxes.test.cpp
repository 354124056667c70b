#include "lesson/boxes.hpp"

#include <doctest/doctest.h>

#include <Eigen/LU>

#include <numbers>

#include "check/play.hpp"
#include "core/lesson/lesson_files.hpp"
#include "geometry/convert.hpp"
#include "lesson/kept_answers.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects/pair/box_figures.hpp"

using namespace snug;
using namespace snug::lesson;
using snug::test::session_of;
using V3 = Vector<double, 3>;
using Kind = BoxHandle::Kind;

namespace {

const Obb<double, 3>& box(const Session& session, int i) { return boxes_of(session.stage().subject()).boxes[i]; }

std::string text_of(const std::vector<Figure>& figures, std::string_view key) {
  for (const Figure& figure : figures)
    if (figure.key == key) return figure.text;
  return "no such figure";
}

bool reaches(std::string_view goal, const BoxPair& pair) { return PairSubject(pair, 1).reaches(goal); }

/// The boxes of a task's model.
BoxPair model(const Session& session, std::size_t task) {
  const auto subject = session.stage().subject().clone();
  REQUIRE(subject->set_rows(session.lesson().tasks[task].model).has_value());
  return boxes_of(*subject);
}

/// How far its axes are from unit and perpendicular.
double skew(const Obb<double, 3>& box) {
  return (box.axes.transpose() * box.axes - Matrix<double, 3>::Identity()).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("rows and typed numbers set boxes as hands do") {
  for (const int dim : {2, 3}) {
    CAPTURE(dim);
    Session session = session_of(dim == 2 ? "obb-sat" : "obb-axes");
    for (const Index i : {Index{0}, Index{1}, Index{5}})
      REQUIRE(session.stage()
                  .move(i, session.stage().subject().at(i) + Point3(0.21, 0.13, dim == 3 ? -0.17 : 0))
                  .has_value());
    Session fresh = session_of(dim == 2 ? "obb-sat" : "obb-axes");
    REQUIRE(fresh.stage().set_rows(session.stage().subject().rows()).has_value());
    CHECK(fresh.stage().subject().rows() == session.stage().subject().rows());
    CHECK(fresh.player().trace_hash() == session.player().trace_hash());
    Rows wrong = session.stage().subject().rows();
    wrong[0].back() += 0.1;  // no longer an axis
    CHECK_FALSE(fresh.stage().set_rows(wrong).has_value());
    wrong[0].clear();
    CHECK_FALSE(fresh.stage().set_rows(wrong).has_value());

    const auto numbers = fresh.stage().subject().numbers();
    REQUIRE(numbers.size() == 2);
    CHECK(numbers[1].heading == "Box B");
    std::vector<double> center = numbers[1].rows[0].values;
    center[0] = 2.5;
    REQUIRE(fresh.stage().set_numbers(1, 0, center).has_value());
    CHECK(box(fresh, 1).center[0] == 2.5);
    CHECK(box(fresh, 0).center == box(session, 0).center);
    std::vector<double> turn = numbers[0].rows[2].values;
    turn.back() = 30;
    const Obb<double, 3> before = box(fresh, 0);
    REQUIRE(fresh.stage().set_numbers(0, 2, turn).has_value());
    if (dim == 2) CHECK(angle_of(box(fresh, 0)) * 180 / std::numbers::pi == doctest::Approx(30));
    else CHECK((box(fresh, 0).axes - turned_by(before, 2, std::numbers::pi / 6).axes).norm() < 1e-12);
    CHECK_FALSE(fresh.stage().set_numbers(0, 1, std::vector<double>(dim, -1)).has_value());
    CHECK_FALSE(fresh.stage().set_numbers(0, 3, center).has_value());
    CHECK_FALSE(fresh.stage().set_numbers(2, 0, center).has_value());
    CHECK_FALSE(fresh.stage().set_numbers(0, 0, std::vector<double>(4, 0)).has_value());
  }
}

TEST_CASE("the lessons on boxes play to their end, and their models do the task") {
  for (const char* id : {"obb-sat", "obb-axes", "obb-pca"}) {
    CAPTURE(id);
    Session session = session_of(id);
    REQUIRE(session.grade().has_value());
    CHECK_FALSE(session.grade()->done);
    const auto played = check::play(session);
    REQUIRE_MESSAGE(played.has_value(), (played ? "" : played.error().message()));
    CHECK(played->sound());
    std::size_t asked = 0;
    for (const auto& algorithm : played->algorithms) asked += algorithm.outcomes.size();
    CHECK(asked >= 3);
  }
}

TEST_CASE("a place moves its box: the centre takes it along, a corner stretches it, a knob turns it") {
  for (const char* id : {"obb-sat", "obb-axes"}) {
    CAPTURE(id);
    Session session = session_of(id);
    const int dim = session.stage().subject().dim();
    CHECK(session.stage().subject().size() == 2 * places_of_box(dim));
    const Obb<double, 3> before = box(session, 1), other = box(session, 0);
    const V3 by(0.25, -0.5, dim == 3 ? 0.125 : 0);
    const Index center = index_of(dim, {Kind::kCenter, 1, 0});
    REQUIRE(session.stage().move(center, before.center + by).has_value());
    CHECK(box(session, 1).center == before.center + by);
    CHECK(box(session, 1).axes == before.axes);
    CHECK(box(session, 0).center == other.center);

    const int all = dim == 2 ? 3 : 7;
    const V3 opposite = corner_of(box(session, 1), 0);
    const V3 to = corner_of(box(session, 1), all) + box(session, 1).axes.col(0) * 0.3;
    REQUIRE(session.stage().move(index_of(dim, {Kind::kCorner, 1, all}), to).has_value());
    CHECK((corner_of(box(session, 1), 0) - opposite).norm() < 1e-12);
    CHECK((corner_of(box(session, 1), all) - to).norm() < 1e-12);
    CHECK(box(session, 1).half_extents[0] == doctest::Approx(before.half_extents[0] + 0.15));

    const V3 half = box(session, 1).half_extents, middle = box(session, 1).center;
    for (int turn = 0; turn < 100; ++turn) {
      const V3 hand = middle + V3(1 + turn % 7, turn % 5 - 2, dim == 3 ? turn % 3 - 1 : 0);
      REQUIRE(session.stage().move(index_of(dim, {Kind::kTurn, 1, turn % (dim - 1)}), hand).has_value());
    }
    CHECK(skew(box(session, 1)) < 1e-14);
    CHECK(box(session, 1).half_extents == half);
    CHECK(box(session, 1).center == middle);
    for (int i = 0; i < 102; ++i) session.stage().undo();
    CHECK(box(session, 1).center == before.center);
    CHECK(box(session, 1).axes == before.axes);
    CHECK_FALSE(session.stage().can_undo());
  }
}

TEST_CASE("a knob points where the hand is, also straight back") {
  Session session = session_of("obb-axes");
  const V3 center = box(session, 0).center;
  for (const V3& way : {V3(0, 1, 0), V3(0, -1, 0), V3(0.6, 0, 0.8), V3(-0.6, 0, -0.8)}) {
    REQUIRE(session.stage().move(index_of(3, {Kind::kTurn, 0, 0}), center + 2 * way).has_value());
    CHECK((box(session, 0).axes.col(0) - way).norm() < 1e-12);
    CHECK(box(session, 0).axes.determinant() == doctest::Approx(1));
  }
}

TEST_CASE("a corner pulled past its opposite makes the box flat, and what is no number is refused") {
  Session session = session_of("obb-sat");
  const V3 far = box(session, 0).center - box(session, 0).axes.col(0) * 10;
  REQUIRE(session.stage().move(index_of(2, {Kind::kCorner, 0, 3}), far).has_value());
  CHECK(box(session, 0).half_extents[0] == 0);
  const BoxPair before = boxes_of(session.stage().subject());
  CHECK_FALSE(session.stage().move(0, V3(std::nan(""), 0, 0)).has_value());
  CHECK_FALSE(session.stage().add(V3(0, 0, 0)).has_value());
  CHECK_FALSE(session.stage().remove(0).has_value());
  BoxPair wrong = before;
  wrong.boxes[0].half_extents[1] = -1;
  CHECK_FALSE(set_boxes(session, wrong).has_value());
  CHECK(boxes_of(session.stage().subject()).boxes[0].center == before.boxes[0].center);
}

TEST_CASE("a task that was done is said to be solved before where another situation is shown") {
  Session session = session_of("obb-axes");
  session.stage().start_task(1);
  REQUIRE(session.stage().situation() == "far");
  REQUIRE(set_boxes(session, model(session, 1)).has_value());
  REQUIRE(session.grade(1).done);
  REQUIRE(session.stage().show_situation("own").has_value());
  CHECK(task_says(session, 1) == "Solved before. " + session.grade(1).says);
}

TEST_CASE("what solved a task is kept, and put on the stage again") {
  Session session = session_of("obb-axes");
  session.stage().start_task(1);
  REQUIRE(set_boxes(session, model(session, 1)).has_value());
  REQUIRE(session.grade(1).done);
  CHECK_FALSE(session.can_solve_again(1));  // it stands there
  const Rows solved = session.stage().subject().rows();
  const KeptAnswers kept = kept_answers_of(kept_text(answers_of(session)));
  Session later = session_of("obb-axes");
  take_up(later, kept);
  REQUIRE(later.can_solve_again(1));
  CHECK_FALSE(later.can_solve_again(0));
  REQUIRE(later.solve_again(1).has_value());
  CHECK(later.stage().subject().rows() == solved);
  CHECK(later.grade(1).done);
}

TEST_CASE("a lesson that is opened again goes on with the first task that was not done") {
  Session session = session_of("obb-sat");
  session.take_up({{.task = 0}});
  CHECK(session.stage().task() == 1);
  session.take_up({{.task = 1}});
  CHECK(session.stage().task() == 1);  // there is none left
}

TEST_CASE("a task that was done stays done while the next one is built") {
  Session session = session_of("obb-sat");
  REQUIRE(session.lesson().tasks.size() == 2);
  session.stage().start_task(1);
  CHECK(session.stage().task() == 1);
  REQUIRE(set_boxes(session, model(session, 1)).has_value());
  CHECK(session.grade()->done);
  CHECK(session.was_done(1));
  CHECK(task_says(session, 1) == session.grade(1).says);
  CHECK_FALSE(session.tasks_done());
  session.stage().reset();
  CHECK_FALSE(session.grade(1).done);
  CHECK(session.was_done(1));
  CHECK(task_says(session, 1) == "Solved before. " + session.grade(1).says);
  CHECK(task_says(session, 0) == session.grade(0).says);
  REQUIRE(set_boxes(session, model(session, 0)).has_value());
  CHECK(session.grade(0).done);
  CHECK(session.tasks_done());
}

TEST_CASE("scattered boxes keep their sizes, and a seed leads to the same") {
  Session session = session_of("obb-axes");
  const V3 half = box(session, 0).half_extents;
  session.stage().scatter(7);
  const Obb<double, 3> first = box(session, 0);
  CHECK(first.half_extents == half);
  CHECK(skew(first) < 1e-14);
  session.stage().scatter(8);
  CHECK(box(session, 0).center != first.center);
  session.stage().scatter(7);
  CHECK(box(session, 0).center == first.center);
  CHECK(box(session, 0).axes == first.axes);
  CHECK(session.stage().subject().origin().seed == 7);
}

TEST_CASE("in float the boxes are rounded, and in double they are what they were, hands and rows included") {
  for (const char* id : {"obb-sat", "obb-axes", "frustum-2d", "frustum-3d", "frustum-sphere"}) {
    CAPTURE(id);
    Session session = session_of(id);
    const std::uint64_t trace = session.player().run(0).hash();
    const Rows rows = session.stage().subject().rows();
    REQUIRE(session.stage().set_float(true).has_value());
    CHECK(session.stage().subject().in_float());
    for (const int i : {0, 1}) {
      const Obb<double, 3>& rounded = box(session, i);
      CHECK(rounded.center == converted<double, 3>(converted<float, 3>(rounded)).center);
      CHECK(rounded.axes == converted<double, 3>(converted<float, 3>(rounded)).axes);
      CHECK(rounded.center.isApprox(boxes_of(session_of(id).stage().subject()).boxes[i].center, 1e-6));
    }
    CHECK(session.player().run(0).hash() != trace);
    CHECK(session.stage().subject().rows() == rows);

    const Point3 to = session.stage().subject().at(0) + Point3(0.123456789, 0, 0);
    REQUIRE(session.stage().move(0, to).has_value());
    CHECK(session.stage().subject().at(0)[0] == static_cast<double>(static_cast<float>(to[0])));
    session.stage().scatter(7);
    CHECK(session.stage().subject().in_float());
    session.stage().undo();
    session.stage().undo();
    REQUIRE(session.stage().set_float(false).has_value());
    CHECK(session.stage().subject().rows() == rows);
    CHECK(session.player().run(0).hash() == trace);
  }
}

TEST_CASE("what is tested in float is what double, and exact arithmetic, make of the rounded boxes") {
  int apart = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed)
    for (const char* id : {"obb-sat", "obb-axes"}) {
      static const Session plane = session_of("obb-sat"), space = session_of("obb-axes");
      const BoxPair pair = rounded_to_float(
          scattered(boxes_of((std::string_view(id) == "obb-sat" ? plane : space).stage().subject()), seed));
      BoxPair in_double = pair;
      in_double.in_float = false;
      CHECK(says_overlap("sat", pair) == says_overlap("sat", in_double));
      apart += says_overlap("sat", pair) ? 0 : 1;
    }
  CHECK(apart > 100);
  CHECK(apart < 700);
}

TEST_CASE("a naive test is broken in float alone where it is wrong in float, and right in double") {
  const auto wrong = [](std::string_view test, const BoxPair& pair) {
    return says_overlap(test, pair) != overlap_exactly(test, pair);
  };
  int reached = 0;
  for (const char* id : {"vanishing-axes", "epsilons"}) {
    Session session = session_of(id);
    for (double angle = 1e-17; angle < 1e-3; angle *= 3) {
      std::unique_ptr<Subject> subject = session.stage().subject().clone();
      REQUIRE(subject->drive("angle", 1, angle));
      const BoxPair pair = boxes_of(*subject);
      for (const std::string test : {"no_epsilon", "epsilon_on_r", "absolute_epsilon", "relative_epsilon"}) {
        const bool in_float = wrong(test + "_float", pair), in_double = wrong(test, pair);
        CHECK(subject->goals()->reaches(test + "_in_float_alone") == (in_float && !in_double));
        reached += in_float && !in_double ? 1 : 0;
      }
      // Switching the stage to float changes no verdict about it.
      const bool before = subject->goals()->reaches("no_epsilon_in_float_alone");
      REQUIRE(subject->scalar()->set_float(true));
      CHECK(subject->goals()->reaches("no_epsilon_in_float_alone") == before);
    }
  }
  CHECK(reached > 3);
}

TEST_CASE("a box that float cannot hold is refused in float alone") {
  Session session = session_of("obb-sat");
  REQUIRE(session.stage().move(0, Point3(1e30, 0, 0)).has_value());
  const Done refused = session.stage().set_float(true);
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().what.find("larger than this program can take (1.1e18)") != std::string::npos);
  CHECK_FALSE(session.stage().subject().in_float());
  session.stage().undo();
  REQUIRE(session.stage().set_float(true).has_value());
  CHECK_FALSE(session.stage().move(0, Point3(1e30, 0, 0)).has_value());
}

TEST_CASE("every place is found again by its index, and bears its own name") {
  for (const int dim : {2, 3})
    for (Index i = 0; i < 2 * places_of_box(dim); ++i) {
      CHECK(index_of(dim, place_of(dim, i)) == i);
      for (Index j = 0; j < i; ++j) CHECK(place_name(dim, i) != place_name(dim, j));
    }
}

TEST_CASE("an axis named by its question is one of the table, and the traces of the tests are told apart") {
  Session session = session_of("obb-axes");
  CHECK(axis_names(2).size() == 4);
  REQUIRE(axis_names(3).size() == 15);
  int seen = 0;
  for (const auto& entry : pair_run(session.player().run(0)).trace())
    if (const auto* axis = std::get_if<query::AxisTested<double, 3>>(&entry.step.fact))
      CHECK(axis_index(3, axis->axis) == seen++);
  CHECK(seen == 12);
  const std::uint64_t first = session.player().trace_hash();
  REQUIRE(session.player().choose(0, "sat_all").has_value());
  CHECK(session.player().steps() == 17);
  CHECK(session.player().trace_hash() != first);
}

TEST_CASE(
    "the lesson on fifteen axes opens on boxes that one edge axis alone separates, and the early-out test gets to "
    "it") {
  Session session = session_of("obb-axes");
  CHECK(reaches("only_edges", boxes_of(session.stage().subject())));
  CHECK_FALSE(reaches("last_axis", boxes_of(session.stage().subject())));
  const auto tested = axes_seen(pair_run(session.player().run(0)).trace());
  REQUIRE(tested.size() == 12);
  for (const auto& axis : tested) CHECK(axis.separates == (&axis == &tested.back()));
  CHECK(tested.back().axis.kind == query::AxisKind::kEdgeEdge);
  CHECK(tested.back().axis.gap > 0.2);  // wide enough to be seen
  REQUIRE(session.player().choose(0, "sat_all").has_value());
  int separating = 0;
  for (const auto& axis : axes_seen(pair_run(session.player().run(0)).trace())) {
    separating += axis.separates ? 1 : 0;
    if (!axis.separates) CHECK(axis.axis.gap < -0.2);  // and so are the overlaps
  }
  CHECK(separating == 1);
}

TEST_CASE("boxes that edges alone separate, and such as the last axis alone does, are told from others") {
  Session session = session_of("obb-axes");
  const BoxPair last = model(session, 0);
  CHECK(reaches("last_axis", last));
  CHECK(reaches("only_edges", last));
  BoxPair far = last, through = last;
  far.boxes[1].center[0] = 4;      // face axes separate them as well
  through.boxes[1].center[0] = 1;  // none does
  for (const char* goal : {"last_axis", "only_edges"}) {
    CHECK_FALSE(reaches(goal, far));
    CHECK_FALSE(reaches(goal, through));
  }
  session.stage().start_task();
  CHECK(session.grade()->says == "Still to find: boxes that only the last axis, A z × B z, separates.");
  REQUIRE(set_boxes(session, last).has_value());
  CHECK(session.grade()->done);
}

TEST_CASE("an axis in the end is the one that the verdict rests on, with its figures, not the last one tested") {
  Session session = session_of("obb-sat");
  REQUIRE(session.player().choose(0, "sat_all").has_value());
  session.jump(session.player().steps());
  CHECK(text_of(session.telling().figures(), "axis") == "B x");
  CHECK(text_of(session.telling().figures(), "gap") == "0.201 units");
  CHECK(text_of(session.telling().figures(), "tests") == "4 of 4");
  session.jump(session.player().steps() - 1);
  CHECK(text_of(session.telling().figures(), "axis") == "B y");
  // Where boxes overlap and the test ends without an axis, no figure is of one.
  REQUIRE(session.player().choose(0, "sat").has_value());
  BoxPair one = boxes_of(session.stage().subject());
  one.boxes[1].center = one.boxes[0].center;
  REQUIRE(set_boxes(session, one).has_value());
  session.jump(session.player().steps());
  for (const char* key : {"axis", "distance", "radius_a", "radius_b", "gap"})
    CHECK(text_of(session.telling().figures(), key) == "—");
}

TEST_CASE("which axis separates boxes that are apart by less than rounding: the one that exact arithmetic found") {
  Session session = session_of("obb-sat");
  BoxPair pair = boxes_of(session.stage().subject());
  for (auto& box : pair.boxes) box.axes.setIdentity(), box.half_extents = {1, 1, 0};
  pair.boxes[0].center = {0, 0, 0};
  pair.boxes[1].center = {std::nextafter(2.0, 3.0), 0, 0};
  REQUIRE(set_boxes(session, pair).has_value());
  REQUIRE(session.player().choose(0, "sat_all").has_value());
  session.go(0);
  REQUIRE(session.conversation().asked() != nullptr);
  REQUIRE(session.conversation().give(OneChoice{0}));
  CHECK(session.conversation().outcome()->right);
  CHECK(session.conversation().outcome()->happened == "A x");
}
