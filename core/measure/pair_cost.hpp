// Measures what the overlap test of each pair of volume kinds costs, on the same bodies for all pairs.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "measure/timing.hpp"

namespace snug::cost {

/// The test of one pair of kinds. a, b: indices of kVolumeNames, a <= b. Times in ns, of one verdict.
struct PairCost {
  std::size_t a = 0, b = 0;
  double apart = 0;  // the share of the near bodies that are apart, as these volumes say
  Timing time;       // of the pair's own test, on bodies that are near: about half of them overlap
  Timing scene;      // the same, on bodies as they lie in a scene: most are apart
  Timing gjk;        // of GJK on the near bodies; the same where the pair has no other test
};

/// Times query::overlaps for all 28 pairs, and GJK beside it, piece by piece: pairs of random bodies, each of a few
/// points, with a volume of every kind around each. Each kind of pair in a loop that is compiled for it; a batch of
/// each in every round (Rounds).
class PairCostRun {
 public:
  PairCostRun(int dim, std::uint64_t seed, const TimingOptions& timing, Clock clock);
  PairCostRun(const PairCostRun&) = delete;  // the timed functions refer to it
  PairCostRun& operator=(const PairCostRun&) = delete;

  /// Does one batch.
  void step();
  [[nodiscard]] bool done() const { return rows_.size() == kPairs && rounds_.done(); }
  [[nodiscard]] const std::vector<PairCost>& rows() const { return rows_; }
  static constexpr std::size_t kPairs = 28;

 private:
  /// Tests every pair of bodies once, and returns how many are apart.
  using Work = std::function<int()>;
  struct Works {
    Work near, scene, gjk;
  };

  /// Times a test of the pair at hand for the first time, and goes on to the next one once that is done.
  void start();
  void take_times();

  std::function<Works(std::size_t a, std::size_t b)> works_of_;
  std::size_t a_ = 0, b_ = 0;  // the pair at hand,
  Works works_;                // its tests,
  int piece_ = 0;              // which of them is timed,
  bool started_ = false;       // and whether it was begun
  std::vector<PairCost> rows_;
  Rounds rounds_;
  /// What is timed in each of the rounds.
  struct Timed {
    std::size_t row;
    Timing PairCost::*timing;
  };
  std::vector<Timed> timed_;
};

}  // namespace snug::cost
