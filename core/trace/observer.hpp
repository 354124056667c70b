// How an algorithm is observed. This room depends on nothing.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace snug {

/// The kinds of operations that are counted. The observer counts, so that a run without one pays nothing.
enum class Operation : std::uint8_t {
  kPointsTouched,  // points read in a pass
  kDistanceTests,  // squared distances compared with a squared radius or with each other
  kComparisons,    // comparisons of coordinates or projections
  kDotProducts,    // projections onto an axis, entries of a covariance
  kSquareRoots,
  kBallSolves,        // balls computed through a set of support points
  kOrientationTests,  // tests on which side of a line or a plane a point lies
  kExactDecisions,    // comparisons that rounded arithmetic leaves open, decided without rounding
};
inline constexpr int kOperations = 8;

/// The counts of each Operation so far, in the order of the enumeration.
using OperationCounts = std::array<std::int64_t, kOperations>;

inline constexpr std::array<std::string_view, kOperations> kOperationNames{
    "points_touched", "distance_tests", "comparisons",       "dot_products",
    "square_roots",   "ball_solves",    "orientation_tests", "exact_decisions"};

/// Something that can be told an algorithm's steps and its operation counts.
template <class Observer, class Step>
concept StepObserver = requires(Observer& observer, Step step) {
  observer(std::move(step));
  observer.count(Operation::kPointsTouched, std::int64_t{1});
};

/// The default observer: it ignores everything, and the compiler removes it entirely.
struct Ignore {
  template <class Step>
  constexpr void operator()(const Step&) const noexcept {}
  constexpr void count(Operation, std::int64_t) const noexcept {}
};

/// Whether anyone sees the steps: `if constexpr (kWatched<Observer>)` guards steps that cost something to build.
template <class Observer>
inline constexpr bool kWatched = !std::is_same_v<std::remove_cvref_t<Observer>, Ignore>;

/// Counts operations, and of the steps only their number.
struct Counter {
  OperationCounts counts{};
  std::int64_t steps = 0;

  template <class Step>
  void operator()(const Step&) noexcept {
    ++steps;
  }
  void count(Operation operation, std::int64_t n) noexcept { counts[static_cast<std::size_t>(operation)] += n; }
};

/// Keeps every step with the counts as they stood when it happened.
template <class Step>
struct Recorder {
  struct Entry {
    Step step;
    OperationCounts counts;
  };
  std::vector<Entry> entries;
  OperationCounts counts{};

  void operator()(Step step) { entries.push_back({std::move(step), counts}); }
  void count(Operation operation, std::int64_t n) noexcept { counts[static_cast<std::size_t>(operation)] += n; }
};

}  // namespace snug
