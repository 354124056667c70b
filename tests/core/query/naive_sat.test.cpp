// The naive tests are wrong where the lessons say so, and the epsilons hold where they say so.
#include <doctest/doctest.h>

#include <limits>

#include "geometry/convert.hpp"
#include "geometry/turn.hpp"
#include "measure/random_boxes.hpp"
#include "query/exhibits/naive_sat.hpp"
#include "query/overlap/exact_gap.hpp"
#include "query/overlap/obb_sat.hpp"

using namespace snug;
using query::Guard;

namespace {

struct Pair {
  Obb<double, 3> a, b;
};

/// Boxes that overlap, often just so, with axes that are parallel but for a tiny rotation.
Pair nearly_parallel(Random& random, double scale, double angle) {
  auto a = cost::random_box<double, 3>(random), b = cost::random_box<double, 3>(random);
  const Vector<double, 3> line = a.axes * Vector<double, 3>(1, 2, 3);
  b.axes = orthonormal<double, 3>(turn(line, angle) * a.axes);
  Vector<double, 3> way;
  for (int i = 0; i < 3; ++i) way[i] = random.between(-0.98, 0.98) * (a.half_extents[i] + b.half_extents[i]);
  b.center = a.center + a.axes * way;
  for (auto* box : {&a, &b}) box->center *= scale, box->half_extents *= scale;
  return {a, b};
}

template <class Scalar>
int wrong_of(Guard guard, double scale) {
  Random random(3);
  int wrong = 0;
  for (int i = 0; i < 4000; ++i) {
    const Pair pair = nearly_parallel(random, scale, 4 * std::numeric_limits<Scalar>::epsilon());
    const auto a = converted<Scalar, 3>(pair.a), b = converted<Scalar, 3>(pair.b);
    wrong += query::naive_sat(a, b, guard) != query::obb_sat(a, b).overlap;
  }
  return wrong;
}

}  // namespace

TEST_CASE(
    "without an epsilon noise calls overlapping boxes apart; an epsilon on R and a relative one hold at any size") {
  for (const double scale : {0x1p-20, 1.0, 0x1p20}) {
    CHECK(wrong_of<double>(Guard::kNone, scale) > 3);
    CHECK(wrong_of<float>(Guard::kNone, scale) > 3);
    for (const Guard guard : {Guard::kOnR, Guard::kRelative}) {
      CHECK(wrong_of<double>(guard, scale) == 0);
      CHECK(wrong_of<float>(guard, scale) == 0);
    }
  }
}

TEST_CASE("an absolute epsilon holds at one size, and guards nothing of large boxes in float") {
  CHECK(wrong_of<float>(Guard::kAbsolute, 1) == 0);
  CHECK(wrong_of<float>(Guard::kAbsolute, 0x1p20) > 3);
}

TEST_CASE("an absolute epsilon misses every gap between tiny boxes") {
  Random random(5);
  int apart = 0;
  for (int i = 0; i < 200; ++i) {
    auto a = cost::random_box<double, 3>(random), b = cost::random_box<double, 3>(random);
    for (auto* box : {&a, &b}) box->center *= 0x1p-22, box->half_extents *= 0x1p-22;
    if (query::obb_sat(a, b).overlap) continue;
    ++apart;
    CHECK(query::naive_sat(a, b, Guard::kAbsolute));
    CHECK_FALSE(query::naive_sat(a, b, Guard::kRelative));
  }
  CHECK(apart > 30);
}

TEST_CASE("the face axes alone are wrong to one side") {
  Random random(9);
  int missed = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto a = cost::random_box<double, 3>(random), b = cost::random_box<double, 3>(random);
    const bool overlap = query::obb_sat(a, b).overlap, says = query::faces_only(a, b);
    if (overlap) CHECK(says);
    missed += says && !overlap;
  }
  CHECK(missed > 20);
}

TEST_CASE("the exact gap along a row is the rounded one where rounding does not matter, and 0 for parallel edges") {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const auto a = cost::random_box<double, 3>(random), b = cost::random_box<double, 3>(random);
    query::SatRecorder<double, 3> recorder;
    query::obb_sat(a, b, query::SatExtent::kAll, recorder);
    int place = 0;
    for (const auto& entry : recorder.entries)
      if (const auto* row = std::get_if<query::AxisTested<double, 3>>(&entry.step.fact))
        CHECK(query::exact_gap(a, b, place++) == doctest::Approx(row->axis.gap).epsilon(1e-9));
    CHECK(place == 15);
  }
  Obb<double, 3> box;
  box.axes.setIdentity(), box.center.setZero(), box.half_extents.setOnes();
  CHECK(query::exact_gap(box, box, 6) == 0);   // A x × B x
  CHECK(query::exact_gap(box, box, 0) == -2);  // A x
}
