// A million boxes against a frustum: at once, against a plain summing pass over the same arrays and against
// one by one. Prints the tables that RESULTS.md keeps.
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

#include "bench/ratio.hpp"
#include "geometry/random.hpp"
#include "geometry/turn.hpp"
#include "query/cull/batch/classify_batch.hpp"
#include "query/cull/classify.hpp"
#include "query/cull/frustum_sat.hpp"

using namespace snug;

namespace {

constexpr std::size_t kCount = 1'000'000;
constexpr int kRounds = 41;

/// The unit of measure: every number of the arrays once, each lane of a line into a sum of its own, so that no sum
/// waits for the one before.
template <class Scalar>
double sum_of(const query::AabbArray<Scalar>& array) {
  constexpr std::size_t kBlock = query::AabbArray<Scalar>::kBlock;
  Scalar sums[kBlock]{};
  for (const auto& block : array.blocks())
    for (const auto& field : block.fields)
      for (std::size_t i = 0; i < kBlock; ++i) sums[i] += field[i];
  double sum = 0;
  for (const Scalar each : sums) sum += static_cast<double>(each);
  return sum;
}

template <class Scalar>
Frustum<Scalar, 3> some_frustum() {
  FrustumCamera<double, 3> camera{.position = {3, -4, 5}, .half_tangents = {0.8, 0.5}, .near = 0.5, .far = 80};
  camera.axes = turn(Vector<double, 3>(1, 2, -1), 0.7);
  FrustumCamera<Scalar, 3> own{camera.position.cast<Scalar>(), camera.axes.cast<Scalar>(),
                               camera.half_tangents.cast<Scalar>(), static_cast<Scalar>(camera.near),
                               static_cast<Scalar>(camera.far)};
  return *frustum_of_camera(own);
}

template <class Scalar>
std::vector<Aabb<Scalar, 3>> some_boxes(double spread) {
  Random random(1);
  std::vector<Aabb<Scalar, 3>> boxes(kCount);
  for (auto& box : boxes)
    for (int i = 0; i < 3; ++i) {
      const double center = random.between(-spread, spread), half = random.between(0.1, 1);
      box.min[i] = static_cast<Scalar>(center - half), box.max[i] = static_cast<Scalar>(center + half);
    }
  return boxes;
}

template <class Scalar>
void measure(const char* name, const std::vector<Aabb<Scalar, 3>>& boxes) {
  const query::AabbArray<Scalar> array(boxes);
  const auto frustum = some_frustum<Scalar>();
  std::vector<query::Culling> verdicts(kCount);
  const auto at_once = [&] {
    query::classify_all<Scalar>(frustum, array, verdicts);
    bench::keep(verdicts);
  };
  const auto one_by_one = [&] {
    for (std::size_t i = 0; i < kCount; ++i) verdicts[i] = query::classify(frustum, boxes[i]).verdict;
    bench::keep(verdicts);
  };
  const auto summing = [&] { bench::keep(sum_of(array)); };
  one_by_one();
  at_once();
  std::size_t counts[3]{};
  for (const auto verdict : verdicts) ++counts[static_cast<std::size_t>(verdict)];
  const auto to_sum = bench::ratio(at_once, summing, kRounds);
  const auto to_one = bench::ratio(one_by_one, at_once, kRounds / 4);
  const auto percent = [](std::size_t count) { return 100.0 * static_cast<double>(count) / kCount; };
  std::printf("| %s | %s | %.0f / %.0f / %.0f %% | %.2f ms | %.2f (%.2f to %.2f) | %.1f (%.1f to %.1f) |\n",
              sizeof(Scalar) == 4 ? "float" : "double", name, percent(counts[0]), percent(counts[1]),
              percent(counts[2]), to_sum.base * 1e3, to_sum.median, to_sum.low, to_sum.high, to_one.median, to_one.low,
              to_one.high);
}

template <class Scalar>
void measure_all() {
  for (const double spread : {100.0, 30.0})
    measure(spread > 50 ? "boxes, spread out" : "boxes, near", some_boxes<Scalar>(spread));
}

}  // namespace

int main() {
  std::printf("| scalar | a million | inside / intersecting / outside | summing pass | at once / summing pass | at "
              "once, times as fast as one by one |\n");
  std::printf("|---|---|---|---:|---|---|\n");
  measure_all<float>();
  measure_all<double>();
}
