// The moment at which a naive algorithm breaks, against rational arithmetic.
#include "lesson/subjects/cloud/wrong_tests.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>

#include "check/play.hpp"
#include "core/exact.hpp"
#include "core/lesson/lesson_files.hpp"
#include "geometry/random.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects/cloud/fit_run.hpp"

using namespace snug;
using namespace snug::lesson;
using exact::Rational;
using snug::test::session_of;

namespace {

template <class Scalar>
AnyPointSet points_in_the_plane(std::uint64_t seed, int n, bool on_a_line) {
  Random random(seed);
  std::vector<Vector<Scalar, 2>> points;
  for (int i = 0; i < n; ++i) {
    const double x = static_cast<double>(random.below(41)) / 10 - 2;
    const double y = on_a_line ? 0.75 * x : static_cast<double>(random.below(41)) / 10 - 2;
    points.emplace_back(static_cast<Scalar>(x), static_cast<Scalar>(y));
  }
  return *PointSet<Scalar, 2>::make(std::move(points));
}

bool is_among_wrong(const std::vector<WrongTest>& wrong, int step) {
  return std::any_of(wrong.begin(), wrong.end(), [&](const WrongTest& one) { return one.step == step; });
}

template <class Scalar>
int check_spheres(std::string_view algorithm) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    const AnyPointSet points = points_in_the_plane<Scalar>(seed, 12, seed % 2 == 0);
    const fit::Recording run = fit::find_algorithm("sphere", algorithm)->record(points, {.seed = 1});
    const std::vector<WrongTest> wrong = wrong_tests(run, points);
    found += static_cast<int>(wrong.size());
    std::vector<Vector<double, 2>> support;
    for (std::size_t i = 0; i < run.steps.size(); ++i) {
      const auto& fact = run.steps[i].step.fact;
      const auto at = [&](Index point) -> Vector<double, 2> { return fit::point_of(points, point).head<2>(); };
      if (const auto* forced = std::get_if<fit::BoundaryForced>(&fact)) {
        support.clear();
        for (const Index point : forced->boundary) support.push_back(at(point));
      }
      bool is_wrong = false;
      if (const auto* examined = std::get_if<fit::PointExamined>(&fact); examined != nullptr && !support.empty()) {
        const auto ball = exact::ball_through(support);
        if (ball)
          is_wrong = (exact::squared_distance<double, 2>(at(examined->point), ball->center) > ball->square) !=
                     examined->outside;
      }
      CHECK(is_among_wrong(wrong, static_cast<int>(i)) == is_wrong);
    }
  }
  return found;
}

Rational cross(const Point3& a, const Point3& b, const Point3& p) {
  const auto apart = [&](const Point3& to, int axis) { return Rational(to[axis]) - Rational(a[axis]); };
  return apart(b, 0) * apart(p, 1) - apart(b, 1) * apart(p, 0);
}

}  // namespace

TEST_CASE("a test of a naive sphere is wrong where rational arithmetic says the opposite, of the ball through the same "
          "points") {
  CHECK(check_spheres<float>("welzl_naive") > 0);
  CHECK(check_spheres<double>("welzl_naive") > 0);
  check_spheres<float>("welzl_epsilon");
}

TEST_CASE("a point is shared wrongly by a naive hull where rational arithmetic puts it on the other side") {
  int lost = 0, kept = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    const AnyPointSet points = points_in_the_plane<float>(seed, 9, true);
    const fit::Recording run = fit::find_algorithm("hull", "quickhull_rounded")->record(points, {});
    const std::vector<WrongTest> wrong = wrong_tests(run, points);
    for (const WrongTest& test : wrong) {
      const auto& before = run.steps[test.step - 1].step.fact;
      const auto* split = std::get_if<fit::EdgeSplit>(&before);
      const auto* simplex = std::get_if<fit::SimplexChosen>(&before);
      REQUIRE((split != nullptr || simplex != nullptr));
      const auto at = [&](Index i) { return fit::point_of(points, i); };
      const Point3 a = at(split != nullptr ? split->a : simplex->points.front());
      const Point3 c = at(split != nullptr ? split->point : simplex->points.back());
      const Point3 b = split != nullptr ? at(split->b) : a;
      const Point3 p = at(test.point);
      const bool outside = test.truth == WrongTest::Truth::kOutside;
      CHECK(outside == (cross(a, c, p) < 0 || cross(c, b, p) < 0));
      (outside ? lost : kept)++;
    }
    const fit::Recording careful = fit::find_algorithm("hull", "quickhull")->record(points, {});
    CHECK(wrong_tests(careful, points).empty());
  }
  CHECK(lost > 5);
  CHECK(kept > 0);
}

TEST_CASE("the sentence, the figures and the timeline tell the first wrong test") {
  for (const char* id : {"cases/twins", "cases/hull-on-a-line"}) {
    CAPTURE(id);
    Session session = session_of(id);
    const auto& wrong = *fit_run(session.player().run(0)).wrong();
    REQUIRE_FALSE(wrong.empty());
    const int first = wrong.front().step + 1;
    const auto value = [&](std::string_view key) {
      for (const Figure& figure : session.telling().figures())
        if (figure.key == key) return figure.value;
      return -1.0;
    };
    session.go(first - 1);
    CHECK(session.telling().caption().find("Wrong: in exact arithmetic") == std::string::npos);
    CHECK(value("wrong_tests") == (first == 1 ? -1 : 0));
    session.go(first);
    CHECK(session.telling().caption().find("Wrong: in exact arithmetic") != std::string::npos);
    CHECK(value("wrong_tests") >= 1);
    CHECK(value("first_wrong") == first);
    const auto is_wrong = [](const Mark& mark) { return mark.kind == Mark::Kind::kWrong; };
    CHECK(std::count_if(session.player().marks().begin(), session.player().marks().end(), is_wrong) == 1);
    CHECK(std::find_if(session.player().marks().begin(), session.player().marks().end(), is_wrong)->step == first);
  }
}

TEST_CASE("a naive sphere does not claim to touch the points that it is computed from, which it may leave outside") {
  Session session = session_of("cases/twins");
  REQUIRE(session.player().method(0)->naive);
  session.go(session.player().steps());
  CHECK(session.telling().caption().find("Done: radius ") == 0);
  CHECK(session.telling().caption().find(", computed from P") != std::string::npos);
}

TEST_CASE("which point is the first is asked before the run, and its model answer is right") {
  Session session = session_of("rounding-sphere");
  REQUIRE(session.stage().show_situation("twins"));
  const auto asked = std::find_if(session.conversation().questions().begin(), session.conversation().questions().end(),
                                  [](const Asked& one) { return one.question->id == "first-wrong"; });
  REQUIRE(asked != session.conversation().questions().end());
  CHECK(asked->step == 0);
  const Truth truth = asked->kind->truth(*asked, session.player().run(0));
  REQUIRE_FALSE(truth.points.empty());
  CHECK(truth.points.front() == fit_run(session.player().run(0)).wrong()->front().point);
  CHECK(truth.sentence.find("is the first to be wrong") != std::string::npos);
  // A tap cannot tell points in the same place apart.
  std::vector<Index> same;
  for (Index i = 0; i < session.stage().subject().size(); ++i)
    if (session.stage().subject().at(i) == session.stage().subject().at(truth.points.front())) same.push_back(i);
  CHECK(same.size() == 4);
  CHECK(std::is_permutation(truth.points.begin(), truth.points.end(), same.begin(), same.end()));
  CHECK(truth.choices.size() == same.size());
}
