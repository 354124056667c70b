// Bounding spheres of a million points, in passes: how often a plain farthest-point pass runs in the same time.
// Prints the tables that RESULTS.md keeps. Needs Debian's libcgal-dev.
#include <cmath>
#include <cstdio>
#include <string>

#include "bench/peers/cgal_ball.hpp"
#include "bench/ratio.hpp"
#include "fit/catalogue.hpp"
#include "fit/sphere/ritter.hpp"
#include "geometry/generate.hpp"

using namespace snug;

namespace {

constexpr int kPoints = 1'000'000;
using Set = PointSet<double, 3>;

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

/// Ritter's loop as a book prints it, without an observer, to hold the observed one against.
__attribute__((noinline)) Sphere<double, 3> plain_growing_pass(PointSpan<double, 3> points, Sphere<double, 3> ball) {
  for (const auto& p : points) {
    const Vector<double, 3> d = p - ball.center;
    const double square = d.squaredNorm();
    if (square > ball.radius * ball.radius) {
      const double distance = std::sqrt(square);
      const double radius = (ball.radius + distance) / 2;
      ball.center += d * ((radius - ball.radius) / distance);
      ball.radius = radius;
    }
  }
  return ball;
}

__attribute__((noinline)) Sphere<double, 3> observed_growing_pass(PointSpan<double, 3> points, Sphere<double, 3> ball) {
  Ignore ignore;
  for (Index i = 0; i < points.size(); ++i) fit::grow_to_hold(ball, points[i], i, 2, ignore);
  return ball;
}

struct Limit {
  const char* algorithm;
  double passes;
};
constexpr Limit kLimits[] = {{"aabb_center", 3}, {"ritter", 5}, {"pca", 8}, {"pivot", 16}};

void one_cloud(const char* kind) {
  const Set set = *Set::make(*generate(kind, kPoints, 3, 1));
  const AnyPointSet any = set;
  const Vector<double, 3> from(0.01, 0.02, 0.03);
  const auto base = [&] { bench::keep(farthest_pass(set.span(), from)); };
  for (const Limit& limit : kLimits) {
    const fit::Algorithm& algorithm = *fit::find_algorithm("sphere", limit.algorithm);
    const auto r = bench::ratio([&] { bench::keep(fit::ball_of(algorithm.fit(any, {})).radius); }, base, 15);
    std::printf("| %s | %s | %.2f | %.2f to %.2f | %g | %s |\n", kind, limit.algorithm, r.median, r.low, r.high,
                limit.passes, r.median <= limit.passes ? "yes" : "NO");
  }
}

void beside_cgal(const char* name, const Set& set, int rounds) {
  const AnyPointSet any = set;
  const fit::Algorithm& pivot = *fit::find_algorithm("sphere", "pivot");
  double ours = 0, theirs = 0;
  const auto r = bench::ratio([&] { ours = fit::ball_of(pivot.fit(any, {})).radius; },
                              [&] { theirs = bench::cgal_ball_radius(set.span()); }, rounds);
  std::printf("| %s | %d | %.2f | %.2f to %.2f | %.2f | %.0e | %s |\n", name, set.size(), r.median, r.low, r.high,
              1e3 * r.base, theirs / ours - 1, r.median <= 1 ? "yes" : "NO");
}

void observer() {
  const Set set = *Set::make(*generate("gaussian", kPoints, 3, 1));
  const Sphere<double, 3> start{Vector<double, 3>::Zero(), 0.1};
  const auto r = bench::ratio([&] { bench::keep(observed_growing_pass(set.span(), start).radius); },
                              [&] { bench::keep(plain_growing_pass(set.span(), start).radius); }, 41);
  std::printf("\nThe growing pass with the observer that ignores, against the loop without any: %.3f (%.3f to %.3f).\n",
              r.median, r.low, r.high);
}

}  // namespace

int main() {
  std::printf("| points | algorithm | passes | quartiles | at most | met |\n|---|---|---|---|---|---|\n");
  for (const char* kind : {"cube", "sphere", "gaussian"}) one_cloud(kind);
  std::printf("\n| points | n | pivot / CGAL | quartiles | CGAL, ms | CGAL's radius larger by | met "
              "|\n|---|---:|---:|---|---:|---:|---|\n");
  for (const char* kind : {"cube", "sphere", "gaussian"}) {
    beside_cgal(kind, *Set::make(*generate(kind, 1000, 3, 1)), 101);
    beside_cgal(kind, *Set::make(*generate(kind, kPoints, 3, 1)), 15);
  }
  observer();
}
