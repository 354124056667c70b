// Measures what the overlap test of each pair of volume kinds costs, on the same bodies for all pairs.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "measure/timing.hpp"

namespace snug::cost {

/// The test of one pair of kinds. a, b: indices of kVolumeNames, a <= b.
struct PairCost {
  std::size_t a = 0, b = 0;
  double apart = 0;  // the share of the bodies that are apart, as these volumes say
  Timing time;       // ns, of one test: the pair's own, and
  Timing gjk;        // GJK on the same bodies; the same where the pair has no other test
};

/// Times query::test_overlap for all 28 pairs, and GJK beside it, piece by piece: pairs of random bodies, each of a few
/// points, with a volume of every kind around each.
class PairCostRun {
 public:
  PairCostRun(int dim, std::uint64_t seed, const TimingOptions& timing, Clock clock);
  PairCostRun(const PairCostRun&) = delete;  // the timed functions refer to it
  PairCostRun& operator=(const PairCostRun&) = delete;

  /// Does one batch.
  void step();
  [[nodiscard]] bool done() const { return rows_.size() == kPairs; }
  [[nodiscard]] const std::vector<PairCost>& rows() const { return rows_; }
  static constexpr std::size_t kPairs = 28;

 private:
  TimingOptions timing_;
  Clock clock_;
  [[nodiscard]] Timing of_one_test() const;

  /// All bodies, in these kinds, by GJK or by the pair's own test; returns how many are apart.
  std::function<int(std::size_t a, std::size_t b, bool by_gjk)> test_;
  std::size_t a_ = 0, b_ = 0;  // the pair at hand
  PairCost row_;               // what is known of it
  bool by_gjk_ = false;        // which of its tests is timed
  std::unique_ptr<Stopwatch> watch_;
  std::vector<PairCost> rows_;
};

}  // namespace snug::cost
