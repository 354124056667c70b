// What the stage shows follows from the session's step alone.
#include "app/subjects/cloud/shown.hpp"

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
    const CloudShown start = cloud_shown_at(session, false);
    CHECK_FALSE(start.volume);
    CHECK_FALSE(start.optimum);
    CHECK(start.support.size() == 0);
    CHECK(cloud_shown_at(session, true).optimum);
    session.jump(session.player().steps());
    const CloudShown end = cloud_shown_at(session, false);
    CAPTURE(algorithm);
    CHECK(end.finished);
    CHECK(end.support.size() > 0);
    CHECK(ball_of(end.optimum).radius <= ball_of(end.volume).radius * (1 + 1e-9));
  }
}

TEST_CASE("a grown ball stands beside the one before it, and outside is measured from the ball") {
  lesson::Session session = session_of("ritter", 3);
  bool grew = false;
  for (int step = 1; step <= session.player().steps(); ++step) {
    session.jump(step);
    const CloudShown shown = cloud_shown_at(session, false);
    if (shown.before && shown.volume) {
      CHECK(ball_of(shown.volume).radius > ball_of(shown.before).radius);
      CHECK(std::count(shown.support.begin(), shown.support.end(), session.player().support(0)[0]) == 1);
      grew = true;
    }
    if (shown.examined_outside) {
      const double distance = (session.stage().subject().at(shown.examined) - ball_of(shown.volume).center).norm();
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
    const CloudShown covariance = cloud_shown_at(session, false);
    session.jump(3);
    const CloudShown axes = cloud_shown_at(session, false);
    REQUIRE(covariance.spread);
    REQUIRE(axes.spread);
    CHECK_FALSE(covariance.spread->named);
    CHECK(axes.spread->named);
    CHECK((covariance.spread->sigma - axes.spread->sigma).norm() < 1e-9);
    CHECK(std::abs(covariance.spread->axes.col(2).dot(axes.spread->axes.col(2))) == doctest::Approx(1));
    if (dim == 2) CHECK(axes.spread->sigma[0] == 0);
    session.jump(4);
    const CloudShown ends = cloud_shown_at(session, false);
    REQUIRE(ends.pair);
    CHECK(ends.spread->ends);
  }
}

TEST_CASE("Welzl: what is forced is as deep as the recursion") {
  lesson::Session session = session_of("welzl", 2);
  int deepest = 0;
  for (int step = 1; step <= session.player().steps(); ++step) {
    session.jump(step);
    const CloudShown shown = cloud_shown_at(session, false);
    CHECK(shown.forced.size() <= shown.depth);
    CHECK(shown.depth <= 3);
    deepest = std::max(deepest, shown.forced.size());
  }
  CHECK(deepest >= 2);
}

TEST_CASE("a candidate of brute force fails for a point, or is kept") {
  lesson::Session session = session_of("brute_force", 2, "ritter");
  int failed = 0, outside = 0;
  for (int step = 1; step < session.player().steps(); ++step) {
    session.jump(step);
    const CloudShown shown = cloud_shown_at(session, false);
    failed += shown.candidate_fails;
    if (shown.left_outside == kNoIndex) continue;
    ++outside;
    const fit::Sphere3& candidate = ball_of(shown.candidate);
    CHECK((session.stage().subject().at(shown.left_outside) - candidate.center).norm() > candidate.radius);
  }
  CHECK(failed > 0);
  CHECK(outside > 0);
  session.jump(session.player().steps());
  CHECK(cloud_shown_at(session, false).rival);
}

TEST_CASE("Quickhull's hull stands on the stage until the result does, with its vertices as support") {
  for (const int dim : {2, 3}) {
    lesson::Lesson lesson;
    lesson.id = "test";
    lesson.volume = "hull";
    lesson.points = {.dim = dim, .generate = "lattice", .count = 27};
    lesson.algorithms = {"quickhull"};
    lesson::Session session = *lesson::Session::open(std::move(lesson));
    bool merged = false;
    for (int step = 1; step < session.player().steps(); ++step) {
      session.jump(step);
      const CloudShown shown = cloud_shown_at(session, false);
      REQUIRE(shown.growing);
      CHECK_FALSE(shown.volume);
      CHECK(shown.support == shown.growing->vertices());
      CHECK(shown.flat.empty() != shown.growing->merged);
      merged = merged || shown.growing->merged;
    }
    CHECK(merged == (dim == 3));
    session.jump(session.player().steps());
    CHECK(cloud_shown_at(session, false).volume);
  }
}

TEST_CASE("where Ritter's ball grows, the lengths of his formula are shown, and nowhere else") {
  lesson::Session session = session_of("ritter", 2);
  int grown = 0;
  for (int step = 1; step <= session.player().steps(); ++step) {
    session.jump(step);
    const CloudShown shown = cloud_shown_at(session, false);
    CHECK(shown.grown.has_value() == (session.player().run(0).fact(step - 1) == "ball_grown"));
    if (!shown.grown) continue;
    ++grown;
    const double dist = (session.stage().subject().at(shown.grown->point) - shown.grown->before.center).norm();
    CHECK(ball_of(shown.volume).radius == doctest::Approx((shown.grown->before.radius + dist) / 2));
  }
  CHECK(grown > 0);
}

}  // namespace snug::app
