// The discrete-oriented polytope: k half-spaces, in k/2 slabs along fixed axes that all of the same k share.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <tuple>

#include "geometry/vector.hpp"

namespace snug {

/// The most slabs that there are: 13 of the 26-DOP, in 2-D 4 of the 8-DOP.
template <int Dim>
inline constexpr int kMostSlabs = Dim == 2 ? 4 : 13;

/// The k/2 axes of that k's slabs: the coordinate axes, then towards a box's corners, then towards its edges' midpoints
/// (18 leaves the corners out). Small integers and not unit, so that projections of points onto them are sums and
/// differences of coordinates. Empty where there is no such k.
/// Source: C. Ericson, Real-Time Collision Detection, 2005, 4.6.
template <int Dim>
[[nodiscard]] std::span<const std::array<int, Dim>> kdop_axes(int k) noexcept;

/// All p with min_i <= p . axis_i <= max_i for each of the k/2 axes.
template <class Scalar, int Dim>
struct Kdop {
  int k = 2 * Dim;                            // 2-D: 4, 6, 8; 3-D: 6, 14, 18, 26
  std::array<Scalar, kMostSlabs<Dim>> min{};  // the first k/2 count
  std::array<Scalar, kMostSlabs<Dim>> max{};  // >= min
  static constexpr std::array<std::string_view, 3> kFields{"k", "min", "max"};
  static auto tie(auto& own) { return std::tie(own.k, own.min, own.max); }
};

}  // namespace snug
