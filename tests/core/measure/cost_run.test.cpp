// The cost table: its figures against the catalogue's own, in slices as in one go, and what is too long for a slice.
#include "measure/cost_run.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <ctime>
#include <limits>
#include <utility>

#include "core/measure/false_clock.hpp"
#include "core/point_clouds.hpp"
#include "geometry/random.hpp"
#include "measure/sample.hpp"

using namespace snug;

namespace {

/// Ten times this process's time: other processes do not change it, and a batch is full after a tenth of its runs.
cost::Clock own_clock() {
  return [] { return static_cast<double>(std::clock()) * (1e10 / CLOCKS_PER_SEC); };
}

std::vector<const fit::Algorithm*> all_for(int dim) {
  std::vector<const fit::Algorithm*> list;
  for (const fit::Algorithm& algorithm : fit::algorithms())
    if (!algorithm.naive && fit::takes(algorithm, dim)) list.push_back(&algorithm);
  return list;
}

cost::CostRun run_of(const AnyPointSet& points, std::vector<const fit::Algorithm*> algorithms, const cost::Clock& clock,
                     double batch = 1000) {
  constexpr double kNever = std::numeric_limits<double>::infinity();  // too long on no machine
  return {points,
          std::move(algorithms),
          {.timing = {.repeats = 2, .batch = batch}, .limits = {.longest = kNever, .longest_watched = kNever}},
          clock};
}

void finish(cost::CostRun& run) {
  while (!run.done()) run.step();
}

/// Every row's figures are those that the catalogue gives.
void check_rows(const AnyPointSet& points) {
  const int dim = fit::dim_of(points);
  const auto algorithms = all_for(dim);
  auto run = run_of(points, algorithms, own_clock());
  finish(run);
  REQUIRE(run.rows().size() == algorithms.size());
  const double hull = fit::measure_of(fit::find_algorithm("hull", "quickhull")->fit(points, {}).volume, dim);
  for (std::size_t i = 0; i < algorithms.size(); ++i) {
    const cost::CostRow& row = run.rows()[i];
    INFO(row.volume << " " << row.algorithm << ", dim " << dim);
    CHECK(row.algorithm == algorithms[i]->name);
    if (algorithms[i]->max_points < fit::count_of(points)) {
      CHECK(row.points == algorithms[i]->max_points);
      CHECK(row.whole_ns.value() > 0);
      continue;
    }
    CHECK(row.points == row.of);
    CHECK_FALSE(row.whole_ns);
    const fit::Watched watched = algorithms[i]->watch(points, {}, {});
    CHECK(row.operations == watched.counts);
    CHECK(row.steps == watched.steps);
    CHECK(row.measure == fit::measure_of(watched.result.volume, dim));
    CHECK(row.contains);
    CHECK(row.over_hull.value() == row.measure / hull);
    CHECK(row.over_hull.value() >= 1 - 1e-6);
    CHECK(row.time.median > 0);
    CHECK(row.bytes > 0);
    CHECK(row.overlap.median > 0);
    CHECK(row.overlapping == row.overlap_pairs / 2);
    CHECK(row.update.has_value() != (row.volume == "capsule" || row.volume == "lozenge" || row.volume == "hull"));
    CHECK(row.updated.repeats == (row.update ? 2 : 0));
    const fit::Algorithm* const exact = fit::exact_algorithm(row.volume);
    CHECK(row.tightness.has_value() == (exact != nullptr));
    if (row.tightness) CHECK(row.tightness.value() >= 1 - 1e-6);
    if (row.algorithm == "exact" || row.algorithm == "welzl" || row.volume == "kdop") CHECK(row.tightness.value() == 1);
  }
}

}  // namespace

TEST_CASE("each row has its algorithm's figures, in both dimensions and scalars") {
  check_rows(test::set_of<double, 2>(test::generated<double, 2>("gaussian", 60, 3)));
  check_rows(test::set_of<double, 3>(test::generated<double, 3>("stick", 60, 3)));
  check_rows(test::set_of<float, 2>(test::generated<float, 2>("cube", 50, 3)));
  check_rows(test::set_of<float, 3>(test::generated<float, 3>("gaussian", 50, 3)));
}

TEST_CASE("a volume's bytes are those of its numbers in its own scalar") {
  const AnyPointSet in_float = test::set_of<float, 3>(test::generated<float, 3>("cube", 50, 3));
  auto run = run_of(
      in_float,
      {fit::find_algorithm("sphere", "welzl"), fit::find_algorithm("obb", "pca"), fit::find_algorithm("kdop", "k14")},
      own_clock());
  finish(run);
  CHECK(run.rows()[0].bytes == 16);
  CHECK(run.rows()[1].bytes == 60);
  CHECK(run.rows()[2].bytes == 56);
}

TEST_CASE("flat and single points have rows; what has no size is not divided by") {
  for (const auto& cloud :
       {test::Cloud<double, 3>{{1, 2, 3}}, test::Cloud<double, 3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 3, 0}}}) {
    const AnyPointSet points = test::set_of<double, 3>(cloud);
    auto run = run_of(points, all_for(3), own_clock());
    finish(run);
    CHECK(run.rows().size() == all_for(3).size());
    for (const cost::CostRow& row : run.rows()) {
      CHECK(row.contains);
      CHECK_FALSE(row.over_hull);
      if (row.tightness) CHECK(std::isfinite(row.tightness.value()));
    }
  }
}

TEST_CASE("no volume is told to be smaller than the smallest, and what is flat is compared with nothing") {
  const auto rows_of = [](const AnyPointSet& points, int dim) {
    auto run = run_of(points, all_for(dim), own_clock());
    finish(run);
    std::vector<cost::CostRow> rows = run.rows();
    cost::mark_front(rows);
    return rows;
  };
  Random random(3);
  for (const double away : {0.0, 1.0, 1e6}) {
    const auto direction = [&] {
      return Vector<double, 3>(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    };
    const Vector<double, 3> from = away * direction(), u = direction(), v = direction();
    test::Cloud<double, 3> line, plane, solid;
    for (int i = 0; i < 24; ++i) {
      line.push_back(from + random.between(-1, 1) * u);
      plane.push_back(from + random.between(-1, 1) * u + random.between(-1, 1) * v);
      solid.push_back(from + direction());
    }
    for (const auto& cloud : {line, plane}) {
      const std::vector<cost::CostRow> rows = rows_of(test::set_of<double, 3>(cloud), 3);
      std::vector<cost::Timing> equal;  // the times of boxes of the front that are all equal
      for (const cost::CostRow& row : rows) {
        INFO(away << " " << row.volume << " " << row.algorithm);
        CHECK_FALSE(row.over_hull);
        if (row.volume == "obb") CHECK_FALSE(row.tightness);
        if (row.volume == "sphere" || row.volume == "aabb") CHECK(row.tightness.value() >= 1);
        if (row.on_front && row.volume == "obb" && row.is_flat()) equal.push_back(row.time);
      }
      for (const cost::Timing& a : equal)
        for (const cost::Timing& b : equal)
          CHECK_MESSAGE(cost::faster(a, b, cost::kDoubtInRun) == cost::Faster::kTie, a.median << " " << b.median);
    }
    for (const cost::CostRow& row : rows_of(test::set_of<double, 3>(solid), 3)) {
      INFO(away << " " << row.volume << " " << row.algorithm);
      if (row.points < row.of) continue;
      CHECK(row.over_hull.value() >= 1);
      if (row.tightness) CHECK(row.tightness.value() >= 1);
    }
  }
  test::Cloud<double, 2> line;
  for (int i = 0; i < 20; ++i) line.emplace_back(0.1 * i, 0.3 * i);
  for (const cost::CostRow& row : rows_of(test::set_of<double, 2>(line), 2))
    if (row.volume == "obb") CHECK_FALSE(row.tightness);
}

TEST_CASE("a size below the smallest is that but for rounding, and else is told") {
  const auto set = test::set_of<double, 3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const cost::Rounding rounding = cost::rounding_of(set);
  CHECK(rounding.ratio(1 - rounding.of(3) / 2, 1, 3) == std::optional(1.0));
  CHECK(rounding.ratio(1 - 2 * rounding.of(3), 1, 3).value() < 1);
  CHECK(rounding.ratio(2, 1, 3) == std::optional(2.0));
  CHECK_FALSE(rounding.ratio(1, rounding.noise(3), 3));
  CHECK_FALSE(rounding.ratio(1, 0, 3));
  CHECK(rounding.ratio(1, 1e-9, 3).has_value());  // thin, but by far thicker than rounding
  CHECK(cost::rounding_of(test::set_of<float, 3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})).of(1) >
        1e8 * rounding.of(1));
}

TEST_CASE("in slices the rows are those of one go") {
  const fit::Algorithm linear = test::slow_algorithm<100, 2>("linear"), square = test::slow_algorithm<1, 4>("square");
  const AnyPointSet points = test::set_of<double, 3>(test::generated<double, 3>("cube", 300, 3));
  auto whole = run_of(points, {&linear, &square}, test::false_clock(), 0);
  finish(whole);
  auto sliced = run_of(points, {&linear, &square}, test::false_clock(), 0);
  int slices = 0;
  for (double before = 0; !sliced.done(); ++slices) {
    cost::advance(sliced, test::false_clock(), 1e5);
    CHECK(sliced.progress() >= before);
    before = sliced.progress();
    REQUIRE(slices < 10'000);
  }
  CHECK(slices > 5);
  CHECK(sliced.progress() == 1);
  REQUIRE(sliced.rows().size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(sliced.rows()[i].time.median == doctest::Approx(whole.rows()[i].time.median));
    CHECK(sliced.rows()[i].operations == whole.rows()[i].operations);
    CHECK(sliced.rows()[i].measure == whole.rows()[i].measure);
    CHECK(sliced.rows()[i].tightness == whole.rows()[i].tightness);
    CHECK(sliced.rows()[i].overlapping == whole.rows()[i].overlapping);
  }
  CHECK(whole.rows()[0].time.median == doctest::Approx(30'000));
  CHECK(whole.rows()[1].time.median == doctest::Approx(90'000));
}

TEST_CASE("what would take longer than a slice is measured on fewer points, and says so") {
  const fit::Algorithm square = test::slow_algorithm<256, 4>("square");
  const AnyPointSet points = test::set_of<double, 3>(test::generated<double, 3>("cube", 640, 3));
  cost::CostRun run(points, {&square},
                    {.timing = {.repeats = 3, .batch = 0}, .limits = {.longest = 2e6, .longest_watched = 1e9}},
                    test::ticking_clock());
  double longest = 0;
  while (!run.done()) {
    const double before = test::false_now();
    run.step();
    longest = std::max(longest, test::false_now() - before);
  }
  CHECK(longest < 6.5e6);  // a watched run takes three times as long, and is done again
  const cost::CostRow& row = run.rows().at(0);
  CHECK(row.points == 64);
  CHECK(row.of == 640);
  CHECK(row.whole_ns.value() == doctest::Approx(256.0 * 640 * 640));
  CHECK(row.time.median == doctest::Approx(256.0 * 64 * 64));
  CHECK(row.tightness.value() >= 1);
  CHECK(cost::pareto_front(run.rows()).empty());  // what was measured on fewer points is no rival

  // What seems to grow more steeply than theory's bound does so by chance.
  const fit::Algorithm linear = test::slow_algorithm<256, 4>("linear", fit::kFixedPasses);
  cost::CostRun bounded(points, {&linear},
                        {.timing = {.repeats = 3, .batch = 0}, .limits = {.longest = 2e6, .longest_watched = 1e9}},
                        test::ticking_clock());
  finish(bounded);
  CHECK(bounded.rows().at(0).whole_ns.value() == doctest::Approx(256.0 * 64 * 640));

  cost::CostRun watched(points, {&square},
                        {.timing = {.repeats = 3, .batch = 0}, .limits = {.longest = 1e9, .longest_watched = 1e6}},
                        test::ticking_clock());
  finish(watched);
  CHECK(watched.rows().at(0).points == 32);
}

TEST_CASE("a run that a limit of its own would stop has no time: fewer points are measured, and it is on no front") {
  const fit::Algorithm& recursive = *fit::find_algorithm("sphere", "welzl_recursive");
  REQUIRE(recursive.most_finished < recursive.max_points);
  const AnyPointSet points = test::set_of<double, 3>(test::generated<double, 3>("gaussian", 1400, 3));
  cost::CostRun run = run_of(points, {&recursive, fit::find_algorithm("sphere", "ritter")}, own_clock());
  finish(run);
  const cost::CostRow& row = run.rows().at(0);
  CHECK(row.points == recursive.most_finished);
  CHECK(row.of == 1400);
  CHECK_FALSE(row.whole_ns);
  CHECK(cost::pareto_front(run.rows()) == std::vector<std::size_t>{1});
}

TEST_CASE("stopped, the rows that are ready stay") {
  const AnyPointSet points = test::set_of<double, 3>(test::generated<double, 3>("cube", 100, 3));
  auto run = run_of(points, all_for(3), own_clock());
  while (run.rows().size() < 3) run.step();
  run.stop();
  CHECK(run.done());
  run.step();
  CHECK(run.rows().size() == 3);
}

TEST_CASE("time is foreseen by its growth") {
  CHECK(cost::foreseen(100, 10, 200, 40, 400) == doctest::Approx(160));
  CHECK(cost::foreseen(100, 10, 200, 10, 400) == doctest::Approx(20));  // never less than in proportion
  CHECK(cost::foreseen(0, 0, 10, 5, 20) == doctest::Approx(80));        // from one time alone: the worst
}

TEST_CASE("a sample has each part of the set once") {
  test::Cloud<double, 2> cloud;
  for (int i = 0; i < 1000; ++i) cloud.emplace_back(i, 0);
  const AnyPointSet points = test::set_of<double, 2>(cloud);
  const AnyPointSet fewer = cost::sample(points, 37, 5);
  REQUIRE(fit::count_of(fewer) == 37);
  for (Index i = 0; i < 37; ++i) {
    CHECK(fit::point_of(fewer, i)[0] >= i * 1000 / 37);
    CHECK(fit::point_of(fewer, i)[0] < (i + 1) * 1000 / 37);
  }
  CHECK(fit::count_of(cost::sample(points, 1000, 5)) == 1000);
  CHECK(fit::count_of(cost::sample(points, 5000, 5)) == 1000);
}

TEST_CASE("a row has the time of one test, and of one update, as soon as it is ready") {
  const AnyPointSet points = test::set_of<double, 3>(test::generated<double, 3>("cube", 50, 3));
  for (const int repeats : {1, 3}) {
    double now = 0;  // a microsecond passes at each reading: every batch is one run, and takes as long
    cost::CostRun run(
        points, {fit::find_algorithm("sphere", "ritter")},
        {.timing = {.repeats = repeats, .batch = 500}, .limits = {.longest = 1e12, .longest_watched = 1e12}},
        [&now] { return now += 1000; });
    const auto check = [&] {
      const cost::CostRow& row = run.rows().at(0);
      CHECK(row.time.median == 1000);
      CHECK(row.overlap.median == 1000.0 / row.overlap_pairs);
      CHECK(row.scene_overlap.median == 1000.0 / row.overlap_pairs);
      CHECK(row.updated.median == 1000.0 / 64);
    };
    while (run.rows().empty()) run.step();
    check();
    finish(run);
    check();
    CHECK(run.rows()[0].overlap.repeats == repeats);
  }
}

TEST_CASE("a second in which the machine is slow falls on all algorithms alike") {
  // Each is as fast as the other. In a third of the rounds the machine takes twice as long.
  const fit::Algorithm one = test::slow_algorithm<100, 2>("one"), other = test::slow_algorithm<100, 2>("other");
  const AnyPointSet points = test::set_of<double, 3>(test::generated<double, 3>("cube", 300, 3));
  bool slow = false;
  const cost::Clock slowed = [&slow, real = 0.0, last = test::false_now()]() mutable {
    const double passed = test::false_now() - std::exchange(last, test::false_now());
    return real += slow ? 2 * passed : passed;
  };
  cost::CostRun run(points, {&one, &other},
                    {.timing = {.repeats = 9, .batch = 0}, .limits = {.longest = 1e12, .longest_watched = 1e12}},
                    slowed);
  while (!run.done()) {
    const int round = run.revision() - 2;  // both rows are ready
    slow = round >= 4 && round < 7;
    run.step();
  }
  const cost::Timing &a = run.rows().at(0).time, &b = run.rows().at(1).time;
  CHECK(a.median == doctest::Approx(30'000));
  CHECK(b.median == doctest::Approx(30'000));
  CHECK(a.spread.value() > 0);  // it shows in both
  CHECK(b.spread.value() > 0);
}

TEST_CASE("rows whose times and sizes cannot be told apart are tied on the front") {
  const auto row = [](double time, double spread, double measure) {
    cost::CostRow made{.points = 5, .of = 5, .measure = measure};
    made.time = {.median = time, .min = time, .spread = spread, .repeats = 9, .batch = 1, .trusted = true};
    return made;
  };
  std::vector<cost::CostRow> rows{row(100, 0.1, 5), row(108, 0.02, 5), row(300, 0.01, 4), row(102, 0.01, 6)};
  cost::mark_front(rows);
  CHECK(rows[0].on_front);
  CHECK(rows[1].on_front);
  CHECK(cost::is_tied(rows, rows[0]));
  CHECK(cost::is_tied(rows, rows[1]));
  CHECK(rows[2].on_front);
  CHECK_FALSE(cost::is_tied(rows, rows[2]));
  CHECK_FALSE(rows[3].on_front);  // larger, and not surely faster
}

TEST_CASE("the front of a table is marked") {
  const auto row = [](double time, double measure) {
    cost::CostRow made{.points = 5, .of = 5, .measure = measure};
    made.time.median = time;
    return made;
  };
  std::vector<cost::CostRow> rows{row(1, 5), row(2, 6), row(3, 4)};
  cost::mark_front(rows);
  CHECK(rows[0].on_front);
  CHECK_FALSE(rows[1].on_front);
  CHECK(rows[2].on_front);
}
