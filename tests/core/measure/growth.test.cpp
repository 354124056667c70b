// Powers of n: those known in advance come out, runs that would take too long are not begun, pieces and whole agree.
#include "measure/growth.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "core/measure/false_clock.hpp"
#include "measure/cost_run.hpp"

using namespace snug;

namespace {

/// Takes a fixed time and coefficient * n^power.
cost::Workload work_that_takes(double fixed, double coefficient, double power, Index most) {
  cost::Workload load{.volume = "sphere",
                      .algorithm = "slow",
                      .most = most,
                      .theory = "O(n)",
                      .work = [](double n) { return n; },
                      .tight = true};
  load.prepare = [=](Index n) { return [=] { test::pass(fixed + coefficient * std::pow(n, power)); }; };
  return load;
}

std::vector<cost::GrowthRow> run_whole(std::vector<cost::Workload> loads, double longest = 1e9) {
  cost::GrowthRun run(std::move(loads), {.repeats = 3, .batch = 1e4}, longest, test::false_clock());
  while (!run.done()) run.step();
  return run.rows();
}

}  // namespace

TEST_CASE("the power that times follow comes out") {
  for (const double power : {0.7, 1.0, 1.7, 2.0, 3.0}) {
    CAPTURE(power);
    const auto rows = run_whole({work_that_takes(0, 20, power, 10'000)}, 1e15);
    CHECK(rows.size() == 7);  // by half decades
    CHECK(rows.back().exponent.value() == doctest::Approx(power).epsilon(1e-6));
    CHECK(rows.back().theory_exponent.value() == doctest::Approx(1));
  }
}

TEST_CASE("what does not grow is left behind: the power is that of the tail") {
  const auto rows = run_whole({work_that_takes(20'000, 20, 1, 1'000'000)});
  CHECK(rows.front().points == 10);
  CHECK(rows.back().points == 1'000'000);
  CHECK(rows.back().exponent.value() == doctest::Approx(1).epsilon(0.02));
  int fitted = 0;
  for (const auto& row : rows) fitted += row.in_fit ? 1 : 0;
  CHECK(fitted == 4);  // 31,623 and more
}

TEST_CASE("n log n has the slope that it has there") {
  auto load = work_that_takes(0, 1, 1, 1'000'000);
  load.work = [](double n) { return n * std::log(n); };
  const double slope = run_whole({load}).back().theory_exponent.value();
  CHECK(slope > 1.06);
  CHECK(slope < 1.10);
}

TEST_CASE("a run that would take longer than is allowed is not begun, and is said") {
  double longest = 0;
  auto load = work_that_takes(0, 1, 2, 1'000'000);
  load.prepare = [&longest](Index n) {
    return [&longest, n] { test::pass(double(n) * n), longest = std::max(longest, double(n) * n); };
  };
  const auto rows = run_whole({load}, 1.1e9);
  CHECK(rows.back().points == 31'623);
  CHECK(longest <= 1.001e9);
  CHECK(rows.back().stopped == "one run of 100000 points would take about 10 s");
  CHECK(rows.back().exponent.value() == doctest::Approx(2).epsilon(1e-3));
  CHECK(run_whole({work_that_takes(0, 1, 2, 1'000'000)}, 1.1e8).back().stopped ==
        "one run of 31623 points would take about 1 s");
  CHECK(run_whole({work_that_takes(0, 1, 2, 1'000'000)}, 1.1e7).back().stopped ==
        "one run of 10000 points would take about 100 ms");
}

TEST_CASE("sizes go by half decades, and few points have five") {
  CHECK(cost::growth_sizes(1'000'000) ==
        std::vector<Index>{10, 32, 100, 316, 1000, 3162, 10000, 31623, 100000, 316228, 1000000});
  CHECK(cost::growth_sizes(40) == std::vector<Index>{10, 14, 20, 28, 40});
  CHECK(cost::growth_sizes(1839).back() == 1839);
  CHECK(cost::growth_sizes(7) == std::vector<Index>{7});
  CHECK(cost::growth_sizes(1) == std::vector<Index>{1});
  CHECK(cost::growth_sizes(11).front() == 10);
}

TEST_CASE("a second in which the machine does other things does not bend the line") {
  for (const double from : {1e6, 3e6, 1e7}) {  // from when it is half as fast, ns
    CAPTURE(from);
    auto load = work_that_takes(0, 20, 1, 1'000'000);
    const double start = test::false_now();
    load.prepare = [=](Index n) {
      return [=] {
        const double since = test::false_now() - start;
        test::pass((since > from && since < 8 * from ? 40 : 20) * double(n));
      };
    };
    CHECK(run_whole({load}).back().exponent.value() == doctest::Approx(1).epsilon(1e-6));
  }
}

TEST_CASE("no power is told of too few points, nor where most of the time does not grow yet") {
  CHECK_FALSE(run_whole({work_that_takes(0, 20, 1, 30)}, 1e15).back().exponent);
  const auto flat = run_whole({work_that_takes(1e6, 20, 1, 300)}, 1e15);
  CHECK_FALSE(flat.back().exponent);
  CHECK_FALSE(flat.back().theory_exponent);
  CHECK(run_whole({work_that_takes(0, 20, 4, 40)}, 1e15).back().exponent.value() == doctest::Approx(4).epsilon(1e-6));
}

TEST_CASE("a power needs three times that are not 0") {
  CHECK_FALSE(cost::power_of(std::vector<cost::SizedTime>{{1, 1}, {2, 2}}));
  CHECK_FALSE(cost::power_of(std::vector<cost::SizedTime>{{1, 0}, {2, 2}, {3, 3}}));
  CHECK(cost::power_of(std::vector<cost::SizedTime>{{1, 3}, {2, 6}, {4, 12}}).value() == doctest::Approx(1));
}

TEST_CASE("in slices growth has the rows that it has in one go; stopped, those that were ready") {
  const auto loads = [] { return std::vector{work_that_takes(0, 5, 1, 1000), work_that_takes(0, 5, 2, 1000)}; };
  const auto whole = run_whole(loads());
  cost::GrowthRun sliced(loads(), {.repeats = 3, .batch = 1e4}, 1e9, test::false_clock());
  double progress = 0;
  for (int i = 0; !sliced.done(); ++i) {
    cost::advance(sliced, test::false_clock(), 1e4);
    CHECK(sliced.progress() >= progress);
    progress = sliced.progress();
    REQUIRE(i < 10'000);
  }
  CHECK(progress == 1);
  REQUIRE(sliced.rows().size() == whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    CHECK(sliced.rows()[i].points == whole[i].points);
    CHECK(sliced.rows()[i].time.median == doctest::Approx(whole[i].time.median));
    CHECK(sliced.rows()[i].exponent.value() == doctest::Approx(whole[i].exponent.value()));
  }

  cost::GrowthRun stopped(loads(), {.repeats = 3, .batch = 1e4}, 1e9, test::false_clock());
  while (stopped.rows().size() < 4) stopped.step();
  stopped.stop();
  CHECK(stopped.done());
  CHECK(stopped.rows().size() == 4);
  CHECK(stopped.rows().back().exponent.value() == doctest::Approx(1).epsilon(1e-6));
  CHECK(stopped.rows().back().stopped == "stopped");
}

TEST_CASE("a line ends where a limit of the algorithm's own would stop it, and says so") {
  auto stock = std::make_shared<cost::PointStock>("gaussian", 3, false, 1);
  const fit::Algorithm& recursive = *fit::find_algorithm("sphere", "welzl_recursive");
  const cost::Workload load = cost::workload_of(recursive, 3, 1500, stock, {});
  CHECK(load.most == recursive.most_finished);
  CHECK(load.ends.find("stopped by its own limit") != std::string::npos);
  CHECK(cost::workload_of(recursive, 3, 500, stock, {}).ends.empty());
  auto ends = work_that_takes(0, 5, 1, 1000);
  ends.ends = "here it ends";
  CHECK(run_whole({ends}).back().stopped == "here it ends");
}

TEST_CASE("every algorithm of the catalogue has its theory") {
  for (const fit::Algorithm& algorithm : fit::algorithms()) {
    INFO(algorithm.volume << " " << algorithm.name);
    const fit::Theory& theory = algorithm.theory;
    CHECK(fit::bound_of(theory, 3).starts_with("O("));
    CHECK_FALSE(theory.source.empty());
    REQUIRE((fit::work_of(theory, 2) != nullptr));
    CHECK(fit::work_of(theory, 2)(1000) >= 1000);
  }
}
