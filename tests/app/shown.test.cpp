// What the stage shows follows from the session's step alone.
#include "app/shown.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace snug::app {
namespace {

lesson::Session session_of(const std::string& algorithm, int dim, const std::string& compare = "") {
  lesson::Lesson lesson;
  lesson.id = "test";
  lesson.points = {.dim = dim, .generate = "clusters", .count = 14};
  lesson.algorithms = {algorithm, "welzl"};
  lesson.compare = compare;
  return *lesson::Session::open(std::move(lesson));
}

const fit::Sphere3& ball_of(const std::optional<fit::Volume3>& volume) {
  REQUIRE(volume);
  REQUIRE(std::holds_alternative<fit::Sphere3>(*volume));
  return *std::get_if<fit::Sphere3>(&*volume);
}

}  // namespace

TEST_CASE("before the first step there is nothing but the points, at the end the optimum as well") {
  for (const char* algorithm : {"aabb_center", "ritter", "ritter_iterative", "pca", "welzl", "brute_force"}) {
    lesson::Session session = session_of(algorithm, 2);
    session.jump(0);
    const Shown start = shown_at(session, false);
    CHECK_FALSE(start.volume);
    CHECK_FALSE(start.optimum);
    CHECK(start.support.size() == 0);
    CHECK(shown_at(session, true).optimum);
    session.jump(session.steps());
    const Shown end = shown_at(session, false);
    CAPTURE(algorithm);
    CHECK(end.finished);
    CHECK(end.support.size() > 0);
    CHECK(ball_of(end.optimum).radius <= ball_of(end.volume).radius * (1 + 1e-9));
  }
}

TEST_CASE("a grown ball stands beside the one before it, and outside is measured from the ball") {
  lesson::Session session = session_of("ritter", 3);
  bool grew = false;
  for (int step = 1; step <= session.steps(); ++step) {
    session.jump(step);
    const Shown shown = shown_at(session, false);
    if (shown.before && shown.volume) {
      CHECK(ball_of(shown.volume).radius > ball_of(shown.before).radius);
      CHECK(std::count(shown.support.begin(), shown.support.end(), session.support(0)[0]) == 1);
      grew = true;
    }
    if (shown.examined_outside) {
      const double distance = (session.point(shown.examined) - ball_of(shown.volume).center).norm();
      CHECK(shown.outside_by == doctest::Approx(distance - ball_of(shown.volume).radius));
      CHECK(shown.outside_by > 0);
    }
  }
  CHECK(grew);
}

TEST_CASE("covariance and axes show the same spread") {
  for (const int dim : {2, 3}) {
    lesson::Session session = session_of("pca", dim);
    session.jump(2);
    const Shown covariance = shown_at(session, false);
    session.jump(3);
    const Shown axes = shown_at(session, false);
    REQUIRE(covariance.spread);
    REQUIRE(axes.spread);
    CHECK_FALSE(covariance.spread->named);
    CHECK(axes.spread->named);
    CHECK((covariance.spread->sigma - axes.spread->sigma).norm() < 1e-9);
    CHECK(std::abs(covariance.spread->axes.col(2).dot(axes.spread->axes.col(2))) == doctest::Approx(1));
    if (dim == 2) CHECK(axes.spread->sigma[0] == 0);
    session.jump(4);
    const Shown ends = shown_at(session, false);
    REQUIRE(ends.pair);
    CHECK(ends.spread->ends);
  }
}

TEST_CASE("Welzl: what is forced is as deep as the recursion") {
  lesson::Session session = session_of("welzl", 2);
  int deepest = 0;
  for (int step = 1; step <= session.steps(); ++step) {
    session.jump(step);
    const Shown shown = shown_at(session, false);
    CHECK(shown.forced.size() <= shown.depth);
    CHECK(shown.depth <= 3);
    deepest = std::max(deepest, shown.forced.size());
  }
  CHECK(deepest >= 2);
}

TEST_CASE("a candidate of brute force fails for a point, or is kept") {
  lesson::Session session = session_of("brute_force", 2, "ritter");
  int failed = 0, outside = 0;
  for (int step = 1; step < session.steps(); ++step) {
    session.jump(step);
    const Shown shown = shown_at(session, false);
    failed += shown.candidate_fails;
    if (shown.left_outside == kNoIndex) continue;
    ++outside;
    const fit::Sphere3& candidate = ball_of(shown.candidate);
    CHECK((session.point(shown.left_outside) - candidate.center).norm() > candidate.radius);
  }
  CHECK(failed > 0);
  CHECK(outside > 0);
  session.jump(session.steps());
  CHECK(shown_at(session, false).rival);
}

/// A box upright across the left side of a frustum that looks along +x.
lesson::Session frustum_session(const std::string& test, bool asks) {
  lesson::Lesson lesson;
  lesson.id = "test";
  lesson.volume = "frustum_box";
  lesson.boxes = lesson::BoxPair{.taper = 0.25};
  lesson.boxes->boxes[0] = {{2, 2, 0}, Matrix<double, 3>::Identity(), {0.4, 0.2, 0}};
  lesson.boxes->boxes[1] = {{2.5, 0, 0}, Matrix<double, 3>::Identity(), {1.5, 4, 0}};
  lesson.algorithms = {test};
  if (asks) {
    lesson::Question& question = lesson.questions.emplace_back();
    question.id = "p";
    question.gate = {test, "plane_tested", 1, ""};
    question.asks = lesson::Question::Asks::kPVertex;
  }
  return *lesson::Session::open(std::move(lesson));
}

TEST_CASE("a question about a plane shows that plane, and its vertices only when it is answered") {
  lesson::Session session = frustum_session("p_n_vertex", true);
  const Shown asked = shown_at(session, false);
  REQUIRE(asked.plane);
  CHECK(asked.plane->plane == 0);
  CHECK(asked.plane_asked);
  CHECK(asked.spoken_of.empty());
  CHECK_FALSE(asked.verdict);
  REQUIRE(session.answer({lesson::Answer::Kind::kChoice, 2}));
  const Shown told = shown_at(session, false);
  REQUIRE(told.plane);
  CHECK_FALSE(told.plane_asked);
  REQUIRE(told.spoken_of.size() == 2);
  CHECK(session.name_of(told.spoken_of[0]) == "−+");
  CHECK(session.name_of(told.spoken_of[1]) == "+−");
  CHECK(told.verdict == query::Culling::kIntersecting);
  CHECK(told.right == std::vector<Index>{told.spoken_of[0]});
}

TEST_CASE("corners are marked as they are tested: of one plane at a time, or of all") {
  lesson::Session per_plane = frustum_session("corners_per_plane", false),
                  all = frustum_session("corners_outside", false);
  for (int step = 1; step < per_plane.steps(); ++step) {
    per_plane.jump(step);
    const Shown shown = shown_at(per_plane, false);
    CHECK(shown.corners.size() == static_cast<std::size_t>((step - 1) % 4 + 1));
    for (const auto& corner : shown.corners) CHECK(corner.plane == (step - 1) / 4);
  }
  all.jump(3);
  CHECK(shown_at(all, false).corners.size() == 3);
  all.jump(all.steps());
  CHECK(shown_at(all, false).corners.size() == 4);
  CHECK(shown_at(all, false).verdict == query::Culling::kIntersecting);
}

}  // namespace snug::app
