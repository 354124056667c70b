// The three tests of boxes against rational arithmetic on the numbers of each representation.
#include "query/overlap/aabb_overlap.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "core/exact.hpp"
#include "geometry/random.hpp"
#include "geometry/tolerance.hpp"

using namespace snug;
using exact::Rational;

namespace {

template <class Scalar>
Rational exactly(Scalar value) {
  return Rational(static_cast<double>(value));
}

/// The largest gap between two boxes along an axis, exactly; at most 0 where they meet.
template <class Scalar, int Dim>
Rational gap(const AabbMinWidths<Scalar, Dim>& a, const AabbMinWidths<Scalar, Dim>& b) {
  std::optional<Rational> most;
  for (int i = 0; i < Dim; ++i) {
    const Rational a_min = exactly(a.min[i]), b_min = exactly(b.min[i]);
    const Rational below = a_min - b_min - exactly(b.widths[i]), above = b_min - a_min - exactly(a.widths[i]);
    const Rational here = std::max(below, above);
    most = most ? std::max(*most, here) : here;
  }
  return *most;
}

template <class Scalar, int Dim>
Rational gap(const AabbCenterExtents<Scalar, Dim>& a, const AabbCenterExtents<Scalar, Dim>& b) {
  std::optional<Rational> most;
  for (int i = 0; i < Dim; ++i) {
    const Rational centers = exactly(a.center[i]) - exactly(b.center[i]);
    const Rational here = abs(centers) - exactly(a.half_extents[i]) - exactly(b.half_extents[i]);
    most = most ? std::max(*most, here) : here;
  }
  return *most;
}

template <class Scalar, int Dim>
Rational gap(const Aabb<Scalar, Dim>& a, const Aabb<Scalar, Dim>& b) {
  std::optional<Rational> most;
  for (int i = 0; i < Dim; ++i) {
    const Rational here = std::max(exactly(a.min[i]) - exactly(b.max[i]), exactly(b.min[i]) - exactly(a.max[i]));
    most = most ? std::max(*most, here) : here;
  }
  return *most;
}

template <class Scalar>
Scalar stepped(Scalar value, int steps) {
  constexpr Scalar kFar = std::numeric_limits<Scalar>::max();
  for (int k = 0; k < std::abs(steps); ++k) value = std::nextafter(value, steps > 0 ? kFar : -kFar);
  return value;
}

/// Two boxes whose faces are a few units in the last place from touching, at some scale and place.
template <class Scalar, int Dim>
struct GrazingBoxes {
  AabbCenterExtents<Scalar, Dim> a, b;
};

template <class Scalar, int Dim>
GrazingBoxes<Scalar, Dim> grazing(Random& random) {
  const bool is_double = sizeof(Scalar) == 8;
  const double scale = std::pow(10.0, random.between(is_double ? -300 : -40, is_double ? 300 : 30));
  const double offset = random.below(2) == 0 ? 0 : scale * random.between(-1e4, 1e4);
  GrazingBoxes<Scalar, Dim> pair;
  for (int i = 0; i < Dim; ++i) {
    pair.a.center[i] = static_cast<Scalar>(scale * random.between(-1, 1) + offset);
    pair.a.half_extents[i] = static_cast<Scalar>(scale * random.unit());
    const double share = random.below(4) == 0 ? 0 : random.unit() * std::pow(10.0, -random.between(0, 8));
    pair.b.half_extents[i] = static_cast<Scalar>(scale * share);
    const Scalar reach = pair.a.half_extents[i] + pair.b.half_extents[i];
    const Scalar touching = pair.a.center[i] + (random.below(2) == 0 ? reach : -reach);
    pair.b.center[i] = stepped(touching, static_cast<int>(random.below(7)) - 3);
  }
  return pair;
}

}  // namespace

TEST_CASE_TEMPLATE("boxes that meet are never called apart, and only rounding hides a gap", Scalar, float, double) {
  Random random(1);
  int meet = 0, apart = 0, missed = 0;
  const auto check = [&](const auto& a, const auto& b, double lost) {
    const Rational between = gap(a, b);
    const bool found = query::aabbs_overlap(a, b);
    CHECK(found == query::aabbs_overlap(b, a));
    (between <= 0 ? meet : apart) += 1;
    if (between <= 0) CHECK(found);
    if (between > Rational(lost)) CHECK(!found);
    missed += found && between > 0 ? 1 : 0;
  };
  for (int round = 0; round < 3000; ++round) {
    const auto [a, b] = grazing<Scalar, 2>(random);
    constexpr double kU = tolerance::kRoundoff<Scalar>;
    // What is lost is a share of the distance compared, plus what one more rounding adds to that.
    const auto far = [](const auto& x, const auto& y) {
      return (x.template cast<double>() - y.template cast<double>()).cwiseAbs().maxCoeff() * (1 + 8 * kU);
    };
    check(a, b, 2 * kU * far(a.center, b.center));
    const auto a_widths = min_widths_of(a), b_widths = min_widths_of(b);
    check(a_widths, b_widths, kU * far(a_widths.min, b_widths.min));
    check(min_max_of(a), min_max_of(b), 0);
  }
  CHECK(meet > 1000);
  CHECK(apart > 1000);
  CHECK(missed > 100);
}

TEST_CASE("touching boxes overlap in every representation, and the next number apart they do not") {
  const Aabb<double, 3> a{{0, 0, 0}, {1, 1, 1}};
  for (const double x : {1.0, std::nextafter(1.0, 2.0)}) {
    const Aabb<double, 3> b{{x, 1, -2}, {3, 4, 0}};
    const bool touch = x == 1;
    CHECK(query::aabbs_overlap(a, b) == touch);
    CHECK(query::aabbs_overlap(min_widths_of(a), min_widths_of(b)) == touch);
  }
  CHECK(query::aabbs_overlap(center_extents_of(a), AabbCenterExtents<double, 3>{{2, 1, -1}, {1, 0, 1}}));
  CHECK_FALSE(query::aabbs_overlap(center_extents_of(a), AabbCenterExtents<double, 3>{{2.001, 1, -1}, {1, 0, 1}}));
}

TEST_CASE("boxes as large as numbers go are not called apart by what overflows") {
  constexpr double kMax = std::numeric_limits<double>::max();
  const AabbCenterExtents<double, 2> left{{-kMax, 0}, {kMax, 1}}, right{{kMax, 0}, {kMax, 1}};
  CHECK(query::aabbs_overlap(left, right));
  const AabbMinWidths<double, 2> low{{-kMax, 0}, {kMax, 1}}, high{{0, 0}, {kMax, 1}};
  CHECK(query::aabbs_overlap(low, high));
}

TEST_CASE("a point is a box too, and one axis apart is apart") {
  const Aabb<float, 2> point{{1, 1}, {1, 1}};
  CHECK(query::aabbs_overlap(point, point));
  CHECK(query::aabbs_overlap(center_extents_of(point), center_extents_of(point)));
  CHECK(query::aabbs_overlap(min_widths_of(point), min_widths_of(point)));
  CHECK_FALSE(query::aabbs_overlap(point, Aabb<float, 2>{{1, 2}, {2, 3}}));
  CHECK_FALSE(query::aabbs_overlap(point, Aabb<float, 2>{{2, 1}, {3, 2}}));
}
