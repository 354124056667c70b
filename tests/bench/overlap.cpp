// Overlap tests: lozenges beside FCL's RSS in one run, and what each pair of volumes costs in units of the cheapest.
// Prints the tables that RESULTS.md keeps. Needs Debian's libfcl-dev.
#include <cstdio>
#include <vector>

#include "bench/peers/fcl_rss.hpp"
#include "bench/ratio.hpp"
#include "core/query/volume_pairs.hpp"
#include "query/overlaps.hpp"

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

/// Pairs of two kinds, about half of which overlap.
struct Pairs {
  std::vector<Volume<double, 3>> a, b;
};

Pairs pairs_of(std::size_t i, std::size_t j, int count) {
  test::VolumeMaker<double, 3> make(2);
  Pairs pairs;
  for (int k = 0; k < count; ++k) {
    pairs.a.push_back(make.make(i, test::Make::kSolid));
    pairs.b.push_back(test::moved<double, 3>(make.make(j, test::Make::kSolid), make.direction() * 1.5));
  }
  return pairs;
}

int overlapping(const Pairs& pairs) {
  int count = 0;
  for (std::size_t k = 0; k < pairs.a.size(); ++k) count += query::overlaps<double, 3>(pairs.a[k], pairs.b[k]) ? 1 : 0;
  return count;
}

void every_pair() {
  constexpr int kCount = 500;
  const Pairs base = pairs_of(0, 0, kCount);
  for (std::size_t i = 0; i < kVolumeNames.size(); ++i)
    for (std::size_t j = i; j < kVolumeNames.size(); ++j) {
      const Pairs pairs = pairs_of(i, j, kCount);
      const auto r = bench::ratio([&] { bench::keep(overlapping(pairs)); },
                                  [&] {
                                    for (int k = 0; k < 10; ++k) bench::keep(overlapping(base));
                                  },
                                  15);
      std::printf("| %s | %s | %s | %.0f | %.1f |\n", kVolumeNames[i].data(), kVolumeNames[j].data(),
                  query::kPairTestNames[static_cast<std::size_t>(query::kPairTests[i][j])].data(),
                  100.0 * overlapping(pairs) / kCount, 10 * r.median);
    }
}

}  // namespace

int main() {
  std::puts("| lozenges | ours overlapping | FCL's | our time / its | quartiles | its time, ns a pair |");
  std::puts("|---|---:|---:|---:|---|---:|");
  beside_fcl("far apart", 8, false);
  beside_fcl("near", 2, false);
  beside_fcl("close", 1, false);
  beside_fcl("close, edges parallel", 1, true);
  std::puts("\n| first | second | test | overlapping, % | spheres' times |\n|---|---|---|---:|---:|");
  every_pair();
}
