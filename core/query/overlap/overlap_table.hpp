// Which test decides each pair of volumes. query/overlap/overlaps.hpp dispatches by this table.
// A kind of volume that is not named here is tested by GJK.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "query/distance/support_function.hpp"

namespace snug::query {

/// Ways to test a pair.
enum class PairTest : std::uint8_t {
  kSpheres,         // the distance between the centres, decided exactly
  kSphereBox,       // the distance of the centre from the box; exact for an AABB
  kSweptSpheres,    // the distance between points, segments and rectangles
  kSlabs,           // intervals along the axes that both share: exact for AABBs, conservative for k-DOPs
  kSlabsThenGjk,    // the same, then GJK where all overlap: exact, and no pair's own test
  kSeparatingAxes,  // the fifteen axes of two boxes (in 2-D four)
  kGjk,             // the test of every pair that has none of its own
};

inline constexpr std::array<std::string_view, 7> kPairTestNames{
    "spheres", "sphere_box", "swept_spheres", "slabs", "slabs_then_gjk", "separating_axes", "gjk"};
[[nodiscard]] constexpr std::string_view name_of(PairTest test) {
  return kPairTestNames[static_cast<std::size_t>(test)];
}

/// The source of each test.
inline constexpr std::array<std::string_view, 7> kPairTestSources{
    "C. Ericson, Real-Time Collision Detection, 2005",
    "J. Arvo, A simple method for box-sphere intersection testing, 1990",
    "E. Larsen, S. Gottschalk, M. Lin, D. Manocha, Fast proximity queries with swept sphere volumes, 1999",
    "J. Klosowski, M. Held, J. Mitchell, H. Sowizral, K. Zikan, Efficient collision detection using bounding volume "
    "hierarchies of k-DOPs, 1998",
    "J. Klosowski, M. Held, J. Mitchell, H. Sowizral, K. Zikan, Efficient collision detection using bounding volume "
    "hierarchies of k-DOPs, 1998",
    "S. Gottschalk, M. C. Lin, D. Manocha, OBBTree, 1996",
    "E. Gilbert, D. Johnson, S. Keerthi, A fast procedure for computing the distance between complex objects in "
    "three-dimensional space, 1988"};
[[nodiscard]] constexpr std::string_view source_of(PairTest test) {
  return kPairTestSources[static_cast<std::size_t>(test)];
}

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
    OwnTest{"aabb", "kdop", PairTest::kSlabs},
    OwnTest{"kdop", "kdop", PairTest::kSlabs},
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

/// Whether two kinds' own test may call volumes overlapping that are apart, because its axes are not all that could
/// separate them.
[[nodiscard]] constexpr bool is_conservative(std::size_t a, std::size_t b) {
  constexpr std::size_t kKdop = pair_table::place_of("kdop");
  return kPairTests[a][b] == PairTest::kSlabs && (a == kKdop || b == kKdop);
}

template <class A, class B>
inline constexpr PairTest kPairTest = kPairTests[VolumeKind<A>::kIndex][VolumeKind<B>::kIndex];

/// Whether the test takes b first. Kinds are ordered as in the table, and volumes of one kind by their anchors, so that
/// a pair has the same answer in either order. (Two of a kind with the same anchor overlap in either order.)
template <class A, class B>
[[nodiscard]] bool swapped(const A& a, const B& b) {
  if constexpr (!std::is_same_v<A, B>) return VolumeKind<A>::kIndex > VolumeKind<B>::kIndex;
  const auto p = anchor(a);
  const auto q = anchor(b);
  return std::lexicographical_compare(q.data(), q.data() + q.size(), p.data(), p.data() + p.size());
}

}  // namespace snug::query
