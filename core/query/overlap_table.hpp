// Which test decides each pair of volumes. query/overlaps.hpp dispatches by this table, so that it says what is done.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "geometry/volume.hpp"

namespace snug::query {

/// Ways to test a pair.
enum class PairTest : std::uint8_t {
  kMissing,
  kSpheres,         // the distance of the centres, decided exactly
  kSphereBox,       // the distance of the centre from the box; of an AABB decided exactly
  kSweptSpheres,    // the distance of points, segments and rectangles
  kSlabs,           // intervals along the coordinate axes, decided exactly
  kSlabsThenGjk,    // intervals along the axes that both share; where all overlap, GJK
  kSeparatingAxes,  // the fifteen axes of two boxes (in 2-D four)
  kGjk,
};

inline constexpr std::array<std::string_view, 8> kPairTestNames{
    "missing", "spheres", "sphere_box", "swept_spheres", "slabs", "slabs_then_gjk", "separating_axes", "gjk"};

namespace pair_table {
using enum PairTest;
inline constexpr std::array<std::array<PairTest, 7>, 7> kTests{{
    //  sphere         aabb             obb              capsule        lozenge        kdop           hull
    {kSpheres, kSphereBox, kSphereBox, kSweptSpheres, kSweptSpheres, kGjk, kGjk},  // sphere
    {kSphereBox, kSlabs, kSeparatingAxes, kGjk, kGjk, kSlabsThenGjk, kGjk},        // aabb
    {kSphereBox, kSeparatingAxes, kSeparatingAxes, kGjk, kGjk, kGjk, kGjk},        // obb
    {kSweptSpheres, kGjk, kGjk, kSweptSpheres, kSweptSpheres, kGjk, kGjk},         // capsule
    {kSweptSpheres, kGjk, kGjk, kSweptSpheres, kSweptSpheres, kGjk, kGjk},         // lozenge
    {kGjk, kSlabsThenGjk, kGjk, kGjk, kGjk, kSlabsThenGjk, kGjk},                  // kdop
    {kGjk, kGjk, kGjk, kGjk, kGjk, kGjk, kGjk},                                    // hull
}};
}  // namespace pair_table

inline constexpr const std::array<std::array<PairTest, 7>, 7>& kPairTests = pair_table::kTests;

/// Whether such a test finds the distance; the others only find an axis.
[[nodiscard]] constexpr bool has_distance(PairTest test) {
  return test == PairTest::kSpheres || test == PairTest::kSphereBox || test == PairTest::kSweptSpheres ||
         test == PairTest::kGjk;
}

/// A volume's scalar, dimension and place in Volume and kVolumeNames.
template <class Kind>
struct VolumeKind;
template <template <class, int> class Kind, class ScalarType, int dim>
struct VolumeKind<Kind<ScalarType, dim>> {
  using Scalar = ScalarType;
  static constexpr int kDim = dim;
  static constexpr std::size_t kIndex = [] {
    const auto place = []<class... Kinds>(const std::variant<Kinds...>*) {
      std::size_t i = 0;
      (void)((std::is_same_v<Kinds, Kind<Scalar, kDim>> || (++i, false)) || ...);
      return i;
    };
    return place(static_cast<const Volume<Scalar, kDim>*>(nullptr));
  }();
};

template <class A, class B>
inline constexpr PairTest kPairTest = kPairTests[VolumeKind<A>::kIndex][VolumeKind<B>::kIndex];

namespace pair_table {

constexpr bool is_complete_and_symmetric() {
  for (std::size_t a = 0; a < kTests.size(); ++a)
    for (std::size_t b = 0; b < kTests.size(); ++b)
      if (kTests[a][b] == kMissing || kTests[a][b] != kTests[b][a]) return false;
  return true;
}

}  // namespace pair_table

static_assert(std::variant_size_v<Volume<double, 3>> == kPairTests.size() && kVolumeNames.size() == kPairTests.size());
static_assert(pair_table::is_complete_and_symmetric(), "a pair of volumes has no test, or another when turned around");

}  // namespace snug::query
