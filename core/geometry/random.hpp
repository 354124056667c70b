// Random numbers that are the same everywhere for the same seed.
#pragma once

#include <cstdint>

namespace snug {

/// Source: D. Blackman, S. Vigna, "Scrambled linear pseudorandom number generators", 2021 (SplitMix64, the seeder).
class Random {
 public:
  explicit constexpr Random(std::uint64_t seed) : state_(seed) {}

  constexpr std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// Uniform in [0, 1), a multiple of 2^-53.
  constexpr double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  /// Uniform in [low, high).
  constexpr double between(double low, double high) { return low + (high - low) * unit(); }
  /// Uniform in 0 ... n - 1, n >= 1; the bias is below n / 2^32.
  constexpr std::uint32_t below(std::uint32_t n) {
    return static_cast<std::uint32_t>(((bits() >> 32) * std::uint64_t{n}) >> 32);
  }
  /// About normal with mean 0 and variance 1, within [-6, 6]: twelve uniforms summed, for log and cos differ
  /// between C libraries.
  constexpr double normal() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += unit();
    return sum;
  }

 private:
  std::uint64_t state_;
};

}  // namespace snug
