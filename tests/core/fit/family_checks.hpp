// What is promised of every fitter on every member of a family (core/fit/families.hpp), counted rather than asserted:
// `./run test --long` prints the counts, core/fit/families.test.cpp asserts them of a sample.
#pragma once

#include <cstdint>
#include <vector>

#include "core/fit/families.hpp"
#include "fit/catalogue.hpp"

namespace snug::test {

/// Of one fitter on one family, in one scalar, in 2-D and 3-D.
struct FitterTally {
  std::int64_t sets = 0;
  double excess = 0;           // the worst of what claims to be smallest: its lengths over the proven bound's, in ulps
  std::int64_t steps = 0;      // the most
  double of_stated_steps = 0;  // the most, in parts of stated_steps
  // Zero is promised of what follows.
  std::int64_t outside = 0;       // sets with a point outside, exactly
  std::int64_t not_finite = 0;    // volumes with a number that is not finite
  std::int64_t off_boundary = 0;  // sets with a support point off the boundary
  std::int64_t unproven = 0;      // smallest volumes that the certificate does not call so
  std::int64_t unlike = 0;        // scaled by a power of two: not the same volume scaled, bit by bit
  std::int64_t moved = 0;         // permuted, turned by right angles or moved: a promise above broken, or another size
  std::int64_t other_scalar = 0;  // smallest volumes whose size in double is another, beyond float's rounding

  [[nodiscard]] std::int64_t broken() const {
    return outside + not_finite + off_boundary + unproven + unlike + moved + other_scalar;
  }
  void add(const FitterTally& other);
};

/// Of the tests of two volumes fitted round members of one family, in one scalar.
struct PairTally {
  std::int64_t pairs = 0, overlapping = 0;
  int turns = 0;  // the most simplices that GJK tried on one of them
  // Zero is promised of what follows.
  std::int64_t unordered = 0;  // another answer when the volumes change places
  std::int64_t missed = 0;     // called apart, though they share a point
  std::int64_t unlike = 0;     // scaled by a power of two: another answer
  std::int64_t turned = 0;     // turned by right angles: another verdict, though farther apart than kTouching

  [[nodiscard]] std::int64_t broken() const { return unordered + missed + unlike + turned; }
  void add(const PairTally& other);
};

/// Of one family in one scalar.
struct FamilyTally {
  std::int64_t sets = 0, hard = 0;
  std::uint64_t hash = 0xcbf29ce484222325u;  // over every volume and its support
  std::vector<FitterTally> fitters;          // in the order of fit::algorithms()
  PairTally pairs;

  /// Adds the tally of other members. The order does not matter, not even to the hash.
  void add(const FamilyTally& other);
};

/// The number of steps within which an algorithm ends on n points, whatever they are.
[[nodiscard]] double stated_steps(const fit::Algorithm& algorithm, int n, int dim);

/// The number of simplices that GJK tries at most, whatever the two volumes.
inline constexpr int kStatedTurns = 64;

/// The excess, in ulps, that a smallest volume may have. A sphere's proof is exact. That of a box is known within
/// tolerance::kBoxProof, 64 roundings or 32 ulps of double on either side of its bound, whichever scalar it is in.
template <class Scalar>
[[nodiscard]] double stated_excess(const fit::Algorithm& algorithm);

/// Adds a family's member to the tally. thorough: transformed as well.
template <class Scalar, int Dim>
void add_member(FamilyTally& tally, std::size_t family, std::uint64_t seed, bool thorough);

}  // namespace snug::test
