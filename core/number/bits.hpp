// A double's bits and back. (std::bit_cast is missing from the C++ library of Emscripten 3.1.6; both compilers have the
// builtin that it is made of.)
#pragma once

#include <cstdint>

namespace snug {

constexpr std::uint64_t bits_of(double value) { return __builtin_bit_cast(std::uint64_t, value); }
constexpr double double_of(std::uint64_t bits) { return __builtin_bit_cast(double, bits); }
constexpr float float_of(std::uint32_t bits) { return __builtin_bit_cast(float, bits); }

}  // namespace snug
