// The named cases in lessons/cases: each is what its sentence says, and the careful methods are right on it.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/lesson/lesson_files.hpp"
#include "fit/catalogue.hpp"
#include "lesson/course.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/cloud/cloud.hpp"
#include "lesson/subjects/cloud/covariance_digits.hpp"
#include "lesson/subjects/cloud/left_outside.hpp"
#include "lesson/subjects/frustum/frustum.hpp"
#include "lesson/subjects/frustum/matrix_planes.hpp"
#include "lesson/subjects/pair/pair.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const auto& entry : std::filesystem::directory_iterator(test::lessons_folder() + "cases"))
    if (entry.path().filename() != "course.toml") all.push_back(entry.path().stem().string());
  return all;
}

/// Whether a naive method's covariance has hardly a digit right.
bool has_lost_its_digits(const fit::Algorithm& algorithm, const AnyPointSet& points) {
  for (const auto& entry : algorithm.record(points, {}).steps)
    if (const auto* found = std::get_if<fit::CovarianceFound<double, 3>>(&entry.step.fact))
      return digits_right(found->covariance, points) < 2;
  return false;
}

/// Whether a naive method is wrong on what stands on the stage; none if the method is a careful one.
std::optional<bool> is_wrong_there(const Session& session, const Method& method) {
  if (const auto* pair = as<PairSubject>(session.stage().subject())) {
    if (!is_naive(method.name)) return std::nullopt;
    return says_overlap(method.name, pair->boxes()) != overlap_exactly(method.name, pair->boxes());
  }
  if (const auto* frustum = as<FrustumSubject>(session.stage().subject())) {
    if (!is_of_matrix(method.name) && method.name != "corners_outside") return std::nullopt;
    return verdict_of(method.name, frustum->boxes()) == query::Culling::kOutside &&
           share_a_point(frustum->boxes()).value_or(false);
  }
  const fit::Algorithm* algorithm = fit::find_algorithm(method.volume, method.name);
  if (algorithm == nullptr || !algorithm->naive) return std::nullopt;
  const AnyPointSet& points = *session.stage().subject().points();
  if (!algorithm->loses_points) return has_lost_its_digits(*algorithm, points);
  return !left_by(points, algorithm->fit(points, {.seed = session.stage().subject().origin().seed}))->none();
}

}  // namespace

TEST_CASE("the cases are listed once each, and each reads as a lesson") {
  const auto course = read_course(test::lessons_file("cases/course.toml"), "course.toml", names());
  REQUIRE_MESSAGE(course.has_value(), (course ? "" : course.error().message()));
  for (const std::string& name : names()) {
    CAPTURE(name);
    const Session session = test::session_of("cases/" + name);
    CHECK(session.lesson().source.find("https://") != std::string::npos);
    CHECK(session.lesson().questions.empty());
    const Block& first = session.lesson().sections.front().blocks.front();  // its sentence is read beside the stage
    CHECK(first.rows.front().front().front().text == session.lesson().summary);
  }
}

TEST_CASE("on every case each careful fit contains all points, exactly, and is the smallest where it claims to be") {
  int fits = 0;
  for (const std::string& name : names()) {
    CAPTURE(name);
    const Session session = test::session_of("cases/" + name);
    const AnyPointSet* points = session.stage().subject().points();
    if (points == nullptr) continue;
    for (const std::string& own : session.lesson().algorithms) {
      CAPTURE(own);
      const Method& method = *find_method(session.lesson(), own);
      const fit::Algorithm& algorithm = *fit::find_algorithm(method.volume, method.name);
      if (algorithm.loses_points) continue;
      for (const bool in_float : {false, true}) {
        const auto set = to_set(all_points(*points), session.stage().subject().dim(), in_float);
        REQUIRE(set.has_value());
        const fit::Watched watched = algorithm.watch(*set, {.seed = session.stage().subject().origin().seed}, {});
        CHECK(watched.certificate.contains);
        CHECK(watched.certificate.on_boundary);
        CHECK(watched.certificate.optimal.value_or(true));
        ++fits;
      }
    }
  }
  CHECK(fits > 60);
}

TEST_CASE("where a case begins with a naive method, that method is wrong on it") {
  int shown = 0;
  for (const std::string& name : names()) {
    CAPTURE(name);
    const Session session = test::session_of("cases/" + name);
    const auto wrong = is_wrong_there(session, *find_method(session.lesson(), session.lesson().algorithms.front()));
    if (!wrong) continue;
    CHECK(*wrong);
    ++shown;
  }
  CHECK(shown >= 10);
}

TEST_CASE("the big box is outside the frustum, and crosses each plane that could reject it") {
  const Session session = test::session_of("cases/big-box");
  const BoxPair& boxes = as<FrustumSubject>(session.stage().subject())->boxes();
  CHECK_FALSE(share_a_point(boxes).value_or(true));
  for (const std::string& test : session.lesson().algorithms)
    CHECK(verdict_of(test, boxes) == query::Culling::kIntersecting);
}

TEST_CASE("the exact separation is that of a row, and a verdict that no axis separates has none") {
  Session session = test::session_of("cases/unit-of-length");
  const auto exact_gap = [&] {
    const auto figures = session.telling().figures();
    const auto found =
        std::find_if(figures.begin(), figures.end(), [](const Figure& one) { return one.key == "exact_gap"; });
    return found != figures.end() && found->known;
  };
  session.jump(session.player().steps());
  CHECK_FALSE(exact_gap());
  session.jump(session.player().steps() - 1);
  CHECK(exact_gap());
}
