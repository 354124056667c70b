// `snug cost` beside a plain loop over the same fitter: what the table tells, in units of what this room's benchmarks
// time. Prints the table that RESULTS.md keeps.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "bench/mesh.hpp"
#include "bench/ratio.hpp"
#include "fit/obb/obb_aabb.hpp"
#include "fit/obb/obb_dito.hpp"
#include "fit/obb/obb_exact.hpp"
#include "fit/obb/obb_face_aligned.hpp"
#include "fit/obb/obb_pca.hpp"
#include "fit/obb/obb_pca_hull.hpp"
#include "fit/obb/obb_pca_hull_area.hpp"
#include "fit/obb/obb_pca_rectangle.hpp"
#include "geometry/generate.hpp"
#include "measure/cost_run.hpp"

using namespace snug;

namespace {

using Set = PointSet<double, 3>;

constexpr int kRounds = 9;

double nanoseconds() {
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// What `snug cost` says of one fit, seconds.
double told(const AnyPointSet& points, const fit::Algorithm& algorithm) {
  cost::CostRun run(points, {&algorithm}, {}, nanoseconds);
  while (run.rows().empty()) run.step();
  return 1e-9 * run.rows()[0].time.median;
}

/// A plain loop of at least a millisecond, the median of nine.
template <class Fit>
double looped(Fit&& fitter) {
  const double once = bench::seconds(fitter);
  const int runs = 1 + static_cast<int>(1e-3 / once);
  std::vector<double> times;
  for (int i = 0; i < 9; ++i)
    times.push_back(bench::seconds([&] {
                      for (int k = 0; k < runs; ++k) fitter();
                    }) /
                    runs);
  std::nth_element(times.begin(), times.begin() + 4, times.end());
  return times[4];
}

template <class Fit>
void row(const char* name, const AnyPointSet& points, const fit::Algorithm& algorithm, Fit&& once) {
  std::vector<double> ratios, times;
  for (int i = 0; i < kRounds; ++i) {
    const double before = looped(once);
    const double ours = told(points, algorithm);
    times.push_back((before + looped(once)) / 2);
    ratios.push_back(ours / times.back());
  }
  std::sort(ratios.begin(), ratios.end());
  std::sort(times.begin(), times.end());
  std::printf("| %s | %s %s | %.3f | %.2f | %.2f to %.2f |\n", name, algorithm.volume.data(), algorithm.name.data(),
              1e3 * times[kRounds / 2], ratios[kRounds / 2], ratios[kRounds / 4], ratios[3 * kRounds / 4]);
  std::fflush(stdout);
}

/// As bench_spheres takes their time.
void spheres(const char* name, const AnyPointSet& points) {
  for (const char* algorithm : {"aabb_center", "ritter", "pca", "welzl", "pivot"}) {
    const fit::Algorithm& row_of = *fit::find_algorithm("sphere", algorithm);
    row(name, points, row_of, [&] { bench::keep(row_of.fit(points, {})); });
  }
}

/// As bench_obb takes theirs.
template <class Fit>
void box(const char* name, const AnyPointSet& points, const char* algorithm, Fit&& fitter) {
  const auto span = std::get<Set>(points).span();
  row(name, points, *fit::find_algorithm("obb", algorithm), [&] { bench::keep(fitter(span)); });
}

void boxes(const char* name, const AnyPointSet& points) {
  box(name, points, "aabb", [](auto p) { return fit::obb_aabb(p); });
  box(name, points, "pca", [](auto p) { return fit::obb_pca(p); });
  box(name, points, "dito", [](auto p) { return fit::obb_dito(p); });
}

void dear_boxes(const char* name, const AnyPointSet& points) {
  box(name, points, "pca_hull", [](auto p) { return fit::obb_pca_hull(p); });
  box(name, points, "pca_hull_area", [](auto p) { return fit::obb_pca_hull_area(p); });
  box(name, points, "pca_rectangle", [](auto p) { return fit::obb_pca_rectangle(p); });
  box(name, points, "face_aligned", [](auto p) { return fit::obb_face_aligned(p); });
  box(name, points, "exact", [](auto p) { return fit::obb_exact(p); });
}

}  // namespace

int main() {
  const AnyPointSet mesh = bench::mesh("bunny"), cube = *Set::make(*generate("cube", 1'000'000, 3, 1));
  std::puts("| points | algorithm | a plain loop, ms | snug cost / loop | quartiles |\n|---|---|---:|---:|---|");
  spheres("bunny", mesh);
  boxes("bunny", mesh);
  dear_boxes("bunny", mesh);
  spheres("a million", cube);
  boxes("a million", cube);
}
