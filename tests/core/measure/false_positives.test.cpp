// How often volumes say "may overlap" of bodies that are apart.
#include "measure/false_positives.hpp"

#include <doctest/doctest.h>

#include "geometry/generate.hpp"
#include "lesson/point_subject.hpp"
#include "measure/criteria_run.hpp"

using namespace snug;

namespace {

AnyPointSet cloud(std::string_view kind, int count, int dim) {
  return *lesson::to_set(*generate(kind, count, dim, 3), dim);
}

std::vector<const fit::Algorithm*> all_kinds(int dim) {
  using Name = std::pair<std::string_view, std::string_view>;
  std::vector<const fit::Algorithm*> all;
  for (const auto& [volume, name] :
       {Name{"sphere", "welzl"}, Name{"aabb", "min_max"}, Name{"kdop", dim == 2 ? "k8" : "k14"}, Name{"obb", "pca"},
        Name{"capsule", "pca"}, Name{"lozenge", "pca"}, Name{"hull", "quickhull"}})
    if (fit::takes(*fit::find_algorithm(volume, name), dim)) all.push_back(fit::find_algorithm(volume, name));
  return all;
}

std::vector<cost::FalsePositives> asked(const AnyPointSet& points, bool still, std::uint64_t seed) {
  const auto algorithms = all_kinds(fit::dim_of(points));
  std::vector<fit::Volume3> volumes;
  for (const fit::Algorithm* algorithm : algorithms) volumes.push_back(algorithm->fit(points, {}).volume);
  cost::FalsePositiveRun run(points, algorithms, volumes, still, seed);
  while (!run.done()) run.step();
  return run.rows();
}

}  // namespace

TEST_CASE("a hull has no false positives, and a volume inside another no more than that one") {
  for (const int dim : {2, 3})
    for (const bool still : {false, true}) {
      CAPTURE(dim);
      CAPTURE(still);
      const auto rows = asked(cloud("stick", 30, dim), still, 1);
      for (const cost::FalsePositives& row : rows) {
        CHECK(row.pairs == cost::FalsePositiveRun::kPairs);
        CHECK(row.apart == rows.back().apart);
        CHECK(row.tests >= row.pairs);
        CHECK(row.passed <= row.apart);
      }
      CHECK(rows.back().apart > rows.back().pairs / 4);
      CHECK(rows.back().apart < rows.back().pairs);
      CHECK(rows.back().passed == 0);
      CHECK(rows[2].passed <= rows[1].passed);  // a k-DOP's slabs are the AABB's and more
      CHECK(rows[1].passed > 0);
      CHECK(rows[0].rate() > rows[3].rate());  // the sphere around a stick is mostly empty
    }
}

TEST_CASE("the same seed asks about the same pairs, another about others") {
  const AnyPointSet points = cloud("gaussian", 26, 3);
  const auto once = asked(points, false, 1), again = asked(points, false, 1), other = asked(points, false, 2);
  bool differs = false;
  for (std::size_t i = 0; i < once.size(); ++i) {
    CHECK(once[i].passed == again[i].passed);
    CHECK(once[i].tests == again[i].tests);
    differs = differs || once[i].passed != other[i].passed || once[i].tests != other[i].tests;
  }
  CHECK(differs);
}

TEST_CASE("two points at one place are never apart") {
  const AnyPointSet points = *lesson::to_set({{1, 2, 3}, {1, 2, 3}}, 3);
  for (const cost::FalsePositives& row : asked(points, false, 1)) CHECK(row.rate() == 0);
}

TEST_CASE("the criteria have the costs that a run of costs has, but for times, and an update of every volume") {
  const AnyPointSet points = cloud("gaussian", 26, 3);
  const auto algorithms = all_kinds(3);
  double now = 0;
  const cost::Clock clock = [&now] { return now += 1000; };
  const cost::CostOptions options{.fit = {}, .timing = {.repeats = 3, .batch = 500}, .limits = {}};
  cost::CriteriaRun run(points, algorithms, false, options, clock);
  double before = 0;
  while (!run.done()) {
    CHECK(run.rows().empty());
    run.step();
    CHECK(run.progress() >= before);
    before = run.progress();
  }
  cost::CostRun costs(points, algorithms, options, clock);
  while (!costs.done()) costs.step();
  REQUIRE(run.rows().size() == algorithms.size());
  const auto counted = cost::counted_criteria(points, algorithms, false, {});
  for (std::size_t i = 0; i < algorithms.size(); ++i) {
    const cost::CostRow &row = run.rows()[i].costs, &as = costs.rows()[i];
    CHECK(row.over_hull == as.over_hull);
    CHECK(row.bytes == as.bytes);
    CHECK(row.operations == as.operations);
    CHECK(row.measure == as.measure);
    CHECK(run.rows()[i].update.median > 0);
    CHECK(run.rows()[i].passes.rate() == counted[i].passes.rate());
    CHECK(row.over_hull == counted[i].costs.over_hull);
    CHECK(counted[i].costs.time.repeats == 0);
  }
  cost::CriteriaRun stopped(points, algorithms, false, options, clock);
  stopped.step();
  stopped.stop();
  CHECK(stopped.done());
  CHECK(stopped.rows().empty());
}
