// The three representations of a box, and sums rounded outwards, against rational arithmetic.
#include "geometry/aabb_forms.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <type_traits>

#include "core/exactly.hpp"
#include "geometry/random.hpp"
#include "number/bits.hpp"

using namespace snug;
using exact::exactly;
using exact::Rational;

namespace {

/// Any finite Scalar: every exponent alike, or near others of its kind, or one of the special.
template <class Scalar>
Scalar any_scalar(Random& random) {
  constexpr Scalar kMax = std::numeric_limits<Scalar>::max(), kLeast = std::numeric_limits<Scalar>::denorm_min();
  constexpr Scalar kSpecial[] = {0, 1, -1, kMax, -kMax, kLeast, -kLeast, std::numeric_limits<Scalar>::min()};
  switch (random.below(4)) {
    case 0: return kSpecial[random.below(8)];
    case 1: return static_cast<Scalar>(random.between(-1, 1));
    case 2: return static_cast<Scalar>(1e6 + random.between(-1, 1));
    default:
      for (;;) {
        const std::uint64_t bits = random.bits();
        const auto value = sizeof(Scalar) == 8 ? static_cast<Scalar>(double_of(bits))
                                               : static_cast<Scalar>(float_of(static_cast<std::uint32_t>(bits)));
        if (std::isfinite(value)) return value;
      }
  }
}

template <class Scalar>
struct Interval {
  Rational low, high;
  explicit Interval(const Aabb<Scalar, 2>& box, int i) : low(exactly(box.min[i])), high(exactly(box.max[i])) {}
  explicit Interval(const AabbMinWidths<Scalar, 2>& box, int i)
      : low(exactly(box.min[i])), high(low + exactly(box.widths[i])) {}
  explicit Interval(const AabbCenterExtents<Scalar, 2>& box, int i)
      : low(exactly(box.center[i]) - exactly(box.half_extents[i])),
        high(exactly(box.center[i]) + exactly(box.half_extents[i])) {}
};

/// One unit in the last place of the interval's largest number.
template <class Scalar>
Rational ulp_of(const Interval<Scalar>& interval) {
  const Rational width = interval.high - interval.low;
  const Rational largest = std::max({Rational(abs(interval.low)), Rational(abs(interval.high)), width});
  const Scalar size = static_cast<Scalar>(largest.template convert_to<double>());
  if (!std::isfinite(size)) return largest;
  const Scalar above = std::nextafter(size, std::numeric_limits<Scalar>::infinity());
  return std::isfinite(above) ? Rational(exactly(above) - exactly(size))
                              : Rational(exactly(size) - exactly(std::nextafter(size, Scalar(0))));
}

template <class Scalar>
bool all_finite(const AabbMinWidths<Scalar, 2>& box) {
  return box.min.allFinite() && box.widths.allFinite();
}
template <class Scalar>
bool all_finite(const AabbCenterExtents<Scalar, 2>& box) {
  return box.center.allFinite() && box.half_extents.allFinite();
}
template <class Scalar>
bool all_finite(const Aabb<Scalar, 2>& box) {
  return box.min.allFinite() && box.max.allFinite();
}

/// Whether to holds from in exact arithmetic and is no more than that many units larger on either side.
template <class Scalar>
void check_holds(const auto& from, const auto& to, int units, int& grew) {
  for (int i = 0; i < 2; ++i) {
    const Interval<Scalar> before(from, i), after(to, i);
    CHECK(after.low <= before.low);
    CHECK(after.high >= before.high);
    const Rational ulp = ulp_of(before);
    CHECK(before.low - after.low <= units * ulp);
    CHECK(after.high - before.high <= units * ulp);
    grew += after.low < before.low || after.high > before.high ? 1 : 0;
  }
}

}  // namespace

TEST_CASE_TEMPLATE("a sum rounded outwards is the nearest number on that side", Scalar, float, double) {
  constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();
  Random random(1);
  int inexact = 0, three_inexact = 0;
  for (int round = 0; round < 4000; ++round) {
    const auto a = any_scalar<Scalar>(random), b = any_scalar<Scalar>(random);
    const Rational sum = exactly(a) + exactly(b);
    const Scalar up = sum_up<Scalar>(a, b), down = sum_down<Scalar>(a, b);
    if (up != kInfinity) CHECK(exactly(up) >= sum);
    if (up != std::numeric_limits<Scalar>::lowest()) CHECK(exactly(std::nextafter(up, -kInfinity)) < sum);
    if (down != -kInfinity) CHECK(exactly(down) <= sum);
    inexact += up != down ? 1 : 0;
    // Three, kept from overflowing, of sizes that cancel now and then.
    const Scalar c = round % 3 == 0 ? std::nextafter(-(a / 4 + b / 4), Scalar(0)) : any_scalar<Scalar>(random) / 4;
    const Rational three = exactly(a / 4) + exactly(b / 4) + exactly(c);
    const Scalar three_up = sum_up<Scalar>(a / 4, b / 4, c), three_down = sum_down<Scalar>(a / 4, b / 4, c);
    CHECK(exactly(three_up) >= three);
    CHECK(exactly(std::nextafter(three_up, -kInfinity)) < three);
    CHECK(exactly(three_down) <= three);
    CHECK(exactly(std::nextafter(three_down, kInfinity)) > three);
    three_inexact += three_up != three_down ? 1 : 0;
  }
  CHECK(inexact > 1000);
  CHECK(three_inexact > 1000);
}

TEST_CASE_TEMPLATE("no conversion of a box loses a point or grows by more than its few units", Scalar, float, double) {
  Random random(2);
  int grew = 0, infinite = 0;
  for (int round = 0; round < 3000; ++round) {
    Aabb<Scalar, 2> box;
    for (int i = 0; i < 2; ++i) {
      const auto a = any_scalar<Scalar>(random), b = round % 5 == 0 ? a : any_scalar<Scalar>(random);
      box.min[i] = std::min(a, b);
      box.max[i] = std::max(a, b);
    }
    const auto center = center_extents_of(box);
    REQUIRE(all_finite(center));  // it always fits
    check_holds<Scalar>(box, center, 2, grew);
    const auto widths = min_widths_of(box);
    if (!all_finite(widths)) {
      ++infinite;
      continue;
    }
    check_holds<Scalar>(box, widths, 1, grew);
    const auto back = min_max_of(widths);
    if (all_finite(back)) check_holds<Scalar>(widths, back, 1, grew);
    const auto again = min_max_of(center);
    if (!all_finite(again)) continue;
    check_holds<Scalar>(center, again, 1, grew);
    const auto widths_of_center = min_widths_of(center);
    if (all_finite(widths_of_center)) check_holds<Scalar>(center, widths_of_center, 3, grew);
    if (all_finite(back)) check_holds<Scalar>(widths, center_extents_of(widths), 3, grew);
  }
  CHECK(grew > 1000);
  CHECK(infinite > 10);
}

TEST_CASE("whole numbers are converted without any growth, there and back") {
  const Aabb<float, 3> box{{-3, 2, 0}, {5, 2, 8}};
  const auto widths = min_widths_of(box);
  CHECK(widths.widths == Vector<float, 3>(8, 0, 8));
  const auto center = center_extents_of(box);
  CHECK(center.center == Vector<float, 3>(1, 2, 4));
  CHECK(center.half_extents == Vector<float, 3>(4, 0, 4));
  for (const auto& back : {min_max_of(widths), min_max_of(center), min_max_of(center_extents_of(widths))}) {
    CHECK(back.min == box.min);
    CHECK(back.max == box.max);
  }
  CHECK(min_widths_of(center).widths == widths.widths);
}

TEST_CASE("a width that no number holds is infinite, and the centre of the largest box is not") {
  constexpr double kMax = std::numeric_limits<double>::max();
  const Aabb<double, 2> all{{-kMax, -1}, {kMax, 1}};
  CHECK(std::isinf(min_widths_of(all).widths[0]));
  CHECK(min_widths_of(all).widths[1] == 2);
  CHECK(center_extents_of(all).center[0] == 0);
  CHECK(center_extents_of(all).half_extents[0] == kMax);
}
