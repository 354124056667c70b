#include "trace/observer.hpp"

#include <doctest/doctest.h>

using namespace snug;

TEST_CASE("a recorder keeps each step with the counts as they stood") {
  Recorder<int> recorder;
  recorder.count(Operation::kDotProducts, 2);
  recorder(7);
  recorder.count(Operation::kDotProducts, 3);
  recorder(8);
  REQUIRE(recorder.entries.size() == 2);
  CHECK(recorder.entries[0].step == 7);
  CHECK(recorder.entries[0].counts[static_cast<std::size_t>(Operation::kDotProducts)] == 2);
  CHECK(recorder.entries[1].counts[static_cast<std::size_t>(Operation::kDotProducts)] == 5);
}

TEST_CASE("a counter counts steps and operations and keeps neither") {
  Counter counter;
  counter(1);
  counter(2);
  counter.count(Operation::kSquareRoots, 4);
  CHECK(counter.steps == 2);
  CHECK(counter.counts[static_cast<std::size_t>(Operation::kSquareRoots)] == 4);
  CHECK(kWatched<Counter>);
  CHECK_FALSE(kWatched<Ignore>);
}
