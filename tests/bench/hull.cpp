// Convex hulls beside Qhull's and Bullet's, in one run: how long ours takes in units of their time, and how many
// vertices each keeps. Prints the table that RESULTS.md keeps. Needs Debian's libqhull-dev and libbullet-dev.
#include <cstdio>
#include <string>
#include <vector>

#include "bench/mesh.hpp"
#include "bench/peers/bullet_hull.hpp"
#include "bench/peers/qhull.hpp"
#include "bench/ratio.hpp"
#include "fit/hull/quickhull.hpp"
#include "geometry/generate.hpp"

using namespace snug;

namespace {

using Set = PointSet<double, 3>;

void one_set(const std::string& name, const Set& set, int rounds) {
  std::size_t ours = 0;
  const auto work = [&] { ours = fit::quickhull(set.span()).volume.vertices.size(); };
  for (const char* options : {"", "Qt"}) {
    int theirs = 0;
    const auto r = bench::ratio(
        work, [&] { theirs = bench::qhull_vertices(set.span(), options); }, rounds);
    std::printf("| %s | %d | qhull %s | %d | %zu | %.2f | %.2f to %.2f | %.0f |\n", name.c_str(), set.size(), options,
                theirs, ours, r.median, r.low, r.high, 1e3 * r.base);
    std::fflush(stdout);
  }
  int theirs = 0;
  const auto r = bench::ratio(
      work, [&] { theirs = bench::bullet_vertices(set.span()); }, rounds);
  std::printf("| %s | %d | bullet | %d | %zu | %.2f | %.2f to %.2f | %.0f |\n", name.c_str(), set.size(), theirs, ours,
              r.median, r.low, r.high, 1e3 * r.base);
  std::fflush(stdout);
}

Set generated(const char* kind, int n) { return *Set::make(*generate(kind, n, 3, 1)); }

}  // namespace

int main() {
  std::puts("| points | n | peer | its vertices | ours | our time / its | quartiles | its time, ms |");
  std::puts("|---|---:|---|---:|---:|---:|---|---:|");
  one_set("on a sphere", generated("sphere", 1000), 25);
  one_set("on a sphere", generated("sphere", 100'000), 7);
  one_set("in a ball", generated("ball", 100'000), 9);
  one_set("in a cube", generated("cube", 1'000'000), 7);
  one_set("gaussian", generated("gaussian", 1'000'000), 7);
  one_set("bunny", bench::mesh("bunny"), 25);
  one_set("dragon", bench::mesh("dragon"), 9);
}
