// The updates by name: each holds its body in every pose, tells its steps, and says by how much it is too large.
#include "fit/update/updates.hpp"

#include <doctest/doctest.h>

#include <set>

#include "core/point_clouds.hpp"
#include "fit/catalogue.hpp"
#include "geometry/turn.hpp"

using namespace snug;

namespace {

Pose<double, 3> turned_by(int dim, double radians) {
  Pose<double, 3> pose{.translation = {3, -2, dim == 3 ? 1e3 : 0}};
  if (dim == 2) pose.rotation.topLeftCorner<2, 2>() = turn(radians);
  else pose.rotation = turn(Vector<double, 3>(1, -2, 0.5), radians);
  return pose;
}

/// Every strategy that takes the points, through three poses.
void check_all_updates(const AnyPointSet& points, std::set<std::string>& seen) {
  const int dim = fit::dim_of(points);
  for (const fit::UpdateStrategy& strategy : fit::update_strategies()) {
    if (!(dim == 2 ? strategy.plane : strategy.space)) continue;
    INFO(strategy.volume << " " << strategy.name << ", dim " << dim);
    const fit::UpdateBody update = fit::start_updates(strategy, points);
    for (const double radians : {0.0, 0.4, 2.0}) {
      std::vector<fit::UpdateStep3> steps;
      const auto frame = update(turned_by(dim, radians), [&](const fit::UpdateStep3& step) {
        steps.push_back(step);
        seen.insert(fit::json_of(step, dim).substr(0, 20));
      });
      CHECK(frame.contains);
      CHECK(frame.measure >= frame.tightest);
      CHECK(frame.tightest > 0);
      CHECK(frame.hull > 0);
      CHECK(fit::over_hull(frame.measure, frame.hull) > 1 - 1e-6);  // rounding, in float
      if (strategy.name == "rebuild") CHECK(frame.measure == frame.tightest);
      if (strategy.name == "hill_climb") CHECK(fit::slack(frame.measure, frame.tightest) < 1e-4);  // rounding, in float
      REQUIRE(frame.steps == static_cast<std::int64_t>(steps.size()));
      CHECK(std::holds_alternative<fit::Finished>(steps.back().fact));
      for (const auto& step : steps) CHECK(static_cast<std::size_t>(step.line) < strategy.pseudocode.size());
      CHECK(update(turned_by(dim, radians), {}).measure == frame.measure);
    }
  }
}

}  // namespace

TEST_CASE("every update by name holds its body and tells its steps") {
  std::set<std::string> seen;
  check_all_updates(test::set_of<double, 2>(test::generated<double, 2>("cube", 40, 3)), seen);
  check_all_updates(test::set_of<double, 3>(test::generated<double, 3>("sphere", 60, 3)), seen);
  check_all_updates(test::set_of<float, 2>(test::generated<float, 2>("gaussian", 40, 3)), seen);
  check_all_updates(test::set_of<float, 3>(test::generated<float, 3>("cube", 40, 3)), seen);
  CHECK(seen.size() == 8);  // every kind of step that there is
}

TEST_CASE("updates are found by volume and name") {
  CHECK(fit::find_update("aabb", "loose")->title == "Loose AABB");
  CHECK(fit::find_update("aabb", "transform") == nullptr);
  CHECK(fit::find_update("hull", "rebuild") == nullptr);
}
