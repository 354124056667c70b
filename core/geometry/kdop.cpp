#include "geometry/kdop.hpp"

namespace snug {
namespace {

using InPlane = std::array<int, 2>;
using InSpace = std::array<int, 3>;

constexpr std::array<InPlane, 4> kPlane{InPlane{1, 0}, {0, 1}, {1, 1}, {1, -1}};
constexpr std::array<InSpace, 13> kSpace{InSpace{1, 0, 0}, {0, 1, 0},  {0, 0, 1}, {1, 1, 1},  {1, 1, -1},
                                         {1, -1, 1},       {-1, 1, 1}, {1, 1, 0}, {1, -1, 0}, {1, 0, 1},
                                         {1, 0, -1},       {0, 1, 1},  {0, 1, -1}};
constexpr std::array<InSpace, 9> kWithoutCorners{InSpace{1, 0, 0}, {0, 1, 0},  {0, 0, 1}, {1, 1, 0}, {1, -1, 0},
                                                 {1, 0, 1},        {1, 0, -1}, {0, 1, 1}, {0, 1, -1}};

}  // namespace

template <>
std::span<const InPlane> kdop_axes<2>(int k) noexcept {
  if (k != 4 && k != 6 && k != 8) return {};
  return std::span(kPlane).first(k / 2);
}

template <>
std::span<const InSpace> kdop_axes<3>(int k) noexcept {
  if (k == 18) return kWithoutCorners;
  if (k != 6 && k != 14 && k != 26) return {};
  return std::span(kSpace).first(k / 2);
}

}  // namespace snug
