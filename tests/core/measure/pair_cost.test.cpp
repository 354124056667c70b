// Every pair of kinds is timed once, in the order of the table.
#include "measure/pair_cost.hpp"

#include <doctest/doctest.h>

#include "geometry/volume.hpp"
#include "query/overlap/overlaps.hpp"

using namespace snug;

TEST_CASE("each of the 28 pairs gets a row, and about half of the bodies are apart") {
  for (const int dim : {2, 3}) {
    double now = 0;
    const auto clock = [&now] { return now += 1000; };  // a microsecond at each reading
    cost::PairCostRun run(dim, 1, {.repeats = 3, .batch = 500}, clock);
    CHECK_FALSE(run.done());
    while (!run.done()) run.step();
    const auto& rows = run.rows();
    REQUIRE(rows.size() == cost::PairCostRun::kPairs);
    std::size_t at = 0;
    for (std::size_t a = 0; a < kVolumeNames.size(); ++a)
      for (std::size_t b = a; b < kVolumeNames.size(); ++b, ++at) {
        CHECK(rows[at].a == a);
        CHECK(rows[at].b == b);
        CHECK(rows[at].time.median > 0);
        CHECK(rows[at].gjk.median > 0);
        if (query::kPairTests[a][b] == query::PairTest::kGjk) CHECK(rows[at].gjk.median == rows[at].time.median);
        CHECK(rows[at].apart > 0.1);
        CHECK(rows[at].apart < 0.95);
        CHECK(rows[at].scene.median > 0);
      }
    // The hulls are the bodies themselves: nothing around them can be apart more often.
    for (const auto& row : rows) CHECK(row.apart <= rows.back().apart);
    run.step();  // after the end, nothing
    CHECK(run.rows().size() == rows.size());
  }
}
