#include "number/exact_sum.hpp"

#include "number/bits.hpp"

namespace snug {
namespace {

struct Parts {
  std::uint64_t mantissa;  // 53 bits
  int exponent;            // the value is mantissa * 2^exponent
  bool negative;
};

Parts parts(double value) noexcept {
  const auto bits = bits_of(value);
  const auto field = static_cast<int>((bits >> 52) & 0x7ff);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const bool subnormal = field == 0;
  return {subnormal ? fraction : fraction | (std::uint64_t{1} << 52), (subnormal ? 1 : field) - 1075,
          (bits >> 63) != 0};
}

constexpr std::uint64_t kLow = 0xffffffffu;

}  // namespace

void ExactSum::add_shifted(std::uint64_t value, int position, bool negative) noexcept {
  const std::size_t digit = position / 32;
  const int shift = position % 32;
  const std::uint64_t low = (value & kLow) << shift;
  const std::uint64_t high = (value >> 32) << shift;
  const std::array<std::uint64_t, 3> pieces{low & kLow, (low >> 32) + (high & kLow), high >> 32};
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto piece = static_cast<std::int64_t>(pieces[i]);
    digits_[digit + i] += negative ? -piece : piece;
  }
}

void ExactSum::add_product(double a, double b) noexcept {
  const Parts x = parts(a);
  const Parts y = parts(b);
  const bool negative = x.negative != y.negative;
  const int position = x.exponent + y.exponent - kLowestExponent;
  const std::uint64_t x_low = x.mantissa & kLow;
  const std::uint64_t x_high = x.mantissa >> 32;
  const std::uint64_t y_low = y.mantissa & kLow;
  const std::uint64_t y_high = y.mantissa >> 32;
  add_shifted(x_low * y_low, position, negative);
  add_shifted(x_low * y_high, position + 32, negative);
  add_shifted(x_high * y_low, position + 32, negative);
  add_shifted(x_high * y_high, position + 64, negative);
}

int ExactSum::sign() const noexcept {
  // Carry upwards in the digits' own signs: after this, only the highest digit can be negative.
  std::int64_t carry = 0;
  bool any = false;
  for (const std::int64_t digit : digits_) {
    const std::int64_t sum = digit + carry;
    carry = sum >> 32;  // rounds down, so that the rest is in [0, 2^32)
    any = any || (sum & static_cast<std::int64_t>(kLow)) != 0;
  }
  if (carry < 0) return -1;
  return any || carry > 0 ? 1 : 0;
}

}  // namespace snug
