// The survey of a lesson: in portions by the clock, of what stands on the stage.
#include "lesson/subjects/frustum/survey.hpp"

#include <doctest/doctest.h>

#include "core/lesson/lesson_files.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects/frustum/frustum.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

BoxPair ball_and_frustum(int dim) {
  BoxPair pair{.dim = dim, .form = Form::kBall, .taper = 0.3};
  pair.boxes[0].center = {0.35, 0.95, 0};
  pair.boxes[0].half_extents.setConstant(0.3);
  pair.boxes[1].half_extents = {1.05, 1.15, dim == 3 ? 1.3 : 0};
  return pair;
}

double survey_now = 0;
double survey_clock() { return survey_now += 1e5; }

}  // namespace

TEST_CASE("a lesson's survey goes on in portions, and its counts are those of one go") {
  for (const int dim : {2, 3}) {
    FrustumSubject subject(ball_and_frustum(dim), 4, &survey_clock);
    CHECK(subject.survey() == nullptr);
    subject.start_survey();
    REQUIRE(subject.survey() != nullptr);
    CHECK(subject.survey()->counts().spheres == 0);
    subject.work_on_survey(1e6);
    const std::int64_t first = subject.survey()->counts().spheres;
    CHECK(first > 0);
    CHECK(first < 20'000);
    auto copy = FrustumSurvey::make(subject.boxes(), 4);
    REQUIRE(copy.has_value());
    while (copy->counts().spheres < first) copy->step();
    CHECK(copy->counts() == subject.survey()->counts());
    CHECK(copy->counts().false_positives() > 0);
  }
}

TEST_CASE("an edit ends the survey, and without a clock it is done at once") {
  FrustumSubject subject(ball_and_frustum(2), 1);
  subject.start_survey();
  subject.work_on_survey(0);
  REQUIRE(subject.survey() != nullptr);
  CHECK(subject.survey()->done());
  CHECK(subject.survey()->counts().spheres == kSurveySpheres);
  REQUIRE(subject.move(0, Point3(1, 1, 0)).has_value());
  CHECK(subject.survey() == nullptr);
}

TEST_CASE("the survey of the lesson on spheres counts what snug cull --survey prints for its frustum") {
  Session session = test::session_of("frustum-sphere");
  const auto counted = [&](const char* situation) {
    REQUIRE(session.stage().show_situation(situation).has_value());
    auto survey = FrustumSurvey::make(as<FrustumSubject>(session.stage().subject())->boxes(),
                                      session.stage().subject().origin().seed);
    REQUIRE(survey.has_value());
    while (!survey->done()) survey->step();
    return survey->counts();
  };
  using Counts = cost::SurveyCounts;
  const Counts flat = counted("own");
  CHECK(flat == Counts{1'000'000, 157'719, 548'001, 294'280, flat.false_at_two, flat.false_at_more});
  CHECK(flat.false_positives() == 6168);
  CHECK(counted("edge") == Counts{1'000'000, 60'035, 510'409, 429'556, 9939, 7049});
}
