// Overlap tests of lozenges beside FCL's RSS in one run. Prints the table that RESULTS.md keeps. Needs Debian's
// libfcl-dev.
#include <cstdio>
#include <vector>

#include "bench/peers/fcl_rss.hpp"
#include "bench/ratio.hpp"
#include "core/query/volume_pairs.hpp"
#include "query/overlap/overlaps.hpp"

using namespace snug;

namespace {

using Lozenge3 = Lozenge<double, 3>;
constexpr int kPairs = 20'000;

/// Pairs whose centres are up to so far apart; flat: turned about one axis only, so that edges are parallel.
std::vector<Lozenge3> lozenges(double spread, bool parallel) {
  test::VolumeMaker<double, 3> make(1);
  std::vector<Lozenge3> result;
  for (int i = 0; i < 2 * kPairs; ++i) {
    Lozenge3 lozenge = std::get<Lozenge3>(make.make(4, test::Make::kSolid));
    lozenge.origin = make.any(spread);
    if (parallel)
      lozenge.edges = {Vector<double, 3>(lozenge.edges[0].norm(), 0, 0),
                       Vector<double, 3>(0, lozenge.edges[1].norm(), 0)};
    result.push_back(lozenge);
  }
  return result;
}

int overlapping_pairs(const std::vector<Lozenge3>& volumes) {
  int count = 0;
  for (std::size_t i = 0; i + 1 < volumes.size(); i += 2) count += query::overlaps(volumes[i], volumes[i + 1]) ? 1 : 0;
  return count;
}

void beside_fcl(const char* name, double spread, bool parallel) {
  const std::vector<Lozenge3> volumes = lozenges(spread, parallel);
  const bench::FclRss theirs(volumes);
  int ours_count = 0, their_count = 0;
  const auto r = bench::ratio([&] { ours_count = overlapping_pairs(volumes); },
                              [&] { their_count = theirs.overlapping_pairs(); }, 41);
  std::printf("| %s | %d | %d | %.2f | %.2f to %.2f | %.0f |\n", name, ours_count, their_count, r.median, r.low, r.high,
              1e9 * r.base / kPairs);
}

}  // namespace

int main() {
  std::puts("| lozenges | ours overlapping | FCL's | our time / its | quartiles | its time, ns a pair |");
  std::puts("|---|---:|---:|---:|---|---:|");
  beside_fcl("far apart", 8, false);
  beside_fcl("near", 2, false);
  beside_fcl("close", 1, false);
  beside_fcl("close, edges parallel", 1, true);
}
