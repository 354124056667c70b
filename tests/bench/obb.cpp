// Boxes: the smallest beside CGAL's, a linear one in plain passes over a million points, and what each is worth.
// Prints the tables that RESULTS.md keeps. Needs Debian's libcgal-dev.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "bench/mesh.hpp"
#include "bench/peers/cgal_obb.hpp"
#include "bench/ratio.hpp"
#include "fit/obb/obb_aabb.hpp"
#include "fit/obb/obb_dito.hpp"
#include "fit/obb/obb_exact.hpp"
#include "fit/obb/obb_face_aligned.hpp"
#include "fit/obb/obb_pca.hpp"
#include "fit/obb/obb_pca_hull.hpp"
#include "fit/obb/obb_pca_hull_area.hpp"
#include "fit/obb/obb_pca_rectangle.hpp"
#include "fit/obb/obb_rotations.hpp"
#include "fit/obb/obb_sphere_axis.hpp"
#include "geometry/generate.hpp"

using namespace snug;

namespace {

using Set = PointSet<double, 3>;

Set cloud(const char* kind, int n) { return *Set::make(*generate(kind, n, 3, 1)); }

/// CGAL's search is random: the worst of its boxes is what one may get.
void beside_cgal(const char* name, const Set& set, int rounds) {
  double ours = 0, best = 0, worst = 0;
  const auto r = bench::ratio([&] { ours = measure(fit::obb_exact(set.span()).volume); },
                              [&] {
                                const double theirs = bench::cgal_obb_volume(set.span());
                                best = best > 0 ? std::min(best, theirs) : theirs;
                                worst = std::max(worst, theirs);
                              },
                              rounds);
  const auto hull = fit::quickhull(set.span()).volume.vertices.size();
  std::printf("| %s | %d | %zu | %.3f | %.3f to %.3f | %.0f | %.1e to %.1e | %s |\n", name, set.size(), hull, r.median,
              r.low, r.high, 1e3 * r.base, best / ours - 1, worst / ours - 1, r.median <= 1 ? "yes" : "NO");
  std::fflush(stdout);
}

/// The unit of measure: what anyone would write.
__attribute__((noinline)) Index farthest_pass(PointSpan<double, 3> points, const Vector<double, 3>& from) {
  double most = -1;
  Index farthest = 0;
  for (Index i = 0; i < points.size(); ++i) {
    const double square = (points[i] - from).squaredNorm();
    if (square > most) {
      most = square;
      farthest = i;
    }
  }
  return farthest;
}

void in_passes(const char* kind) {
  const Set set = cloud(kind, 1'000'000);
  const Vector<double, 3> from(0.01, 0.02, 0.03);
  const auto base = [&] { bench::keep(farthest_pass(set.span(), from)); };
  const auto one = [&](const char* name, auto fitter, double most) {
    const auto r = bench::ratio([&] { bench::keep(fitter(set.span()).volume.center); }, base, 15);
    std::printf("| %s | %s | %.2f | %.2f to %.2f | %g | %s |\n", kind, name, r.median, r.low, r.high, most,
                r.median <= most ? "yes" : "NO");
    std::fflush(stdout);
  };
  one(
      "dito", [](auto points) { return fit::obb_dito(points); }, 6);
  one(
      "aabb", [](auto points) { return fit::obb_aabb(points); }, 3);
  one(
      "pca", [](auto points) { return fit::obb_pca(points); }, 6);
}

/// Volume in units of the smallest, and milliseconds, of every fitter.
void worth(const char* name, const Set& set) {
  const double smallest = measure(fit::obb_exact(set.span()).volume);
  const auto one = [&](const char* fitter_name, auto fitter) {
    double volume = 0;
    std::vector<double> times;
    for (int i = 0; i < 9; ++i) times.push_back(bench::seconds([&] { volume = measure(fitter(set.span()).volume); }));
    std::sort(times.begin(), times.end());
    std::printf("| %s | %s | %.4f | %.3f |\n", name, fitter_name, volume / smallest, 1e3 * times[times.size() / 2]);
  };
  one("aabb", [](auto p) { return fit::obb_aabb(p); });
  one("sphere_axis", [](auto p) { return fit::obb_sphere_axis(p); });
  one("pca", [](auto p) { return fit::obb_pca(p); });
  one("pca_hull", [](auto p) { return fit::obb_pca_hull(p); });
  one("pca_hull_area", [](auto p) { return fit::obb_pca_hull_area(p); });
  one("dito", [](auto p) { return fit::obb_dito(p); });
  one("pca_rectangle", [](auto p) { return fit::obb_pca_rectangle(p); });
  one("face_aligned", [](auto p) { return fit::obb_face_aligned(p); });
  one("rotations", [](auto p) { return fit::obb_rotations(p); });
  one("exact", [](auto p) { return fit::obb_exact(p); });
}

}  // namespace

int main() {
  const Set bunny = bench::mesh("bunny"), dragon = bench::mesh("dragon");
  std::puts("| points | n | hull | exact / CGAL | quartiles | CGAL, ms | CGAL's volume too large by | met |");
  std::puts("|---|---:|---:|---:|---|---:|---|---|");
  beside_cgal("bunny", bunny, 9);
  beside_cgal("dragon", dragon, 9);
  beside_cgal("teapot", bench::mesh("teapot"), 9);
  beside_cgal("sphere", cloud("sphere", 1000), 5);
  beside_cgal("sphere", cloud("sphere", 10'000), 3);
  std::puts("\n| points | algorithm | passes | quartiles | at most | met |\n|---|---|---|---|---|---|");
  for (const char* kind : {"cube", "sphere", "gaussian"}) in_passes(kind);
  std::puts("\n| points | algorithm | volume / smallest | ms |\n|---|---|---:|---:|");
  worth("bunny", bunny);
  worth("dragon", dragon);
}
