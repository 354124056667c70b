// Converts a double to its bits and back. (The C++ library of Emscripten 3.1.6 lacks std::bit_cast; both compilers have
// the builtin behind it.)
#pragma once

#include <cstdint>

namespace snug {

constexpr std::uint64_t bits_of(double value) { return __builtin_bit_cast(std::uint64_t, value); }
constexpr double double_of(std::uint64_t bits) { return __builtin_bit_cast(double, bits); }
constexpr float float_of(std::uint32_t bits) { return __builtin_bit_cast(float, bits); }

}  // namespace snug
