// A box and a frustum in a lesson: their places, their questions, the task, and what the reader refuses.
#include "lesson/subjects/frustum/frustum.hpp"

#include <doctest/doctest.h>

#include <set>

#include "check/check_lesson.hpp"
#include "check/play.hpp"
#include "core/lesson/lesson_files.hpp"
#include "geometry/frustum_corners.hpp"
#include "lesson/grade.hpp"
#include "lesson/subjects.hpp"

using namespace snug;
using namespace snug::lesson;
using query::Culling;
using snug::test::session_of;
using V3 = Vector<double, 3>;
using Kind = BoxHandle::Kind;

namespace {

/// A frustum that looks along +x from the origin, 90 degrees wide, from 1 to 4; and a box.
BoxPair plain(int dim, const V3& center, const V3& half) {
  BoxPair pair{.dim = dim, .taper = 0.25};
  pair.boxes[0] = {center, Matrix<double, 3>::Identity(), half};
  pair.boxes[1] = {{2.5, 0, 0}, Matrix<double, 3>::Identity(), {1.5, 4, dim == 3 ? 4.0 : 0.0}};
  return pair;
}

/// The name of a place, as a session on such a pair has it.
std::string name_of(int dim, Index i) { return FrustumSubject(plain(dim, V3::Zero(), V3::Ones()), 1).name_of(i); }

/// Whether the pair is what the lesson's task asks for.
bool loses(const BoxPair& pair) {
  return verdict_of("corners_outside", pair) == Culling::kOutside && share_a_point(pair) == true;
}

/// A session on such a pair, which asks the given things of p_n_vertex.
Session asking(const BoxPair& pair, std::vector<Question> questions) {
  Lesson lesson;
  lesson.id = "test";
  lesson.volume = kFrustumBox;
  lesson.points.dim = pair.dim;
  auto tables = std::make_shared<BoxTables>();
  tables->boxes = pair;
  lesson.tables = std::move(tables);
  lesson.algorithms = {"p_n_vertex"};
  for (Question& question : questions) {
    question.gate.algorithm = "p_n_vertex";
    question.id += std::to_string(lesson.questions.size());
    lesson.questions.push_back(std::move(question));
  }
  auto session = Session::open(std::move(lesson));
  REQUIRE(session.has_value());
  session->go(0);
  return *std::move(session);
}

Question about_plane(const char* asks, int nth) {
  Question question;
  question.gate.fact = "plane_tested";
  question.gate.occurrence = nth;
  question.asks = asks;
  return question;
}

Answer corner(int dim, int bits) { return OneHandle{index_of(dim, {Kind::kCorner, 0, bits})}; }

}  // namespace

TEST_CASE("the lessons on the frustum play to their end; three questions and more of the first test, one of them on "
          "the stage") {
  for (const char* id : {"frustum-2d", "frustum-3d"}) {
    CAPTURE(id);
    Session session = session_of(id);
    CHECK(session.conversation().questions().size() >= 3);
    CHECK(session.conversation().questions().front().question->asks == "p_vertex");
    CHECK(session.conversation().questions().front().on_stage);
    CHECK(session.lesson().sections.size() <= 5);
    REQUIRE(session.grade().has_value());
    CHECK_FALSE(session.grade()->done);
    const auto played = check::play(session);
    REQUIRE_MESSAGE(played.has_value(), (played ? "" : played.error().message()));
    CHECK(played->sound());
    CHECK(played->algorithms.size() == 3);
  }
}

TEST_CASE("the frustum is what its places show: its corners are those of the pair") {
  for (const char* id : {"frustum-2d", "frustum-3d"}) {
    CAPTURE(id);
    const Session session = session_of(id);
    const BoxPair& pair = boxes_of(session.stage().subject());
    const auto near_corner = [&](const V3& wanted, const auto& corners) {
      double nearest = 1e9;
      for (const auto& corner : corners) nearest = std::min(nearest, (corner - wanted.head(corner.size())).norm());
      return nearest;
    };
    for (int bits = 0; bits < 1 << pair.dim; ++bits) {
      const V3 own = corner_of(pair, 1, bits);
      CHECK(own == at_place(pair, index_of(pair.dim, {Kind::kCorner, 1, bits})));
      const double nearest = pair.dim == 2 ? near_corner(own, *corners_of(*frustum_of<2>(pair)))
                                           : near_corner(own, *corners_of(*frustum_of<3>(pair)));
      CHECK(nearest < 1e-14);
    }
    // Each face lies on its plane.
    for (int plane = 0; plane < planes_of_frustum(pair.dim); ++plane) {
      const auto face = face_on_plane(pair.dim, plane);
      for (int bits = 0; bits < 1 << pair.dim; ++bits) {
        const V3 own = corner_of(pair, 1, bits);
        const double distance = pair.dim == 2 ? signed_distance<double, 2>((*frustum_of<2>(pair))[plane], own.head<2>())
                                              : signed_distance<double, 3>((*frustum_of<3>(pair))[plane], own);
        const bool on = ((bits >> face.first & 1) != 0) == face.second;
        CHECK((std::abs(distance) < 1e-13) == on);
        CHECK(distance < 1e-13);
      }
    }
  }
}

TEST_CASE("left is left: seen along the camera's way, with up where the lesson says it is") {
  const BoxPair flat = plain(2, V3::Zero(), V3::Ones());
  CHECK((*frustum_of<2>(flat))[0].normal[1] > 0);  // who looks along +x has +y on the left
  const FrustumCamera<double, 3> camera = camera_of(plain(3, V3::Zero(), V3::Ones()));
  CHECK(camera.position.norm() < 1e-15);
  CHECK(camera.axes.col(0) == V3(0, 0, 1));
  CHECK(camera.axes.col(1) == V3(0, 1, 0));
  CHECK(camera.near == doctest::Approx(1));
  CHECK(camera.far == doctest::Approx(4));
  CHECK(camera.half_tangents[0] == doctest::Approx(1));
  CHECK(plane_name(3, 2) == "bottom");
  CHECK(plane_names(2, 0b1101) == "the left, near and far planes");
  CHECK(plane_names(2, 0b0100) == "the near plane");
}

TEST_CASE("a corner of the frustum is dragged: it follows the hand, and the opposite one stays") {
  for (const char* id : {"frustum-2d", "frustum-3d"}) {
    CAPTURE(id);
    Session session = session_of(id);
    const int dim = session.stage().subject().dim(), all = (1 << dim) - 1;
    for (int bits = 0; bits <= all; ++bits) {
      const BoxPair before = boxes_of(session.stage().subject());
      const V3 opposite = corner_of(before, 1, ~bits & all);
      const V3 to = corner_of(before, 1, bits) + (corner_of(before, 1, bits) - opposite) * 0.11 +
                    before.boxes[1].axes.col(1) * 0.03;
      REQUIRE(session.stage().move(index_of(dim, {Kind::kCorner, 1, bits}), to).has_value());
      const BoxPair& after = boxes_of(session.stage().subject());
      CHECK((corner_of(after, 1, ~bits & all) - opposite).norm() < 1e-14);
      CHECK((corner_of(after, 1, bits) - to).norm() < 1e-14);
      CHECK(after.taper == before.taper);
      CHECK(after.boxes[0].center == before.boxes[0].center);
    }
    for (int i = 0; i <= all; ++i) session.stage().undo();
    CHECK_FALSE(session.stage().can_undo());
  }
}

TEST_CASE("a frustum does not become flat: the corner stays where it was, and no size of 0 is taken") {
  Session session = session_of("frustum-2d");
  const BoxPair before = boxes_of(session.stage().subject());
  const V3 beyond = before.boxes[1].center - before.boxes[1].axes.col(0) * 10;
  CHECK_FALSE(session.stage().move(index_of(2, {Kind::kCorner, 1, 3}), beyond).has_value());
  BoxPair wrong = before;
  wrong.boxes[1].half_extents[0] = 0;
  CHECK_FALSE(set_boxes(session, wrong).has_value());
  CHECK(boxes_of(session.stage().subject()).boxes[1].center == before.boxes[1].center);
  wrong = before;
  wrong.boxes[0].half_extents.setZero();  // a box may be a point
  CHECK(set_boxes(session, wrong).has_value());
}

TEST_CASE("box and frustum bear names of their own, and every place another") {
  for (const int dim : {2, 3})
    for (Index i = 0; i < 2 * places_of_box(dim); ++i)
      for (Index j = 0; j < i; ++j) CHECK(name_of(dim, i) != name_of(dim, j));
  CHECK(name_of(2, 0) == "Box");
  CHECK(name_of(2, index_of(2, {Kind::kCorner, 0, 1})) == "+−");
  CHECK(name_of(3, index_of(3, {Kind::kCorner, 0, 6})) == "−++");
  CHECK(name_of(2, index_of(2, {Kind::kTurn, 1, 0})) == "Frustum turn");
}

TEST_CASE("the three tests: inside, intersecting, outside, and the box that the wrong one loses") {
  const auto says = [](const BoxPair& pair) {
    return std::array{verdict_of("p_n_vertex", pair), verdict_of("corners_per_plane", pair),
                      verdict_of("corners_outside", pair)};
  };
  for (const int dim : {2, 3}) {
    CAPTURE(dim);
    const V3 small(0.2, 0.2, dim == 3 ? 0.2 : 0.0);
    CHECK(says(plain(dim, {2.5, 0, 0}, small)) == std::array{Culling::kInside, Culling::kInside, Culling::kInside});
    CHECK(says(plain(dim, {1, 0, 0}, small)) ==
          std::array{Culling::kIntersecting, Culling::kIntersecting, Culling::kIntersecting});
    CHECK(says(plain(dim, {-2, 0, 0}, small)) == std::array{Culling::kOutside, Culling::kOutside, Culling::kOutside});
    const BoxPair lost = plain(dim, {2, 0, 0}, {0.2, 5, dim == 3 ? 5.0 : 0.0});
    CHECK(says(lost) == std::array{Culling::kIntersecting, Culling::kIntersecting, Culling::kOutside});
    CHECK(share_a_point(lost) == true);
    CHECK(loses(lost));
    // Beyond the far left corner: outside, but of no one plane.
    const BoxPair beside = plain(dim, {4.25, 4.6, 0}, {0.75, 0.4, dim == 3 ? 0.1 : 0.0});
    CHECK(says(beside) == std::array{Culling::kIntersecting, Culling::kIntersecting, Culling::kOutside});
    CHECK(share_a_point(beside) == false);
    CHECK_FALSE(loses(beside));  // the wrong test is right here
  }
}

TEST_CASE("in float no body that reaches into the frustum is lost, exactly, and the switch changes the planes") {
  int outside = 0;
  for (const char* id : {"frustum-2d", "frustum-3d", "frustum-sphere", "frustum-point"}) {
    CAPTURE(id);
    const Session session = session_of(id);
    const std::string test(session.player().method(0)->name);
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      const BoxPair pair = rounded_to_float(scattered(boxes_of(session.stage().subject()), seed));
      const Culling verdict = verdict_of(test, pair);
      outside += verdict == Culling::kOutside;
      if (verdict == Culling::kOutside) CHECK_FALSE(share_a_point(pair).value_or(false));
    }
  }
  CHECK(outside > 50);
}

TEST_CASE("p- and n-vertex are answered on the stage, by a corner of the box and nothing else") {
  BoxPair pair = plain(2, {2, 1.8, 0}, {0.4, 0.2, 0});
  pair.boxes[0] = turned_by(pair.boxes[0], 2, 0.3);
  Session session = asking(pair, {about_plane("p_vertex", 1), about_plane("n_vertex", 2)});
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK(session.conversation().asked()->stage_points.size() == 4);
  CHECK(session.conversation().asked()->choices == std::vector<std::string>{"−−", "+−", "−+", "++"});
  CHECK_FALSE(session.conversation().give(OneHandle{index_of(2, {Kind::kCenter, 0, 0})}));
  CHECK_FALSE(session.conversation().give(OneHandle{index_of(2, {Kind::kCorner, 1, 2})}));
  REQUIRE(session.conversation().give(corner(2, 2)));  // the left normal is (-1, 1): up and back
  CHECK(session.conversation().outcome()->right);
  CHECK(session.conversation().outcome()->says == "−+ lies farthest along the normal of the left plane.");
  CHECK(session.conversation().asked() == nullptr);  // until it was read
  REQUIRE(session.conversation().acknowledge());
  REQUIRE(session.conversation().asked() != nullptr);
  REQUIRE(session.conversation().give(OneChoice{0}));
  CHECK_FALSE(session.conversation().outcome()->right);
  CHECK(session.conversation().outcome()->predicted == "−−");
  CHECK(session.conversation().outcome()->happened == "++");
}

TEST_CASE("corners that tie are right, each of them, and no other") {
  // The near plane's normal is -x: a whole side of an upright box lies farthest along it. Turned by as much, box and
  // frustum tie within rounding.
  for (const double turn : {0.0, 0.7}) {
    BoxPair pair = plain(2, {1, 0, 0}, {0.3, 0.2, 0});
    for (auto& box : pair.boxes) box = turned_by(box, 2, turn);
    for (const int bits : {0, 1, 2, 3}) {
      Session session = asking(pair, {about_plane("p_vertex", 3)});
      session.go(2);
      REQUIRE(session.conversation().give(corner(2, bits)));
      CHECK(session.conversation().outcome()->right == ((bits & 1) == 0));
    }
  }
  // Without any depth its ends are on one spot.
  Session session = asking(plain(2, {1, 0.5, 0}, {0, 0.2, 0}), {about_plane("p_vertex", 1)});
  REQUIRE(session.conversation().give(corner(2, 3)));
  CHECK(session.conversation().outcome()->right);
}

TEST_CASE("the side of a plane and the verdict are chosen among the three") {
  Question verdict;
  verdict.gate.fact = "classified";
  verdict.asks = "verdict";
  Session session =
      asking(plain(2, {1, 0, 0}, {0.3, 0.2, 0}), {about_plane("plane_side", 1), about_plane("plane_side", 3), verdict});
  CHECK(session.conversation().asked()->choices == std::vector<std::string>{"inside", "intersecting", "outside"});
  REQUIRE(session.conversation().give(OneChoice{0}));
  CHECK(session.conversation().outcome()->right);
  session.go(2);
  REQUIRE(session.conversation().give(OneChoice{2}));
  CHECK_FALSE(session.conversation().outcome()->right);
  CHECK(session.conversation().outcome()->happened == "intersecting");
  session.go(session.player().steps());
  REQUIRE(session.conversation().give(OneChoice{1}));
  CHECK(session.conversation().outcome()->right);
  CHECK(session.conversation().outcome()->says == "The box crosses the near plane and is not entirely outside any.");
}

TEST_CASE("figures and proof: the plane, the distances, the verdict, and whether the test is right") {
  const auto end = [](const BoxPair& pair, const char* test) {
    Session session = asking(pair, {});
    REQUIRE(session.player().choose(0, test).has_value());
    session.go(session.player().steps());
    return session.player().proofs();
  };
  const BoxPair lost = plain(3, {2, 0, 0}, {0.2, 5, 5});
  CHECK_FALSE(end(lost, "corners_outside")[1].holds);
  CHECK(end(lost, "corners_outside")[1].claimed);
  CHECK(end(lost, "p_n_vertex")[1].holds);
  const auto said = [](const BoxPair& pair, const char* test) {
    Session session = asking(pair, {});
    REQUIRE(session.player().choose(0, test).has_value());
    session.go(session.player().steps());
    return std::pair(session.telling().caption(), session.player().marks().back().kind);
  };
  CHECK(said(lost, "corners_outside").first.ends_with(" Wrong: the box reaches into the frustum."));
  CHECK(said(lost, "corners_outside").second == Mark::Kind::kWrong);
  CHECK(said(lost, "p_n_vertex").first.find("Wrong") == std::string::npos);
  const BoxPair beside = plain(3, {4.25, 4.6, 0}, {0.75, 0.4, 0.1});
  CHECK(said(beside, "corners_outside").first.ends_with("so this test says outside."));
  CHECK(said(beside, "corners_outside").second == Mark::Kind::kReplaced);
  CHECK(end(beside, "corners_outside")[1].holds);
  CHECK_FALSE(end(beside, "p_n_vertex")[1].holds);
  CHECK_FALSE(end(beside, "p_n_vertex")[1].claimed);  // it claims nothing there

  Session session = asking(plain(2, {1, 0, 0}, {0.25, 0.25, 0}), {});
  const auto value = [&](std::string_view key) {
    for (const auto& figure : session.telling().figures())
      if (figure.key == key) return figure.known ? figure.value : -99.0;
    return -100.0;
  };
  CHECK(value("p_distance") == -99);
  session.go(3);
  CHECK(value("plane") == 2);
  CHECK(value("p_distance") == doctest::Approx(0.25));
  CHECK(value("n_distance") == doctest::Approx(-0.25));
  CHECK(value("planes_tested") == 3);
  CHECK(value("corners") == 6);
  CHECK(value("verdict") == 1);
  session.go(session.player().steps());  // the verdict is of all planes: no figure is of one
  for (const char* key : {"plane", "signs", "p_distance", "n_distance"}) CHECK(value(key) == -99);
  CHECK(value("planes_tested") == 4);
}

TEST_CASE(
    "every line of the tests' pseudocode can be reached by one box: none is left for a parent that is not there") {
  for (const Method& test : frustum_tests(kFrustumBox)) {
    CAPTURE(test.name);
    std::set<int> lit;
    for (const double x : {2.5, 1.0, -2.0})
      for (const auto& entry : record_frustum(test.name, plain(3, {x, 0, 0}, {0.2, 0.2, 0.2})))
        lit.insert(entry.step.line);
    for (const int line : lit) CHECK(line < static_cast<int>(test.pseudocode.size()));
    CHECK(*lit.rbegin() == static_cast<int>(test.pseudocode.size()) - 1);
    for (const std::string_view line : test.pseudocode) CHECK(line.find("parent") == std::string_view::npos);
  }
}

TEST_CASE("a wrong box is told from the task's by its verdict, and the sentence says which way") {
  Session session = session_of("frustum-2d");
  session.stage().start_task();
  CHECK(session.grade()->says.find("keeps this box") != std::string::npos);
  BoxPair away = boxes_of(session.stage().subject());
  away.boxes[0].center = {-9, 0, 0};
  REQUIRE(set_boxes(session, away).has_value());
  CHECK(session.grade()->says.find("right here") != std::string::npos);
  REQUIRE(session.stage().set_rows(session.lesson().tasks[0].model).has_value());
  CHECK(session.grade()->done);
}

TEST_CASE("each mistake about a frustum is told with its line") {
  struct Broken {
    std::string_view from, to, marker, says;
  };
  constexpr Broken kBroken[] = {
      {"taper = 0.3\n", "", "[boxes]", "lacks the key \"taper\""},
      {"taper = 0.3", "taper = 1", "taper = 1", "below 1"},
      {"taper = 0.3", "taper = 0", "taper = 0", "above 0"},
      {"[1.05, 1.15]]\nturn = [[-24]", "[0, 1.15]]\nturn = [[-24]", "half_extents", "of a frustum must be above 0"},
      {"volume = \"frustum_box\"", "volume = \"box_pair\"", "algorithms", "p_n_vertex"},
      {"goal = \"corners_outside\"", "goal = \"only_edges\"", "goal", "only_edges"},
      {"asks = \"p_vertex\"", "asks = \"verdict\"", "[[question]]\nid = \"p-vertex\"",
       "can only be asked of classified"},
      {"asks = \"verdict\"", "asks = \"n_vertex\"", "[[question]]\nid = \"verdict\"",
       "can only be asked of plane_tested"},
      {"[0.2, 1.7]", "[0.2, 0.17]", "[task.model]", "does not solve the task: The wrong test"},
      {"asks = \"n_vertex\"", "asks = \"nearest_vertex\"", "nearest_vertex", "none of point"},
  };
  const std::string good = test::lessons_file("frustum-2d.toml");
  for (const Broken& broken : kBroken) {
    CAPTURE(broken.to);
    std::string text = good;
    const auto at = text.find(broken.from);
    REQUIRE(at != std::string::npos);
    text.replace(at, broken.from.size(), broken.to);
    const auto lesson = check::checked_lesson(text, "x.toml");
    REQUIRE_FALSE(lesson.has_value());
    CHECK_MESSAGE(lesson.error().message().find(broken.says) != std::string::npos, lesson.error().message());
    const auto line =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find(broken.marker)), '\n') + 1;
    CHECK_MESSAGE(lesson.error().message().find("x.toml:" + std::to_string(line)) == 0, lesson.error().message());
  }
}

TEST_CASE("a point is on one of two sides of a plane, and not across it") {
  Session session = session_of("frustum-point");
  session.go(0);
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK(session.conversation().asked()->question->id == "left-sign");
  CHECK(session.conversation().asked()->choices ==
        std::vector<std::string>{"in the negative half-space", "on the plane", "in the positive half-space"});
  REQUIRE(session.conversation().give(OneChoice{0}));
  CHECK(session.conversation().outcome()->right);
  CHECK(session.conversation().outcome()->happened == "in the negative half-space");
}

TEST_CASE("a number of one plane is hidden where it is asked for, and told at the planes before") {
  Session session = session_of("frustum-point");
  session.go(0);
  const auto distance = [&] {
    for (const Figure& figure : session.telling().figures())
      if (figure.key == "distance") return figure.text;
    return std::string("none");
  };
  REQUIRE(session.conversation().give(OneChoice{0}));
  CHECK(distance() == "−0.288 units");
  session.conversation().acknowledge();
  session.go(2);
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK(session.conversation().asked()->question->id == "distance");
  CHECK(distance() == "—");
}

TEST_CASE("a task that needs a verdict says which one, in its word") {
  Session session = session_of("frustum-point");
  const Task& task = session.lesson().tasks.front();
  const Grade grade =
      grade_by_requirements(session.lesson(), task, session.stage().subject(), session.player().view(0));
  CHECK(grade.says == "Planes tested: 4 of 4. Verdict: inside; it must be outside.");
}
