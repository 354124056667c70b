// A fuzzer's bytes as numbers that geometry finds hard: equal ones, neighbours, opposites, whole numbers, all scales.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "geometry/vector.hpp"

namespace snug::fuzz {

/// libFuzzer keeps what aborts.
inline void require(bool condition) {
  if (!condition) std::abort();
}

class Bytes {
 public:
  Bytes(const unsigned char* data, std::size_t size) : at_(data), end_(data + size) {}

  /// 0 once the bytes have run out.
  unsigned byte() { return at_ == end_ ? 0u : *at_++; }
  /// From 0 to n - 1; n from 1 to 256.
  unsigned below(unsigned n) { return byte() % n; }

  /// 0, or of a size from 2^-40 to 2^40.
  template <class Scalar>
  Scalar number() {
    auto next = static_cast<Scalar>(last_);
    switch (below(8)) {
      case 0: next = static_cast<Scalar>(static_cast<int>(below(9)) - 4); break;
      case 1: next = static_cast<Scalar>(static_cast<int>(byte()) - 128) / 16; break;
      case 2: next = -next; break;
      case 3: next *= static_cast<Scalar>(std::ldexp(1.0, static_cast<int>(below(41)) - 20)); break;
      case 4: next = std::nextafter(next, Scalar(8)); break;
      case 5: next = std::nextafter(next, Scalar(-8)); break;
      case 6: next = static_cast<Scalar>(fraction()); break;
      default: break;  // the last one again
    }
    const Scalar size = std::abs(next);
    if (size != 0 && !(size >= static_cast<Scalar>(0x1p-40) && size <= static_cast<Scalar>(0x1p40))) next = 1;
    last_ = static_cast<double>(next);
    return next;
  }

  template <class Scalar, int Dim>
  Vector<Scalar, Dim> point() {
    Vector<Scalar, Dim> p;
    for (int i = 0; i < Dim; ++i) p[i] = number<Scalar>();
    return p;
  }

  /// Of 1 to most points.
  template <class Scalar, int Dim>
  std::vector<Vector<Scalar, Dim>> cloud(unsigned most) {
    std::vector<Vector<Scalar, Dim>> points(1 + below(most));
    for (auto& p : points) p = point<Scalar, Dim>();
    return points;
  }

 private:
  /// From -1 to 1, of four bytes.
  double fraction() {
    std::uint32_t bits = 0;
    for (int i = 0; i < 4; ++i) bits = bits << 8 | byte();
    return static_cast<double>(bits) / 0x1p31 - 1;
  }

  const unsigned char* at_;
  const unsigned char* end_;
  double last_ = 1;
};

}  // namespace snug::fuzz
