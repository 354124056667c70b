// The cylinders on the axes of two capsules.
#include <doctest/doctest.h>

#include "geometry/capsule.hpp"
#include "lesson/subjects/pair/volumes.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

using Axis = Capsule<double, 3>;

VolumePair cylinders_of(const Axis& a, const Axis& b) {
  VolumePair pair{.dim = 3, .cylinders = true};
  pair.held[0] = {a, 3, {}, 0.5};
  pair.held[1] = {b, 3, {}, 0.5};
  return pair;
}

}  // namespace

TEST_CASE("cylinders end where their axes do: end to end they can be apart while the capsules overlap") {
  const Axis a{{-3, 0, 0}, {-1, 0, 0}, 1};
  const auto end_to_end = as_cylinders(cylinders_of(a, {{-0.5, 0, 0}, {2, 0, 0}, 1}));
  REQUIRE(end_to_end);
  CHECK_FALSE(end_to_end->overlap);
  CHECK(end_to_end->gap == doctest::Approx(0.5));
  CHECK_FALSE(separation_of(cylinders_of(a, {{-0.5, 0, 0}, {2, 0, 0}, 1})));
  const VolumesSubject subject(cylinders_of(a, {{-0.5, 0, 0}, {2, 0, 0}, 1}), 1);
  CHECK(subject.reaches("cylinders_apart"));
  CHECK(subject.goal_says("cylinders_apart") == "The capsules overlap; the cylinders are apart by 0.500 units.");
}

TEST_CASE("side by side cylinders are as far apart as their capsules") {
  const VolumePair pair = cylinders_of({{-1, 0, 0}, {1, 0, 0}, 0.5}, {{-1, 1.25, 0}, {1, 1.25, 0}, 0.5});
  const auto cylinders = as_cylinders(pair);
  const auto capsules = separation_of(pair);
  REQUIRE(cylinders);
  REQUIRE(capsules);
  CHECK(cylinders->gap == doctest::Approx(0.25));
  CHECK(cylinders->gap == doctest::Approx(capsules->distance));
  CHECK(cylinders->simplices >= 1);
}

TEST_CASE("an axis of no length has no cylinder") {
  CHECK_FALSE(as_cylinders(cylinders_of({{0, 0, 0}, {0, 0, 0}, 1}, {{3, 0, 0}, {4, 0, 0}, 1})));
}
