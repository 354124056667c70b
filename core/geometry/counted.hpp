// A number that counts the operations on it, so that arithmetic that is a template over its numbers tells what it
// costs.
#pragma once

#include <compare>

#include "geometry/vector.hpp"

namespace snug {

struct Work {
  int additions = 0, multiplications = 0;
  [[nodiscard]] int all() const { return additions + multiplications; }
};

/// What this thread has counted since work_of last began.
inline constinit thread_local Work counted_work;

/// A double whose sums and differences count as additions, and its products as multiplications. A sign costs nothing.
struct Counted {
  double value = 0;

  Counted() = default;
  Counted(double of) : value(of) {}  // NOLINT: constants cost nothing

  friend Counted operator-(Counted a) { return -a.value; }
  friend Counted operator+(Counted a, Counted b) {
    ++counted_work.additions;
    return a.value + b.value;
  }
  friend Counted operator-(Counted a, Counted b) {
    ++counted_work.additions;
    return a.value - b.value;
  }
  friend Counted operator*(Counted a, Counted b) {
    ++counted_work.multiplications;
    return a.value * b.value;
  }
  Counted& operator+=(Counted b) { return *this = *this + b; }
  Counted& operator-=(Counted b) { return *this = *this - b; }
  Counted& operator*=(Counted b) { return *this = *this * b; }
  friend auto operator<=>(Counted a, Counted b) = default;
};

/// What a call of f takes.
[[nodiscard]] Work work_of(auto&& f) {
  counted_work = {};
  static_cast<void>(f());
  return counted_work;
}

}  // namespace snug

template <>
struct Eigen::NumTraits<snug::Counted> : Eigen::NumTraits<double> {
  using Real = snug::Counted;
  using NonInteger = snug::Counted;
  using Nested = snug::Counted;
  using Literal = snug::Counted;
};
