// The planes of a rounded view-projection matrix: those of the camera while near is not too close, and then not.
#include "lesson/subjects/frustum/matrix_planes.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "core/lesson/lesson_files.hpp"
#include "geometry/random.hpp"
#include "lesson/subjects/frustum/frustum.hpp"

using namespace snug;
using namespace snug::lesson;
using query::Culling;

namespace {

/// A frustum 8 units deep, its camera about 50 units from the origin, and a thin box just before its far face.
BoxPair far_away(double near) {
  BoxPair pair{.dim = 3, .taper = near};
  pair.boxes[0] = {{54.45, -22.17, 16.09}, Matrix<double, 3>::Identity(), {0.05, 0.15, 0.2}};
  pair.boxes[1] = {{51.4, -21.9, 17.2}, Matrix<double, 3>::Identity(), {4, 2, 3}};
  pair.boxes[1] = turned_by(turned_by(turned_by(pair.boxes[1], 0, 0.17453292519943295), 1, 0.3490658503988659), 2,
                            -0.08726646259971647);
  return pair;
}

}  // namespace

TEST_CASE("with near at a tenth of far, the matrix gives the verdicts of the camera's planes in double and in float") {
  for (int i = 0; i < 300; ++i) {
    BoxPair pair = scattered(far_away(0.1), static_cast<std::uint64_t>(i));
    const Culling careful = verdict_of("p_n_vertex", pair);
    CHECK(verdict_of(kMatrixTests[0], pair) == careful);
    CHECK(verdict_of(kMatrixTests[1], pair) == careful);
  }
}

TEST_CASE("at a millionth of far, the far plane in float is off by many per cent, and loses what is in view") {
  const BoxPair pair = far_away(1e-6);
  const FarPlane in_float = far_plane_of(kMatrixTests[1], pair), in_double = far_plane_of(kMatrixTests[0], pair);
  CHECK(in_float.off < -10);
  CHECK(in_float.degrees > 0.1);
  CHECK(in_float.corners.size() == 4);
  CHECK(std::abs(in_double.off) < 1e-6);
  CHECK(verdict_of(kMatrixTests[1], pair) == Culling::kOutside);
  CHECK(verdict_of(kMatrixTests[0], pair) != Culling::kOutside);
  CHECK(share_a_point(pair) == true);
  const FrustumSubject subject(pair, 1);
  CHECK(subject.reaches(kMatrixTests[1]));
  CHECK(subject.goal_says(kMatrixTests[1]).find("is lost in float, and kept in double") != std::string::npos);
  CHECK_FALSE(FrustumSubject(far_away(0.1), 1).reaches(kMatrixTests[1]));
  // So near that double loses it as well, for it is a lesson about float.
  BoxPair both = pair;
  both.taper = 1e-15;
  CAPTURE(FrustumSubject(both, 1).goal_says(kMatrixTests[1]));
  if (verdict_of(kMatrixTests[0], both) == Culling::kOutside)
    CHECK_FALSE(FrustumSubject(both, 1).reaches(kMatrixTests[1]));
}

TEST_CASE("a verdict that loses the box says so, and the planes in double do not") {
  Session session = test::session_of("frustum-matrix");
  for (const std::string_view planes : {kMatrixTests[0], kMatrixTests[1]}) {
    REQUIRE(session.player().choose(0, planes).has_value());
    session.jump(session.player().steps());
    CHECK(session.telling().caption().ends_with("Wrong: the box reaches into the frustum.") ==
          (planes == kMatrixTests[1]));
  }
}

TEST_CASE("the task says once what both scalars agree on") {
  Session session = test::session_of("frustum-matrix");
  session.stage().start_task();
  CHECK(session.grade(0).says ==
        "This box reaches into the frustum. With the planes of the matrix it is kept in float and in double.");
}

TEST_CASE("at a hundred-millionth the far plane has no normal left in float, and rejects nothing") {
  BoxPair pair = far_away(1e-8);
  CHECK(far_plane_of(kMatrixTests[1], pair).lost);
  CHECK_FALSE(far_plane_of(kMatrixTests[0], pair).lost);
  pair.boxes[0].center += pair.boxes[1].axes.col(0) * 100;  // straight ahead, far behind the far face
  CHECK(verdict_of("p_n_vertex", pair) == Culling::kOutside);
  CHECK(verdict_of(kMatrixTests[0], pair) == Culling::kOutside);
  CHECK(verdict_of(kMatrixTests[1], pair) != Culling::kOutside);
}

TEST_CASE("of a plane without a normal nothing is said but that it rejects nothing") {
  const BoxPair pair = far_away(1e-8);
  const FrustumRun run(kMatrixTests[1], pair), careful(kMatrixTests[0], pair);
  CHECK(run.has_no_normal(5));
  CHECK_FALSE(run.has_no_normal(4));
  CHECK_FALSE(careful.has_no_normal(5));
}

TEST_CASE("near is driven as a share of far, and what the far face and the box are stays") {
  FrustumSubject subject(far_away(0.1), 1);
  REQUIRE(subject.drive("near", 0.1, 1e-6));
  CHECK(subject.boxes().taper == 1e-6);
  CHECK(subject.boxes().boxes[1].center == far_away(0.1).boxes[1].center);
  CHECK_FALSE(subject.drive("near", 1e-6, 0).has_value());
  CHECK(subject.volumes().size() == 1);
  CHECK(subject.planes().size() == 6);
}
