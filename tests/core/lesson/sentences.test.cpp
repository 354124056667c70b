// Every fact of every algorithm has its sentence, in words that a student reads.
#include <doctest/doctest.h>

#include <cctype>
#include <set>

#include "check/check_lesson.hpp"
#include "geometry/generate.hpp"
#include "geometry/random.hpp"
#include "geometry/turn.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/cloud/cloud.hpp"
#include "lesson/subjects/field/field.hpp"
#include "lesson/subjects/frustum/frustum.hpp"
#include "lesson/subjects/pair/pair.hpp"
#include "lesson/subjects/pair/read_volumes.hpp"
#include "lesson/subjects/scene/scene.hpp"
#include "lesson/subjects/tree/tree.hpp"
#include "lesson/subjects/update/update.hpp"

namespace snug {
namespace {

AnyPointSet set_of(const std::vector<Vector<double, 3>>& points, int dim) {
  if (dim == 3) return *PointSet<double, 3>::make(points);
  std::vector<Vector<double, 2>> flat;
  for (const auto& p : points) flat.push_back(p.head<2>());
  return *PointSet<double, 2>::make(std::move(flat));
}

fit::Step3 with_ball(double radius, fit::Step3::Fact fact) {
  return {0, true, fit::Sphere3{Vector<double, 3>::Zero(), radius}, std::move(fact)};
}

/// The sentence of a step that others may stand round.
std::string sentence(std::vector<fit::Step3> steps, int i, const AnyPointSet& points, bool exact) {
  fit::Recording recording;
  for (fit::Step3& step : steps) recording.steps.push_back({std::move(step), {}});
  return lesson::FitRun(points, exact, std::move(recording)).sentence(i, {});
}
std::string alone(const fit::Step3& step, const AnyPointSet& points) { return sentence({step}, 0, points, true); }

const AnyPointSet kThree = set_of({{1, 0, 0}, {0, 2.58, 0}, {0, 0, 0}}, 2);

void require_sentence(const std::string& caption) {
  REQUIRE(caption.find("ball") == std::string::npos);  // a circle in the plane, a sphere in space
  REQUIRE(caption.size() > 10);
  REQUIRE(caption.size() < 170);
  REQUIRE(caption.back() == '.');
  const auto first = static_cast<unsigned char>(caption.front());
  REQUIRE((std::isupper(first) || std::isdigit(first)));
  REQUIRE(caption.find('\n') == std::string::npos);
  REQUIRE(caption.find("nan") == std::string::npos);
  REQUIRE(caption.find("P-1") == std::string::npos);  // kNoIndex
}

std::shared_ptr<const lesson::Tables> boxes_of(const lesson::BoxPair& pair) {
  auto tables = std::make_shared<lesson::PairTables>();
  tables->boxes = pair;
  return tables;
}

/// Every test of two boxes, in the plane and in space: apart, one in the other, and touching, which rounding hides.
std::vector<lesson::Session> box_sessions() {
  std::vector<lesson::Session> sessions;
  for (const int dim : {2, 3})
    for (const double gap : {2.5, 0.1, 2.0})
      for (const lesson::Method& method : lesson::box_tests()) {
        if (dim == 2 && !method.plane) continue;
        const std::string test(method.name);
        lesson::BoxPair pair{.dim = dim};
        for (auto& box : pair.boxes) box.half_extents = {1, 1, dim == 3 ? 1.0 : 0.0};
        pair.boxes[1].center[0] = gap;
        lesson::Lesson lesson;
        lesson.id = "test";
        lesson.volume = "box_pair";
        lesson.points.dim = dim;
        lesson.tables = boxes_of(pair);
        lesson.algorithms = {test};
        auto session = lesson::Session::open(std::move(lesson));
        REQUIRE(session.has_value());
        sessions.push_back(*std::move(session));
      }
  return sessions;
}

lesson::HeldVolume held_hull(std::vector<Vector<double, 3>> points, int dim) {
  lesson::HeldVolume held{.volume = ConvexHull<double, 3>{}, .dim = dim, .points = std::move(points)};
  return lesson::placed(held, Matrix<double, 3>::Identity(), Vector<double, 3>::Zero());
}

/// Two flat prisms a little apart, turned: of some the search has to double its digits.
lesson::VolumePair slivers(Random& random) {
  const Matrix<double, 3> turned = turn({random.between(-1, 1), random.between(-1, 1), 0.3}, random.between(-3, 3));
  std::vector<Vector<double, 3>> a, b;
  for (int i = 0; i < 3; ++i) {
    const Vector<double, 3> p(random.between(-1, 1), random.between(-1, 1), 0);
    const Vector<double, 3> q(random.between(-1, 1), random.between(-1, 1), 1e-12);
    a.push_back(turned * p), a.push_back(turned * (p - Vector<double, 3>(0, 0, 1)));
    b.push_back(turned * q), b.push_back(turned * (q + Vector<double, 3>(0, 0, 1)));
  }
  return {.dim = 3, .held = {held_hull(a, 3), held_hull(b, 3)}};
}

/// Every test of two volumes: apart, one in the other, and hulls that rounding hides the distance of.
std::vector<lesson::Session> volume_sessions() {
  using lesson::HeldVolume;
  std::vector<lesson::Session> sessions;
  const auto add = [&](lesson::VolumePair pair, std::string_view test) {
    lesson::Lesson lesson;
    lesson.id = "test";
    lesson.volume = "volume_pair";
    lesson.points.dim = pair.dim;
    auto tables = std::make_shared<lesson::VolumeTables>();
    tables->pair = std::move(pair);
    lesson.tables = std::move(tables);
    lesson.algorithms = {std::string(test)};
    auto session = lesson::Session::open(std::move(lesson));
    REQUIRE(session.has_value());
    sessions.push_back(*std::move(session));
  };
  for (const int dim : {2, 3})
    for (const double gap : {3.0, 0.25}) {
      const double depth = dim == 3 ? 0.5 : 0;
      const HeldVolume ball{.volume = Sphere<double, 3>{{0, 0, 0}, 1}, .dim = dim};
      const HeldVolume other{.volume = Sphere<double, 3>{{gap, 0, 0}, 0.5}, .dim = dim};
      const HeldVolume box{.volume = Aabb<double, 3>{{-0.5, -0.5, -depth}, {0.5, 0.5, depth}}, .dim = dim};
      const HeldVolume far{.volume = Aabb<double, 3>{{gap, 0, -depth}, {gap + 1, 1, depth}}, .dim = dim};
      add({dim, {ball, other}}, "spheres"), add({dim, {box, far}}, "slabs");
      add({dim, {box, held_hull({{gap, 0, 0}, {gap + 1, 0, depth}, {gap, 1, 0}, {gap + 1, 1, depth}}, dim)}}, "gjk");
    }
  Random random(3);
  for (int i = 0; i < 60; ++i) add(slivers(random), "gjk");
  return sessions;
}

/// Every test of a box against a frustum: inside, across, outside, touching, and lost by the wrong one.
std::vector<lesson::Session> frustum_sessions() {
  std::vector<lesson::Session> sessions;
  for (const int dim : {2, 3})
    for (const double at : {2.5, 1.0, -2.0, 0.75})
      for (const double wide : {0.25, 6.0})
        for (const char* test : {"p_n_vertex", "corners_per_plane", "corners_outside"}) {
          lesson::BoxPair pair{.dim = dim, .taper = 0.25};
          pair.boxes[0].half_extents = {0.25, wide, dim == 3 ? wide : 0.0};
          pair.boxes[0].center[0] = at;
          pair.boxes[1].center[0] = 2.5;
          pair.boxes[1].half_extents = {1.5, 4, dim == 3 ? 4.0 : 0.0};
          lesson::Lesson lesson;
          lesson.id = "test";
          lesson.volume = "frustum_box";
          lesson.points.dim = dim;
          lesson.tables = boxes_of(pair);
          lesson.algorithms = {test};
          auto session = lesson::Session::open(std::move(lesson));
          REQUIRE(session.has_value());
          sessions.push_back(*std::move(session));
        }
  return sessions;
}

/// Every way to build a tree, and every query, over boxes that lie apart, in one another, and all in one place.
std::vector<lesson::Session> tree_sessions() {
  std::vector<lesson::Session> sessions;
  const auto add = [&](const lesson::TreeTables& tables, const lesson::Method& method) {
    lesson::Lesson lesson;
    lesson.id = "test";
    lesson.volume = method.volume;
    lesson.tables = std::make_shared<lesson::TreeTables>(tables);
    lesson.algorithms = {std::string(method.name)};
    auto session = lesson::Session::open(std::move(lesson));
    REQUIRE(session.has_value());
    sessions.push_back(*std::move(session));
  };
  for (const char* kind : {"clusters", "cube", "line"})
    for (const double spread : {1.0, 0.0}) {
      lesson::TreeTables tables;
      tables.stage.boxes = lesson::boxes_by({kind, 9}, 4);
      for (lesson::HeldBox& box : tables.stage.boxes) box.center *= spread;
      tables.stage.query = lesson::QueryPlaces{{lesson::Point2(-1, -0.5), lesson::Point2(1.5, 1)}};
      tables.stage.by_hand = std::vector<lesson::HandPair>{{0, 1}, {2, 9}};
      for (const lesson::Method& method : lesson::build_methods_and_hand()) add(tables, method);
      for (const lesson::Method& method : lesson::query_methods()) add(tables, method);
      for (const lesson::Method& method : lesson::update_methods()) add(tables, method);
    }
  return sessions;
}

/// Every way to cull a field, of many boxes and of a few, some of which the camera does not see at all.
std::vector<lesson::Session> field_sessions() {
  std::vector<lesson::Session> sessions;
  for (const int objects : {8, 9, 400})
    for (const double aim : {0.0, -100.0})
      for (const lesson::Method& method : lesson::field_methods()) {
        lesson::Lesson lesson;
        lesson.id = "test";
        lesson.volume = method.volume;
        auto tables = std::make_shared<lesson::FieldTables>();
        tables->stage.recipe.objects = objects;
        tables->stage.now = tables->stage.before = {{-30, 8, 10}, {aim, 6, 0}};
        tables->stage.now.aim[2] = 1;
        lesson.tables = std::move(tables);
        lesson.algorithms = {std::string(method.name)};
        auto session = lesson::Session::open(std::move(lesson));
        REQUIRE(session.has_value());
        sessions.push_back(*std::move(session));
      }
  return sessions;
}

/// Every update of a body that has rotated, a little and by half a turn.
std::vector<lesson::Session> update_sessions() {
  std::vector<lesson::Session> sessions;
  for (const int dim : {2, 3})
    for (const char* turn : {"8", "180"})
      for (const lesson::Method& method : lesson::kUpdateRow.methods("update")) {
        if (!(dim == 2 ? method.plane : method.space)) continue;
        const std::string text = "version = 2\ntitle = \"t\"\nsummary = \"s\"\nminutes = 3\nvolume = \"update\"\n" +
                                 ("seed = 5\nalgorithms = [\"" + std::string(method.name)) +
                                 "\"]\n[points]\ngenerate = \"ball\"\ncount = 20\ndim = " + std::to_string(dim) +
                                 "\n[body]\nturn = " + (dim == 2 ? turn : std::string("[0, ") + turn + ", 0]") +
                                 "\n[[section]]\ntitle = \"First\"\ntext = \"A.\"\n";
        auto lesson = check::checked_lesson(text, "update.toml");
        REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
        auto session = lesson::Session::open(*std::move(lesson));
        REQUIRE(session.has_value());
        sessions.push_back(*std::move(session));
      }
  return sessions;
}

/// Scenes of pairs, of a volume that follows a body, and of one that comes to rest.
std::vector<lesson::Session> scene_sessions() {
  std::vector<lesson::Session> sessions;
  for (const bool pairs : {true, false})
    for (const double degrees : {0.0, 20.0}) {
      lesson::Lesson lesson;
      lesson.id = "test";
      lesson.volume = "scene";
      lesson.points = {.dim = 3, .generate = "ball", .count = 12};
      auto set = std::make_shared<lesson::SceneSet>();
      set->frames = 30;
      set->bodies.resize(1);
      set->bodies[0].body.shape = scene::Volume3(Sphere<double, 3>{Vector<double, 3>::Zero(), 0.3});
      (pairs ? set->bodies[0].at_points : set->bodies[0].of_points) = true;
      set->effects = {{.name = "spin", .settings = {{"degrees", {degrees}, ""}}}, {.name = "refit"}};
      if (pairs) set->effects.push_back({.name = "broad_phase"}), set->effects.push_back({.name = "narrow_phase"});
      lesson.tables = std::move(set);
      lesson.algorithms = {pairs ? "tree" : "hill_climb"};
      auto session = lesson::Session::open(std::move(lesson));
      REQUIRE(session.has_value());
      REQUIRE(session->player().steps() == 30);
      sessions.push_back(*std::move(session));
    }
  return sessions;
}

/// Points on a grid of 27 places, where a textbook's rounding goes wrong: most places have several points.
AnyPointSet small_grid(int n) {
  Random random(1);
  std::vector<Vector<double, 3>> points(n);
  for (auto& point : points)
    for (int axis = 0; axis < 3; ++axis) point[axis] = random.below(3);
  return set_of(points, 3);
}

}  // namespace

TEST_CASE("a caption is one sentence: a capital, a full stop, no break, no number that is not one") {
  std::set<std::string_view> seen;
  const auto check = [&](const lesson::Run& run, int dim, bool exact_ball) {
    for (int i = 0; i < run.steps(); ++i) {
      const std::string caption = run.sentence(i, {});
      seen.insert(run.fact(i));
      INFO(caption);
      require_sentence(caption);
      REQUIRE(caption.find(dim == 2 ? " sphere" : " circle") == std::string::npos);
      REQUIRE((exact_ball || caption.find("supported by") == std::string::npos ||
               caption.find("new candidate") != std::string::npos));
    }
  };
  const auto check_fit = [&](const fit::Algorithm& algorithm, const AnyPointSet& points) {
    check(lesson::FitRun(points, algorithm.exact, algorithm.record(points, {})), fit::dim_of(points),
          algorithm.exact || algorithm.volume != "sphere");
  };
  for (const fit::Algorithm& algorithm : fit::algorithms()) {
    for (const int dim : {2, 3})
      for (const char* kind : {"gaussian", "lattice", "line", "clusters"})
        if (fit::takes(algorithm, dim)) check_fit(algorithm, set_of(*generate(kind, 12, dim, 7), dim));
    if (fit::takes(algorithm, 3)) check_fit(algorithm, set_of({{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, 3));
  }
  check_fit(*fit::find_algorithm("sphere", "welzl_recursive"), set_of(*generate("gaussian", 1100, 3, 7), 3));
  check_fit(*fit::find_algorithm("sphere", "welzl_naive"), small_grid(200));
  for (const auto& sessions : {box_sessions, volume_sessions, frustum_sessions, field_sessions, tree_sessions,
                               scene_sessions, update_sessions})
    for (const lesson::Session& session : sessions())
      check(session.player().run(0), session.stage().subject().dim(), true);
  for (const lesson::SubjectRow* subject : lesson::subjects())
    for (const std::string_view fact : subject->facts()) CHECK_MESSAGE(seen.count(fact) == 1, fact);
}

TEST_CASE("what is outside is said with its name and by how much") {
  const fit::Sphere3 before{Vector<double, 3>::Zero(), 2};
  CHECK(alone(with_ball(2.29, fit::BallGrown<double, 3>{1, before}), kThree) ==
        "P1 lies outside by 0.580, so the circle grows to contain it.");
  const fit::Sphere3 nearly{Vector<double, 3>::Zero(), fit::point_of(kThree, 1).norm()};
  CHECK(alone(with_ball(2.58, fit::BallGrown<double, 3>{1, nearly}), kThree) ==
        "P1 lies outside by no more than rounding, so the circle grows to contain it.");
  CHECK(alone(with_ball(2, fit::PointExamined{1, 2.58, true, 0}), kThree) == "P1 lies outside by 0.580.");
  const fit::Step3 forced = with_ball(2, fit::BoundaryForced{{1}, 1});
  CHECK(sentence({with_ball(2, fit::PointExamined{1, 2.58, true, 0}), forced}, 0, kThree, true) ==
        "P1 lies outside by 0.580, so it must be on the boundary of the next circle.");
}

TEST_CASE("the support set: who joins and who leaves") {
  CHECK(alone(with_ball(2, fit::SupportReplaced{2, {0, 1}, {1, 2}}), kThree) ==
        "P2 joins the support set, and P0 leaves it.");
  CHECK(alone(with_ball(2, fit::SupportReplaced{2, {0, 1}, {0, 1, 2}}), kThree) ==
        "P2 joins the support set, and none leaves it.");
  CHECK(alone(with_ball(2, fit::SupportReplaced{2, {0, 1}, {2}}), kThree) ==
        "P2 joins the support set, and P0 and P1 leave it.");
  CHECK(alone(with_ball(2, fit::SupportReplaced{kNoIndex, {0, 1}, {1}}), kThree).find("P0 leaves") == 0);
}

TEST_CASE("the same fact at the start of a trace and at its end") {
  const fit::Step3 end = with_ball(1.5, fit::Finished{{0, 1}});
  CHECK(alone(end, kThree) == "Done: radius 1.500, supported by P0 and P1.");
  CHECK(sentence({end}, 0, kThree, false) == "Done: radius 1.500; it touches P0 and P1.");
  CHECK(sentence({end, end}, 0, kThree, false) == "It starts from Ritter's circle, with radius 1.500.");
}

TEST_CASE("a pass is judged with the digits that tell it from the best") {
  const auto judged = [](double radius, bool better, double best) {
    return alone(with_ball(radius, fit::PassJudged<double, 3>{7, better, {Vector<double, 3>::Zero(), best}}), kThree);
  };
  CHECK(judged(0.99214, false, 0.99208) ==
        "Pass 7 ends at 0.99214, larger than the best so far, 0.99208: it is dropped.");
  CHECK(judged(1.5, false, 1.25) == "Pass 7 ends at 1.500, larger than the best so far, 1.250: it is dropped.");
  CHECK(judged(0.992, false, 0.992) == "Pass 7 ends at 0.992, as large as the best so far: it is dropped.");
  CHECK(judged(0.992, true, 0.992) == "Pass 7 ends at 0.992, the smallest so far: it is kept.");
  const fit::Step3 better =
      with_ball(0.99182, fit::PassJudged<double, 3>{6, true, {Vector<double, 3>::Zero(), 0.99182}});
  const fit::Step3 worse =
      with_ball(0.99196, fit::PassJudged<double, 3>{5, true, {Vector<double, 3>::Zero(), 0.99196}});
  CHECK(sentence({worse, better}, 1, kThree, false) ==
        "Pass 6 ends at 0.9918, smaller than the best so far, 0.9920: it is kept.");
}

TEST_CASE("a point on the circle is said to be there") {
  CHECK(alone(with_ball(1, fit::PointExamined{0, 1, false}), kThree) == "P0 lies on the circle: nothing changes.");
  CHECK(alone(with_ball(1.5, fit::PointExamined{0, 1, false}), kThree) == "P0 lies inside by 0.500: nothing changes.");
}

TEST_CASE("the circle through two points is the smallest of many") {
  using Tried = fit::CandidateTried<double, 3>;
  const fit::Sphere3 ball{{1, 0, 0}, 2.5};
  CHECK(
      alone(with_ball(2.5, Tried{{0, 1}, ball, Tried::Verdict::kKept, kNoIndex}), kThree) ==
      "The smallest circle through P0 and P1 contains all points and, with radius 2.500, is the smallest so far: it is "
      "kept.");
  CHECK(alone(with_ball(2.5, Tried{{0, 1}, ball, Tried::Verdict::kLeavesPointOutside, 2}), kThree) ==
        "The smallest circle through P0 and P1 leaves P2 outside, and is dropped.");
  CHECK(alone(with_ball(2.5, Tried{{0, 1, 2}, ball, Tried::Verdict::kNotSmaller, kNoIndex}), kThree) ==
        "The circle through P0, P1 and P2 is no smaller than the best: no point needs testing.");
}

TEST_CASE("many spheres pass through the vertices of a square, so none is said to be missing") {
  using Tried = fit::CandidateTried<double, 3>;
  const AnyPointSet square = set_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, 3);
  CHECK(alone(with_ball(1, Tried{{0, 1, 2, 3}, {}, Tried::Verdict::kDependent, kNoIndex}), square) ==
        "P0, P1, P2 and P3 lie in one plane, so they determine no sphere.");
  CHECK(alone(with_ball(1, Tried{{0, 1, 2}, {}, Tried::Verdict::kDependent, kNoIndex}), kThree) ==
        "P0, P1 and P2 lie on one line, so they determine no circle.");
}

TEST_CASE("in the plane the vertices decide a lozenge's radius") {
  CHECK(alone({0, true, Lozenge<double, 3>{}, fit::ThicknessFound{0, kNoIndex, 0.5}}, kThree) ==
        "The radius is 0.500, the largest for which no rounded vertex cuts off a point.");
}

TEST_CASE("a box that is tried is said to stand on an edge, on two edges or on a face") {
  using Tried = fit::BoxTried<double, 3>;
  const AnyPointSet space = set_of({{1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {1, 1, 1}}, 3);
  const fit::Step3 tried{0, true, Obb<double, 3>{}, Tried{{0, 3, 1, 3}, {}, 2, false}};
  const fit::Step3 searched{0, true, Obb<double, 3>{}, fit::EdgeSearched{0, 3, 4, 2, 9}};
  CHECK(sentence({tried, searched}, 0, space, true) ==
        "The box on the edges from P0 to P3 and from P1 to P3 has volume 2.000, no smaller than the best: it is "
        "dropped.");
  CHECK(sentence({{0, true, Obb<double, 3>{}, fit::EdgeSearched{0, 3, 4, 2, 0}}}, 0, space, true)
            .find("2 are ruled out at once, the rest without halving.") != std::string::npos);
  const fit::Step3 face{0, true, Obb<double, 3>{}, Tried{{0, 1, 2}, {}, 2, true}};
  CHECK(alone(face, space) ==
        "The box on the face of P0, P1 and P2 has volume 2.000, the smallest so far: it is kept.");
  CHECK(sentence({{0, false, {}, fit::PointsChosen{{0, 1, 2, 3}}}, face}, 1, space, false) ==
        "The box along the edge from P0 to P1, with a face through P2, has volume 2.000, the smallest so far: it is "
        "kept.");
  CHECK(alone({0, true, Obb<double, 3>{}, Tried{{0, 1, 2}, {}, 2, true}}, kThree) ==
        "The box on the edge from P0 to P1 has area 2.000, the smallest so far: it is kept.");
}

TEST_CASE("points that quickhull drops may lie on the outline") {
  CHECK(alone({0, false, {}, fit::PointsAssigned{{}, {}, {}, {0, 1}, 2}}, kThree) ==
        "No point lies outside these edges: 2 points are dropped.");
  CHECK(alone({0, false, {}, fit::PointsAssigned{{0}, {3}, {}, {0}, 1}}, kThree) ==
        "3 points lie outside and are assigned to edges; 1 does not, and is dropped.");
}

TEST_CASE("names in a row") {
  CHECK(lesson::point_names({}, nullptr) == "no point");
  const std::array<Index, 3> three{3, 9, 12};
  CHECK(lesson::point_names(std::span(three).first(1), nullptr) == "P3");
  CHECK(lesson::point_names(three, nullptr) == "P3, P9 and P12");
  const auto names = std::make_shared<const std::vector<std::string>>(std::vector<std::string>{"A", "B", "C", "D"});
  CHECK(lesson::point_names(three, names) == "D, P9 and P12");
}

}  // namespace snug
