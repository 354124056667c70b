// How often each axis of the separating-axis test separates random boxes, and what ending at the first gap saves.
#pragma once

#include <array>
#include <cstdint>

#include "query/overlap/sat_steps.hpp"

namespace snug::cost {

/// Rows are numbered as the test goes: A's faces, B's faces, then the edges of A times those of B.
struct AxisCounts {
  int pairs = 0, overlap = 0;
  std::array<int, query::kSatAxes<3>> first{};      // pairs at whose row the test ends
  std::array<int, query::kSatAxes<3>> separates{};  // pairs that the row separates, whatever came before it
  std::int64_t tests = 0;                           // axes tested, if each test ends at the first gap

  /// The pairs that no face's normal separates, but a cross product of edges does.
  template <int Dim>
  [[nodiscard]] int edges_alone() const {
    int count = 0;
    for (std::size_t row = 2 * Dim; row < query::kSatAxes<Dim>; ++row) count += first[row];
    return count;
  }
};

/// The counts over so many pairs of random_box.
template <int Dim>
[[nodiscard]] AxisCounts count_axes(int pairs, std::uint64_t seed);

}  // namespace snug::cost
