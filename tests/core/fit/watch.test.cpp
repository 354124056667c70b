// The three ways to run an algorithm of the catalogue are one.
#include <doctest/doctest.h>

#include "fit/catalogue.hpp"
#include "geometry/generate.hpp"

using namespace snug;

TEST_CASE("a run has the same result, steps and counts whether it is recorded, watched, counted or ignored") {
  const auto cloud = generate("gaussian", 30, 3, 7);
  REQUIRE(cloud);
  const AnyPointSet points = *PointSet<double, 3>::make(*cloud);
  for (const fit::Algorithm& algorithm : fit::algorithms_of("sphere")) {
    CAPTURE(std::string(algorithm.name));
    const fit::Options options{.seed = 5};
    const fit::Recording recording = algorithm.record(points, options);
    std::vector<Recorder<fit::Step3>::Entry> seen;
    const fit::Watched watched =
        algorithm.watch(points, options, [&](fit::Step3&& step, const OperationCounts& counts) {
          seen.push_back({std::move(step), counts});
        });
    const fit::Watched counted = algorithm.watch(points, options, {});
    const fit::Result ignored = algorithm.fit(points, options);

    REQUIRE(!recording.steps.empty());
    CHECK(fit::hash_of(seen) == fit::hash_of(recording.steps));
    CHECK(seen.back().counts == recording.steps.back().counts);
    for (const fit::Watched& run : {watched, counted}) {
      CHECK(run.steps == static_cast<std::int64_t>(recording.steps.size()));
      CHECK(run.counts == recording.counts);
      CHECK(ball_of(run.result).radius == ball_of(recording.result).radius);
      CHECK((run.certificate.contains || algorithm.loses_points));
    }
    CHECK(ball_of(ignored).center == ball_of(recording.result).center);
    CHECK(ball_of(ignored).radius == ball_of(recording.result).radius);
  }
}

TEST_CASE("what is decided exactly is counted, and the proof of a result is not") {
  const auto exact = [](std::string_view volume, std::string_view name, const AnyPointSet& points) {
    const fit::Watched run = fit::find_algorithm(volume, name)->watch(points, {}, {});
    return run.counts[static_cast<std::size_t>(Operation::kExactDecisions)];
  };
  const AnyPointSet lattice = *PointSet<double, 3>::make(*generate("lattice", 125, 3, 1));
  CHECK(exact("obb", "aabb", lattice) == 0);  // along the coordinates nothing is in doubt
  CHECK(exact("aabb", "min_max", lattice) == 0);
  CHECK(exact("hull", "quickhull", lattice) > 0);
}
