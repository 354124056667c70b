#include "query/axis_counts.hpp"

#include "query/obb_sat.hpp"
#include "query/random_boxes.hpp"

namespace snug::query {
namespace {

template <int Dim>
std::size_t row_of(const SatAxis<double, Dim>& axis) {
  if (axis.kind == AxisKind::kFaceA) return axis.i;
  return axis.kind == AxisKind::kFaceB ? Dim + axis.j : 2 * Dim + Dim * axis.i + axis.j;
}

}  // namespace

template <int Dim>
AxisCounts count_axes(int pairs, std::uint64_t seed) {
  AxisCounts counts{.pairs = pairs};
  Random random(seed);
  for (int i = 0; i < pairs; ++i) {
    const auto a = random_box<double, Dim>(random), b = random_box<double, Dim>(random);
    const auto result = obb_sat(a, b);
    counts.tests += result.tests;
    if (result.overlap) ++counts.overlap;
    else ++counts.first[row_of<Dim>(result.axis)];
    SatRecorder<double, Dim> all;
    static_cast<void>(obb_sat(a, b, SatExtent::kAll, all));
    for (const auto& entry : all.entries)
      if (const auto* axis = std::get_if<AxisTested<double, Dim>>(&entry.step.fact); axis != nullptr && axis->separates)
        ++counts.separates[row_of<Dim>(axis->axis)];
  }
  return counts;
}

template AxisCounts count_axes<2>(int, std::uint64_t);
template AxisCounts count_axes<3>(int, std::uint64_t);

}  // namespace snug::query
