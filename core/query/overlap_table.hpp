// Which test decides each pair of volumes. query/overlaps.hpp dispatches by this table.
// A kind of volume that is not named here is tested by GJK.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "query/support_function.hpp"

namespace snug::query {

/// Ways to test a pair.
enum class PairTest : std::uint8_t {
  kSpheres,         // the distance between the centres, decided exactly
  kSphereBox,       // the distance of the centre from the box; exact for an AABB
  kSweptSpheres,    // the distance between points, segments and rectangles
  kSlabs,           // intervals along the coordinate axes, decided exactly
  kSlabsThenGjk,    // intervals along the axes that both share; if all overlap, GJK
  kSeparatingAxes,  // the fifteen axes of two boxes (in 2-D four)
  kGjk,             // the test of every pair that has none of its own
};

inline constexpr std::array<std::string_view, 7> kPairTestNames{
    "spheres", "sphere_box", "swept_spheres", "slabs", "slabs_then_gjk", "separating_axes", "gjk"};

namespace pair_table {

/// Two kinds, in the order of kVolumeNames, and their own test.
struct OwnTest {
  std::string_view a, b;
  PairTest test;
};
inline constexpr std::array kOwnTests{
    OwnTest{"sphere", "sphere", PairTest::kSpheres},
    OwnTest{"sphere", "aabb", PairTest::kSphereBox},
    OwnTest{"sphere", "obb", PairTest::kSphereBox},
    OwnTest{"sphere", "capsule", PairTest::kSweptSpheres},
    OwnTest{"sphere", "lozenge", PairTest::kSweptSpheres},
    OwnTest{"capsule", "capsule", PairTest::kSweptSpheres},
    OwnTest{"capsule", "lozenge", PairTest::kSweptSpheres},
    OwnTest{"lozenge", "lozenge", PairTest::kSweptSpheres},
    OwnTest{"aabb", "aabb", PairTest::kSlabs},
    OwnTest{"aabb", "kdop", PairTest::kSlabsThenGjk},
    OwnTest{"kdop", "kdop", PairTest::kSlabsThenGjk},
    OwnTest{"aabb", "obb", PairTest::kSeparatingAxes},
    OwnTest{"obb", "obb", PairTest::kSeparatingAxes},
};

constexpr std::size_t place_of(std::string_view volume) {
  std::size_t place = 0;
  while (kVolumeNames[place] != volume) ++place;  // an unknown name does not compile
  return place;
}

using Tests = std::array<std::array<PairTest, kVolumeNames.size()>, kVolumeNames.size()>;
constexpr Tests all_tests() {
  Tests tests{};
  for (auto& row : tests)
    for (PairTest& test : row) test = PairTest::kGjk;
  for (const auto& [a, b, test] : kOwnTests) tests[place_of(a)][place_of(b)] = tests[place_of(b)][place_of(a)] = test;
  return tests;
}

}  // namespace pair_table

inline constexpr pair_table::Tests kPairTests = pair_table::all_tests();

/// Whether such a test finds the distance; the others only find an axis.
[[nodiscard]] constexpr bool has_distance(PairTest test) {
  return test == PairTest::kSpheres || test == PairTest::kSphereBox || test == PairTest::kSweptSpheres ||
         test == PairTest::kGjk;
}

template <class A, class B>
inline constexpr PairTest kPairTest = kPairTests[VolumeKind<A>::kIndex][VolumeKind<B>::kIndex];

}  // namespace snug::query
