// What a part of a fitter spends, where its own steps are not for the watcher of the whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "number/exact_tally.hpp"
#include "trace/observer.hpp"

namespace snug {
namespace fit {

/// Counts alone: of a part of an algorithm whose own steps nobody is to see, nor is anything worked out for them.
struct Tally {
  OperationCounts counts{};

  template <class Step>
  constexpr void operator()(const Step&) const noexcept {}
  void count(Operation operation, std::int64_t n) noexcept { counts[static_cast<std::size_t>(operation)] += n; }
};

/// Counts what an algorithm tells of, and the exact decisions that it causes below.
struct FullCounter : Counter {
  template <class Step>
  void operator()(const Step& step) noexcept {
    take();
    Counter::operator()(step);
  }
  /// Up to now.
  void take() noexcept {
    counts[static_cast<std::size_t>(Operation::kExactDecisions)] += exact_decisions - taken_;
    pass();
  }
  /// What was decided since was not the algorithm's.
  void pass() noexcept { taken_ = exact_decisions; }

 private:
  std::int64_t taken_ = exact_decisions;
};

/// What counts such a part for an observer: nothing where that ignores.
template <class Observer>
using TallyFor = std::conditional_t<std::is_same_v<std::remove_cvref_t<Observer>, Ignore>, Ignore, Tally>;

/// Tells the observer what the part came to.
template <class Observer>
void hand_on(const Tally& tally, Observer& observe) {
  for (std::size_t i = 0; i < tally.counts.size(); ++i) observe.count(static_cast<Operation>(i), tally.counts[i]);
}
template <class Observer>
constexpr void hand_on(const Ignore&, Observer&) noexcept {}

}  // namespace fit

template <>
inline constexpr bool kWatched<fit::Tally> = false;

}  // namespace snug
