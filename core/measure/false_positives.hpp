// How often a volume says "may overlap" of two bodies that are apart: what a loose volume costs.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "fit/catalogue.hpp"

namespace snug::cost {

/// What a volume said of the same pairs of bodies that all others were asked about.
struct FalsePositives {
  int pairs = 0;           // of bodies
  int apart = 0;           // of those, the pairs whose convex hulls are apart
  int passed = 0;          // of those, the pairs whose volumes overlap
  std::int64_t tests = 0;  // the axes, the distances or the turns of GJK that all of its tests took
  /// The share of the pairs that are apart that the volume does not reject; 0 if none is apart.
  [[nodiscard]] double rate() const { return apart > 0 ? static_cast<double>(passed) / apart : 0; }
};

/// Places a copy of the body beside the body, over and over, and tests the volumes of both. The copy is rotated at
/// random, and so is the body itself, if bodies rotate; the copy's centre is spread evenly over all places within
/// kReach radii of the body. The result is the same everywhere for the same seed.
class FalsePositiveRun {
 public:
  /// algorithms: they must take these points. volumes: what each fitted to them. still: whether the body keeps its
  /// orientation.
  FalsePositiveRun(const AnyPointSet& points, const std::vector<const fit::Algorithm*>& algorithms,
                   const std::vector<fit::Volume3>& volumes, bool still, std::uint64_t seed);

  /// Tests one pair of bodies.
  void step();
  [[nodiscard]] bool done() const { return done_ == kPairs; }
  [[nodiscard]] double progress() const { return static_cast<double>(done_) / kPairs; }
  /// A row for each volume.
  [[nodiscard]] const std::vector<FalsePositives>& rows() const { return rows_; }

  static constexpr int kPairs = 400;
  /// Two bodies touch at two radii at most: these pairs are near each other, as a broad phase leaves them.
  static constexpr double kReach = 2.5;

 private:
  std::function<void(std::vector<FalsePositives>& rows)> test_pair_;
  std::vector<FalsePositives> rows_;
  int done_ = 0;
};

}  // namespace snug::cost
