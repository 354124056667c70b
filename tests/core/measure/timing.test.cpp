// Times by clocks that are known: median, spread, batches, and what is not to be trusted.
#include "measure/timing.hpp"

#include <doctest/doctest.h>

#include "core/measure/false_clock.hpp"

using namespace snug;

TEST_CASE("a batch that something else held up is not taken for long enough") {
  int runs = 0;
  cost::Stopwatch watch([&] { test::pass(++runs == 2 ? 5000 : 10); }, {.repeats = 3, .batch = 1000});
  for (int steps = 0; !watch.done(); ++steps) {
    watch.step(test::false_clock());
    REQUIRE(steps < 100);
  }
  CHECK(watch.timing().batch == 110);  // 100 fill it, and a tenth more surely does
  CHECK(watch.timing().median == doctest::Approx(10).epsilon(0.2));
}

TEST_CASE("median, least and spread are those of the times, whatever their order") {
  const cost::Timing odd = cost::timing_of({5, 1, 3, 2, 4}, 8);
  CHECK(odd.median == 3);
  CHECK(odd.min == 1);
  CHECK(odd.spread.value() == doctest::Approx(2.0 / 3));  // quartiles 2 and 4
  CHECK(odd.repeats == 5);
  CHECK(odd.batch == 8);
  CHECK(cost::timing_of({1, 2, 3, 4}, 1).median == 2.5);
}

TEST_CASE("one batch has no spread, and is not trusted") {
  const cost::Timing one = cost::timing_of({7}, 1);
  CHECK(one.median == 7);
  CHECK_FALSE(one.spread);
  CHECK_FALSE(one.trusted);
  CHECK(cost::timing_of({7, 7}, 1).spread == std::optional(0.0));
  CHECK(cost::timing_of({7, 7}, 1).trusted);
}

TEST_CASE("a spread over a third is not trusted, nor a median far above the shortest time") {
  CHECK(cost::timing_of({84, 99, 100, 101, 102}, 1).trusted);
  CHECK_FALSE(cost::timing_of({83, 99, 100, 101, 102}, 1).trusted);  // all rounds but one were delayed alike
  CHECK(cost::timing_of({90, 95, 100, 105, 110}, 1).trusted);
  CHECK(cost::timing_of({84, 84, 100, 116, 117}, 1).trusted);        // 32 %
  CHECK_FALSE(cost::timing_of({82, 83, 100, 117, 118}, 1).trusted);  // 34 %
  CHECK_FALSE(cost::timing_of({0, 0, 0}, 1).trusted);                // too short for the clock
}

TEST_CASE("the clock's step is seen, and a clock that stands still has none") {
  double now = 0;
  int readings = 0;
  CHECK(cost::resolution_of([&] { return ++readings % 5 == 0 ? now += 100 : now; }) == 100);
  CHECK(cost::resolution_of([] { return 3.0; }) == 0);
  CHECK(cost::batch_length(100, 1e6, 2e7) == 1e6);  // a fine clock: the least
  CHECK(cost::batch_length(1e5, 1e6, 2e7) == 1e7);  // a browser's
  CHECK(cost::batch_length(1e6, 1e6, 2e7) == 2e7);  // a coarse one: no more than may be
}

TEST_CASE("a batch is as long as the clock needs, and each run's time comes out") {
  int runs = 0;
  const cost::Timing timing =
      cost::time_of(test::false_clock(), [&] { ++runs, test::pass(300); }, {.repeats = 4, .batch = 10'000});
  CHECK(timing.batch ==
        37);  // 34 fill it, and a tenth more surely does: not twice the time, which would keep a frame waiting
  CHECK(timing.median == doctest::Approx(300));
  CHECK(timing.spread.value() == doctest::Approx(0).epsilon(1e-9));
  CHECK(timing.repeats == 4);
  CHECK(runs == 1 + 2 + 4 + 8 + 16 + 32 + 37 + 4 * 37);
}

TEST_CASE("three repeats are enough where they took long") {
  const auto run = [] { test::pass(1e9); };
  CHECK(cost::time_of(test::false_clock(), run, {.repeats = 9, .batch = 1e6, .enough = 2e9}).repeats == 3);
  CHECK(cost::time_of(test::false_clock(), run, {.repeats = 9, .batch = 1e6}).repeats == 9);
  CHECK(cost::time_of(test::false_clock(), run, {.repeats = 2, .batch = 1e6, .enough = 2e9}).repeats == 2);
}

TEST_CASE("of two times the shorter is told, or that noise hides which it is") {
  const auto time = [](double median, std::optional<double> spread) {
    return cost::Timing{.median = median, .min = median, .spread = spread, .repeats = 9, .batch = 1};
  };
  CHECK(cost::faster(time(100, 0.01), time(106, 0.01), 0.05) == cost::Faster::kFirst);
  CHECK(cost::faster(time(106, 0.01), time(100, 0.01), 0.05) == cost::Faster::kSecond);
  CHECK(cost::faster(time(100, 0.01), time(105, 0.01), 0.05) == cost::Faster::kTie);
  CHECK(cost::faster(time(100, 0.3), time(120, 0.01), 0.05) == cost::Faster::kTie);  // the spread of one is wide
  CHECK(cost::faster(time(100, {}), time(190, {}), 0.05) == cost::Faster::kTie);     // one batch each
  CHECK(cost::faster(cost::Timing{.median = 7}, cost::Timing{.median = 8}, 0.05) == cost::Faster::kFirst);  // counted
}

TEST_CASE("in rounds each run has its turn; what disagrees is measured again, three times as often at most") {
  std::string order;
  int i = 0;
  cost::Rounds rounds({.repeats = 3, .batch = 0}, test::false_clock());
  rounds.add([&] { order += 'a', test::pass(10); });
  while (!rounds.start_last()) {
  }
  rounds.add([&] { order += 'b', test::pass(++i % 2 == 0 ? 10 : 30); });
  while (!rounds.start_last()) {
  }
  order.clear();
  for (int steps = 0; !rounds.done(); ++steps) {
    rounds.step();
    REQUIRE(steps < 100);
  }
  CHECK(order == "abab" + std::string(6, 'b'));
  CHECK(rounds.timing(0).repeats == 3);
  CHECK(rounds.timing(1).repeats == 9);
  CHECK(rounds.timing(0, 5).median == 2);
}

TEST_CASE("times that jump are said to be doubtful") {
  int i = 0;
  const auto run = [&] { test::pass(i++ % 2 == 0 ? 1e6 : 2e6); };
  const cost::Timing timing = cost::time_of(test::false_clock(), run, {.repeats = 9, .batch = 1});
  CHECK(timing.spread.value() > cost::kMostSpread);
  CHECK_FALSE(timing.trusted);
}
