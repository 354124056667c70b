// Counts the operations of a part of a fitter whose own steps the observer of the whole must not see.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "number/exact_tally.hpp"
#include "trace/observer.hpp"

namespace snug {
namespace fit {

/// Counts only. The part's steps are hidden, and nothing is computed for them.
struct PartCounter {
  OperationCounts counts{};

  template <class Step>
  constexpr void operator()(const Step&) const noexcept {}
  void count(Operation operation, std::int64_t n) noexcept { counts[static_cast<std::size_t>(operation)] += n; }
};

/// Counts the operations that an algorithm reports, and the exact decisions that it causes in the predicates.
struct FullCounter : Counter {
  template <class Step>
  void operator()(const Step& step) noexcept {
    take();
    Counter::operator()(step);
  }
  /// Adds the exact decisions since the last take or pass.
  void take() noexcept {
    counts[static_cast<std::size_t>(Operation::kExactDecisions)] += exact_decisions - taken_;
    pass();
  }
  /// Leaves out the exact decisions since then, which were not the algorithm's.
  void pass() noexcept { taken_ = exact_decisions; }

 private:
  std::int64_t taken_ = exact_decisions;
};

/// The counter of such a part for an observer; Ignore, if the observer ignores.
template <class Observer>
using PartCounterFor = std::conditional_t<std::is_same_v<std::remove_cvref_t<Observer>, Ignore>, Ignore, PartCounter>;

/// Reports the part's counts to the observer.
template <class Observer>
void hand_on(const PartCounter& tally, Observer& observe) {
  for (std::size_t i = 0; i < tally.counts.size(); ++i) observe.count(static_cast<Operation>(i), tally.counts[i]);
}
template <class Observer>
constexpr void hand_on(const Ignore&, Observer&) noexcept {}

}  // namespace fit

template <>
inline constexpr bool kWatched<fit::PartCounter> = false;

}  // namespace snug
