#include "geometry/kdop.hpp"

namespace snug {
namespace {

using Plane = std::array<int, 2>;
using Space = std::array<int, 3>;

constexpr std::array<Plane, 4> kPlane{Plane{1, 0}, {0, 1}, {1, 1}, {1, -1}};
constexpr std::array<Space, 13> kSpace{Space{1, 0, 0}, {0, 1, 0},  {0, 0, 1}, {1, 1, 1},  {1, 1, -1},
                                       {1, -1, 1},     {-1, 1, 1}, {1, 1, 0}, {1, -1, 0}, {1, 0, 1},
                                       {1, 0, -1},     {0, 1, 1},  {0, 1, -1}};
constexpr std::array<Space, 9> kWithoutCorners{Space{1, 0, 0}, {0, 1, 0},  {0, 0, 1}, {1, 1, 0}, {1, -1, 0},
                                               {1, 0, 1},      {1, 0, -1}, {0, 1, 1}, {0, 1, -1}};

}  // namespace

template <>
std::span<const Plane> kdop_axes<2>(int k) noexcept {
  if (k != 4 && k != 6 && k != 8) return {};
  return std::span(kPlane).first(k / 2);
}

template <>
std::span<const Space> kdop_axes<3>(int k) noexcept {
  if (k == 18) return kWithoutCorners;
  if (k != 6 && k != 14 && k != 26) return {};
  return std::span(kSpace).first(k / 2);
}

}  // namespace snug
