// Times as ratios within one run: machines are noisy, and a ratio of neighbours in time says more than a duration.
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace snug::bench {

/// Keeps a result from being optimised away.
template <class Value>
void keep(const Value& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

/// Keeps a loop that counts from being turned into one that does several items at once.
inline void one_by_one(int& count) { asm volatile("" : "+r"(count)); }

template <class Work>
double seconds(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Ratio {
  double median = 0;
  double low = 0;  // quartiles
  double high = 0;
  double base = 0;  // seconds of one base run, median
};

/// work against base, run in turn, rounds times.
template <class Work, class Base>
Ratio ratio(Work&& work, Base&& base, int rounds) {
  std::vector<double> ratios, bases;
  for (int i = 0; i < rounds; ++i) {
    const double b = (seconds(base) + seconds(base)) / 2;
    bases.push_back(b);
    ratios.push_back(seconds(work) / b);
  }
  std::sort(ratios.begin(), ratios.end());
  std::sort(bases.begin(), bases.end());
  const auto at = [&](std::size_t quarter) { return ratios[(ratios.size() - 1) * quarter / 4]; };
  return {at(2), at(1), at(3), bases[bases.size() / 2]};
}

}  // namespace snug::bench
