#include "geometry/orientation.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "number/bits.hpp"
#include "number/dyadic.hpp"
#include "number/exact_sum.hpp"
#include "number/exact_tally.hpp"
#include "number/power_of_two.hpp"
#include "number/tuple.hpp"

namespace snug {
namespace {

__extension__ typedef __int128 Wide;
using Integers = std::array<std::int64_t, 3>;

/// The exponents of the value's lowest set bit and of the bit above its highest. value: finite, not 0.
struct Bits {
  int low, high;
};
Bits bits_used(double value) {
  const std::uint64_t bits = bits_of(value);
  const auto field = static_cast<int>((bits >> 52) & 0x7ff);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const std::uint64_t mantissa = field == 0 ? fraction : fraction | (std::uint64_t{1} << 52);
  const int exponent = std::max(field, 1) - 1075;
  return {exponent + std::countr_zero(mantissa), exponent + 64 - std::countl_zero(mantissa)};
}

/// How many bits coordinates may span for their differences to stay below 2^61, which sums of products of three need.
constexpr int kIntegerBits = 60;

/// Converts points to integers in a common unit; false if that takes too many bits.
template <int Dim, std::size_t kCount>
bool to_integers(const std::array<const Vector<double, Dim>*, kCount>& points, std::array<Integers, kCount>& whole) {
  int low = 1100, high = -1100;
  for (const auto* point : points)
    for (int axis = 0; axis < Dim; ++axis) {
      if ((*point)[axis] == 0) continue;
      const Bits used = bits_used((*point)[axis]);
      low = std::min(low, used.low);
      high = std::max(high, used.high);
    }
  if (high - low > kIntegerBits) return false;
  const int half = -low / 2;  // 2^-low itself may overflow a double
  const double scale = std::ldexp(1.0, half), rest = std::ldexp(1.0, -low - half);
  for (std::size_t i = 0; i < kCount; ++i)
    for (int axis = 0; axis < Dim; ++axis)
      whole[i][axis] = static_cast<std::int64_t>((*points[i])[axis] * scale * rest);
  return true;
}

Integers difference(const Integers& a, const Integers& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

int sign_of(Wide value) {
  if (value > 0) return 1;
  return value < 0 ? -1 : 0;
}

/// The sign of the sum of minors[i] * factors[i]: |minors| < 2^124, |factors| < 2^61.
int sign_of_sum(const std::array<Wide, 3>& minors, const Integers& factors) {
  Wide high = 0, low = 0;  // the sum is high * 2^64 + low
  for (std::size_t i = 0; i < 3; ++i) {
    high += (minors[i] >> 64) * factors[i];
    low += static_cast<Wide>(static_cast<std::uint64_t>(minors[i])) * factors[i];
  }
  high += low >> 64;
  if (high != 0) return sign_of(high);
  return static_cast<std::uint64_t>(low) != 0 ? 1 : 0;
}

int orient3d_of_integers(const std::array<Integers, 4>& p) {
  const Integers b = difference(p[1], p[0]), c = difference(p[2], p[0]), d = difference(p[3], p[0]);
  const auto minor = [&](std::size_t i, std::size_t j) { return Wide{b[i]} * c[j] - Wide{b[j]} * c[i]; };
  return sign_of_sum({minor(1, 2), minor(2, 0), minor(0, 1)}, d);
}

using Exact3 = Tuple<Dyadic, 3>;

Exact3 exact_difference(const Vector<double, 3>& a, const Vector<double, 3>& b) {
  return tuple_of<Dyadic, 3>(a) - tuple_of<Dyadic, 3>(b);
}

int orient3d_exact(detail::P3 a, detail::P3 b, detail::P3 c, detail::P3 d) {
  const Exact3 e = exact_difference(b, a), f = exact_difference(c, a), g = exact_difference(d, a);
  return dot(cross(e, f), g).sign();
}

/// a - b, scaled by a power of two to a size of about 1, which changes no sign of a product.
Vector<double, 3> scaled_difference(const Vector<double, 3>& a, const Vector<double, 3>& b) {
  const bool may_overflow = std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()) > 0x1p1022;
  Vector<double, 3> d = may_overflow ? Vector<double, 3>(a / 2 - b / 2) : Vector<double, 3>(a - b);
  const double largest = d.cwiseAbs().maxCoeff();
  return d * to_unit_size(largest);
}

/// Applies the filter once more, to differences of about unit size: no product overflows, and what underflows is
/// negligible.
int orient3d_scaled(detail::P3 a, detail::P3 b, detail::P3 c, detail::P3 d) {
  const Vector<double, 3> e = scaled_difference(b, a), f = scaled_difference(c, a), g = scaled_difference(d, a);
  double value = 0, size = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double left = e[j] * f[k], right = e[k] * f[j];
    value += g[i] * (left - right);
    size += std::abs(g[i]) * (std::abs(left) + std::abs(right));
  }
  return detail::certain_sign(value, tolerance::kSixTripleProducts * size + 16 * tolerance::kLostToUnderflow);
}

}  // namespace

namespace detail {

int cross_sign_exact(P2 a, P2 b, P2 c, P2 d) noexcept {
  ++exact_decisions;
  std::array<Integers, 4> p{};
  if (to_integers<2, 4>({&a, &b, &c, &d}, p)) {
    const Integers e = difference(p[1], p[0]), f = difference(p[3], p[2]);
    return sign_of(Wide{e[0]} * f[1] - Wide{e[1]} * f[0]);
  }
  ExactSum sum;
  sum.add_product(b[0], d[1]);
  sum.add_product(-b[0], c[1]);
  sum.add_product(-a[0], d[1]);
  sum.add_product(a[0], c[1]);
  sum.add_product(-b[1], d[0]);
  sum.add_product(b[1], c[0]);
  sum.add_product(a[1], d[0]);
  sum.add_product(-a[1], c[0]);
  return sum.sign();
}

int orient3d_in_doubt(P3 a, P3 b, P3 c, P3 d) noexcept {
  ++exact_decisions;
  std::array<Integers, 4> p{};
  if (to_integers<3, 4>({&a, &b, &c, &d}, p)) return orient3d_of_integers(p);
  const int sign = orient3d_scaled(a, b, c, d);
  return sign != 0 ? sign : orient3d_exact(a, b, c, d);
}

template <int Dim>
int dot_sign_exact(P<Dim> a, P<Dim> b, P<Dim> c, P<Dim> d) noexcept {
  ++exact_decisions;
  ExactSum sum;
  for (int i = 0; i < Dim; ++i) {
    sum.add_product(b[i], d[i]);
    sum.add_product(-b[i], c[i]);
    sum.add_product(-a[i], d[i]);
    sum.add_product(a[i], c[i]);
  }
  return sum.sign();
}
template int dot_sign_exact<2>(P<2>, P<2>, P<2>, P<2>) noexcept;
template int dot_sign_exact<3>(P<3>, P<3>, P<3>, P<3>) noexcept;

}  // namespace detail

}  // namespace snug
