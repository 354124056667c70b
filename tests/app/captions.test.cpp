// Every fact of every algorithm has its sentence, in words that a student reads.
#include "app/captions.hpp"

#include <doctest/doctest.h>

#include <set>

#include "geometry/generate.hpp"

namespace snug {
namespace {

AnyPointSet set_of(const std::vector<Vector<double, 3>>& points, int dim) {
  if (dim == 3) return *PointSet<double, 3>::make(points);
  std::vector<Vector<double, 2>> flat;
  for (const auto& p : points) flat.push_back(p.head<2>());
  return *PointSet<double, 2>::make(std::move(flat));
}

fit::Step3 with_ball(double radius, fit::Step3::Fact fact) {
  return {0, true, {Vector<double, 3>::Zero(), radius}, std::move(fact)};
}

std::string alone(const fit::Step3& step, const AnyPointSet& points) { return app::caption_of(step, nullptr, points); }

const AnyPointSet kThree = set_of({{1, 0, 0}, {0, 2.58, 0}, {0, 0, 0}}, 2);

}  // namespace

TEST_CASE("a caption is one sentence: a capital, a full stop, no break, no number that is not one") {
  std::set<std::string_view> seen;
  for (const int dim : {2, 3})
    for (const char* kind : {"gaussian", "lattice", "line", "clusters"})
      for (const fit::Algorithm& algorithm : fit::algorithms()) {
        const AnyPointSet points = set_of(*generate(kind, 12, dim, 7), dim);
        const fit::Recording run = algorithm.record(points, {});
        for (std::size_t i = 0; i < run.steps.size(); ++i) {
          const fit::Step3* next = i + 1 < run.steps.size() ? &run.steps[i + 1].step : nullptr;
          const std::string caption = app::caption_of(run.steps[i].step, next, points);
          seen.insert(fit::name_of(run.steps[i].step));
          INFO(caption);
          REQUIRE(caption.size() > 10);
          REQUIRE(caption.size() < 170);
          REQUIRE(caption.back() == '.');
          REQUIRE(std::isupper(static_cast<unsigned char>(caption.front())));
          REQUIRE(caption.find('\n') == std::string::npos);
          REQUIRE(caption.find("nan") == std::string::npos);
          REQUIRE(caption.find("P-1") == std::string::npos);  // kNoIndex
        }
      }
  // radius_checked and the rest: whatever these runs never reach has a case of its own below.
  for (const std::string_view fact : fit::fact_names())
    if (fact != "support_replaced") CHECK_MESSAGE(seen.count(fact) == 1, fact);
}

TEST_CASE("what is outside is said with its name and by how much") {
  const fit::Sphere3 before{Vector<double, 3>::Zero(), 2};
  CHECK(alone(with_ball(2.29, fit::BallGrown<double, 3>{1, before}), kThree) ==
        "P1 lies outside by 0.58, so the ball grows to take it in.");
  CHECK(alone(with_ball(2, fit::PointExamined{1, 2.58, true, 0}), kThree) == "P1 lies outside by 0.58.");
  const fit::Step3 forced = with_ball(2, fit::BoundaryForced{{1}, 1});
  CHECK(app::caption_of(with_ball(2, fit::PointExamined{1, 2.58, true, 0}), &forced, kThree) ==
        "P1 lies outside by 0.58, so it is on the boundary of the next ball.");
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
  CHECK(alone(end, kThree) == "Done: radius 1.500, held by P0 and P1.");
  CHECK(app::caption_of(end, &end, kThree).find("where it starts") != std::string::npos);
}

TEST_CASE("names in a row") {
  CHECK(app::name_of_points({}) == "no point");
  const std::array<Index, 3> three{3, 9, 12};
  CHECK(app::name_of_points(std::span(three).first(1)) == "P3");
  CHECK(app::name_of_points(three) == "P3, P9 and P12");
}

}  // namespace snug
