#include "measure/axis_counts.hpp"

#include "measure/random_boxes.hpp"
#include "query/overlap/obb_sat.hpp"

namespace snug::cost {
namespace {

template <int Dim>
std::size_t row_of(const query::SatAxis<double, Dim>& axis) {
  if (axis.kind == query::AxisKind::kFaceA) return axis.i;
  return axis.kind == query::AxisKind::kFaceB ? Dim + axis.j : 2 * Dim + Dim * axis.i + axis.j;
}

}  // namespace

template <int Dim>
AxisCounts count_axes(int pairs, std::uint64_t seed) {
  AxisCounts counts{.pairs = pairs};
  Random random(seed);
  for (int i = 0; i < pairs; ++i) {
    const auto a = random_box<double, Dim>(random), b = random_box<double, Dim>(random);
    const auto result = query::obb_sat(a, b);
    counts.tests += result.tests;
    if (result.overlap) ++counts.overlap;
    else ++counts.first[row_of<Dim>(result.axis)];
    query::SatRecorder<double, Dim> all;
    static_cast<void>(query::obb_sat(a, b, query::SatExtent::kAll, all));
    for (const auto& entry : all.entries)
      if (const auto* axis = std::get_if<query::AxisTested<double, Dim>>(&entry.step.fact);
          axis != nullptr && axis->separates)
        ++counts.separates[row_of<Dim>(axis->axis)];
  }
  return counts;
}

template AxisCounts count_axes<2>(int, std::uint64_t);
template AxisCounts count_axes<3>(int, std::uint64_t);

}  // namespace snug::cost
