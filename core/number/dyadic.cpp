#include "number/dyadic.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>

namespace snug {
namespace {

using Digits = std::vector<std::uint32_t>;

/// The digit of weight 2^(32 place). begin: the place of the first digit.
std::uint64_t digit_at(const Digits& digits, int begin, int place) {
  const int i = place - begin;
  return i < 0 || i >= static_cast<int>(digits.size()) ? 0 : digits[i];
}

/// Divides by a number below 2^32, and returns the remainder.
std::uint32_t divide(Digits& digits, std::uint32_t by) {
  std::uint64_t rest = 0;
  for (std::size_t i = digits.size(); i-- > 0;) {
    rest = rest << 32 | digits[i];
    digits[i] = static_cast<std::uint32_t>(rest / by);
    rest %= by;
  }
  while (!digits.empty() && digits.back() == 0) digits.pop_back();
  return static_cast<std::uint32_t>(rest);
}

/// The decimal digits of a whole number above 0.
std::string decimal(Digits digits) {
  constexpr std::uint32_t kNineDigits = 1000000000;
  std::vector<std::uint32_t> groups;
  while (!digits.empty()) groups.push_back(divide(digits, kNineDigits));
  std::string text = std::to_string(groups.back());
  for (std::size_t i = groups.size() - 1; i-- > 0;) {
    std::array<char, 16> nine{};
    std::snprintf(nine.data(), nine.size(), "%09u", static_cast<unsigned>(groups[i]));
    text += nine.data();
  }
  return text;
}

}  // namespace

Dyadic::Dyadic(double value) {
  if (value == 0) return;
  negative_ = value < 0;
  int exponent = 0;
  const auto mantissa = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::abs(value), &exponent), 53));
  exponent -= 53;
  place_ = exponent >= 0 ? exponent / 32 : -((31 - exponent) / 32);
  const int shift = exponent - 32 * place_;
  const std::uint64_t low = mantissa << shift;
  const std::uint64_t high = shift == 0 ? 0 : mantissa >> (64 - shift);
  digits_ = {static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(low >> 32), static_cast<std::uint32_t>(high)};
  trim();
}

Dyadic::OddTimesPower Dyadic::odd_times_power() const {
  if (digits_.empty()) return {"0", 0};
  const int zeros = std::countr_zero(digits_.front());  // the first digit is not 0
  Digits odd = digits_;
  divide(odd, std::uint32_t{1} << zeros);
  return {(negative_ ? "-" : "") + decimal(std::move(odd)), 32 * place_ + zeros};
}

Dyadic::Leading Dyadic::leading() const noexcept {
  const int n = static_cast<int>(digits_.size());
  Leading leading;
  double weight = 1;
  for (int i = n - 1; i >= std::max(0, n - 4); --i, weight *= 0x1p-32)
    leading.mantissa += weight * static_cast<double>(digits_[i]);
  leading.exponent = 32 * (n - 1 + place_);
  if (negative_) leading.mantissa = -leading.mantissa;
  return leading;
}

double Dyadic::approximate() const noexcept {
  const Leading own = leading();
  return std::ldexp(own.mantissa, own.exponent);
}

double quotient(const Dyadic& a, const Dyadic& b) noexcept {
  const auto x = a.leading(), y = b.leading();
  return std::ldexp(x.mantissa / y.mantissa, x.exponent - y.exponent);
}

void Dyadic::trim() {
  while (!digits_.empty() && digits_.back() == 0) digits_.pop_back();
  const auto first = std::find_if(digits_.begin(), digits_.end(), [](std::uint32_t digit) { return digit != 0; });
  place_ += static_cast<int>(first - digits_.begin());
  digits_.erase(digits_.begin(), first);
}

Dyadic Dyadic::sum(const Dyadic& a, const Dyadic& b, bool b_negative) {
  if (b.digits_.empty()) return a;
  Dyadic result;
  result.place_ = a.digits_.empty() ? b.place_ : std::min(a.place_, b.place_);
  const int end =
      std::max(a.place_ + static_cast<int>(a.digits_.size()), b.place_ + static_cast<int>(b.digits_.size()));
  const bool same = a.negative_ == b_negative;
  std::int64_t carry = 0;  // in |a| + |b|, or in |a| - |b|
  for (int place = result.place_; place <= end; ++place) {
    const auto x = static_cast<std::int64_t>(digit_at(a.digits_, a.place_, place));
    const auto y = static_cast<std::int64_t>(digit_at(b.digits_, b.place_, place));
    carry += same ? x + y : x - y;
    result.digits_.push_back(static_cast<std::uint32_t>(carry & 0xffffffff));
    carry >>= 32;
  }
  result.negative_ = a.negative_;
  if (carry < 0) {  // |a| < |b|: the digits are the two's complement of the difference
    result.negative_ = !a.negative_;
    std::uint64_t one = 1;
    for (std::uint32_t& digit : result.digits_) {
      one += static_cast<std::uint32_t>(~digit);
      digit = static_cast<std::uint32_t>(one);
      one >>= 32;
    }
  }
  result.trim();
  return result;
}

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
  Dyadic result;
  if (a.digits_.empty() || b.digits_.empty()) return result;
  result.negative_ = a.negative_ != b.negative_;
  result.place_ = a.place_ + b.place_;
  result.digits_.assign(a.digits_.size() + b.digits_.size(), 0);
  for (std::size_t i = 0; i < a.digits_.size(); ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < b.digits_.size(); ++j) {
      carry += std::uint64_t{a.digits_[i]} * b.digits_[j] + result.digits_[i + j];
      result.digits_[i + j] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    result.digits_[i + b.digits_.size()] = static_cast<std::uint32_t>(carry);
  }
  result.trim();
  return result;
}

}  // namespace snug
