// The stepped tests of axis-aligned boxes against rational arithmetic on the numbers of each representation.
#include "query/overlap/overlaps_aabb_forms.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "core/exact.hpp"
#include "geometry/random.hpp"

using namespace snug;
using exact::Rational;

namespace {

template <int Dim>
struct Bounds {
  Rational min[Dim], max[Dim];
};

template <int Dim>
Bounds<Dim> bounds_of(const Aabb<double, Dim>& box) {
  Bounds<Dim> bounds;
  for (int i = 0; i < Dim; ++i) bounds.min[i] = Rational(box.min[i]), bounds.max[i] = Rational(box.max[i]);
  return bounds;
}
template <int Dim>
Bounds<Dim> bounds_of(const AabbMinWidths<double, Dim>& box) {
  Bounds<Dim> bounds;
  for (int i = 0; i < Dim; ++i)
    bounds.min[i] = Rational(box.min[i]), bounds.max[i] = bounds.min[i] + Rational(box.widths[i]);
  return bounds;
}
template <int Dim>
Bounds<Dim> bounds_of(const AabbCenterExtents<double, Dim>& box) {
  Bounds<Dim> bounds;
  for (int i = 0; i < Dim; ++i) {
    bounds.min[i] = Rational(box.center[i]) - Rational(box.half_extents[i]);
    bounds.max[i] = Rational(box.center[i]) + Rational(box.half_extents[i]);
  }
  return bounds;
}

/// The first axis with a gap, in rational arithmetic; Dim for none.
template <int Dim>
int first_gap(const Bounds<Dim>& a, const Bounds<Dim>& b) {
  int i = 0;
  while (i < Dim && a.max[i] >= b.min[i] && b.max[i] >= a.min[i]) ++i;
  return i;
}

struct Steps {
  std::vector<query::OverlapStep> kept;
  std::int64_t comparisons = 0;
  void operator()(const query::OverlapStep& step) { kept.push_back(step); }
  void count(Operation, std::int64_t n) { comparisons += n; }
};

struct Seen {
  int apart = 0, together = 0;
};

template <class Form, int Dim>
void check(const Form& a, const Form& b, Seen& seen) {
  Steps steps;
  const auto result = query::test_axis_by_axis(a, b, steps);
  const int gap = first_gap<Dim>(bounds_of(a), bounds_of(b));
  CHECK(result.overlap == (gap == Dim));
  CHECK(result.tests == std::min(gap + 1, Dim));
  REQUIRE(static_cast<int>(steps.kept.size()) == result.tests);
  for (int i = 0; i < result.tests; ++i) {
    const auto* slab = std::get_if<query::SlabTested>(&steps.kept[i].fact);
    REQUIRE(slab != nullptr);
    CHECK(slab->direction[i] == 1);
    CHECK(slab->separates == (i == gap));
    CHECK(steps.kept[i].line == i);
  }
  CHECK(steps.comparisons <= 2 * Dim);
  if (!result.overlap) CHECK(result.separating_axis->gap > 0);
  CHECK(query::test_axis_by_axis(a, b).overlap == result.overlap);
  (result.overlap ? seen.together : seen.apart) += 1;
}

double grazed(Random& random, double value) {
  const int steps = static_cast<int>(random.below(3)) - 1;
  return steps == 0 ? value : std::nextafter(value, steps > 0 ? 10.0 : -10.0);
}

/// Two boxes that touch, miss or overlap by a last digit along some axes.
template <int Dim>
std::array<Aabb<double, Dim>, 2> grazing(Random& random) {
  std::array<Aabb<double, Dim>, 2> pair;
  for (int i = 0; i < Dim; ++i) {
    pair[0].min[i] = random.between(-2, 1), pair[0].max[i] = pair[0].min[i] + random.unit();
    const double width = random.unit();
    if (random.below(2) == 0) pair[1].min[i] = grazed(random, pair[0].max[i]), pair[1].max[i] = pair[1].min[i] + width;
    else pair[1].max[i] = grazed(random, pair[0].min[i]), pair[1].min[i] = pair[1].max[i] - width;
  }
  return pair;
}

template <int Dim>
void check_grazing(std::uint64_t seeds) {
  Seen min_max, min_widths, centered;
  Random random(seeds);
  for (int i = 0; i < 400; ++i) {
    const auto [a, b] = grazing<Dim>(random);
    check<Aabb<double, Dim>, Dim>(a, b, min_max);
    check<AabbMinWidths<double, Dim>, Dim>(min_widths_of(a), min_widths_of(b), min_widths);
    check<AabbCenterExtents<double, Dim>, Dim>(center_extents_of(a), center_extents_of(b), centered);
    CHECK(query::test_axis_by_axis(a, b).overlap == query::test_slabs(a, b).overlap);
  }
  for (const Seen& seen : {min_max, min_widths, centered}) CHECK((seen.apart > 20 && seen.together > 20));
}

}  // namespace

TEST_CASE("each representation's test is what rational arithmetic says of its numbers, to the last digit") {
  check_grazing<2>(1);
  check_grazing<3>(2);
}

TEST_CASE("boxes that touch overlap in all three representations") {
  const Aabb<double, 2> a{{-1, -1}, {0.25, 1}}, b{{0.25, -0.5}, {2, 0.5}};
  CHECK(query::test_axis_by_axis(a, b).overlap);
  CHECK(query::test_axis_by_axis(min_widths_of(a), min_widths_of(b)).overlap);
  CHECK(query::test_axis_by_axis(center_extents_of(a), center_extents_of(b)).overlap);
  const Aabb<double, 2> past{{std::nextafter(0.25, 1), -0.5}, {2, 0.5}};
  CHECK_FALSE(query::test_axis_by_axis(a, past).overlap);
}
