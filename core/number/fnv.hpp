// Hashes of traces and scenes: equal ones have equal hashes, natively and in WebAssembly.
#pragma once

#include <cstdint>
#include <string>

namespace snug {

/// FNV-1a over the bytes of what is added, the lowest first.
/// Source: G. Fowler, L. C. Noll, K.-P. Vo, the FNV hash, 1991.
class Fnv1a {
 public:
  void add_bits(std::uint64_t bits) {
    for (int byte = 0; byte < 8; ++byte, bits >>= 8) value_ = (value_ ^ (bits & 0xff)) * 0x100000001b3u;
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

/// Sixteen hexadecimal digits.
[[nodiscard]] inline std::string hex_of(std::uint64_t hash) {
  std::string digits;
  for (int shift = 60; shift >= 0; shift -= 4) digits += "0123456789abcdef"[hash >> shift & 0xf];
  return digits;
}

}  // namespace snug
