#include "query/batch/obb_sat_batch.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "core/query/box_pairs.hpp"
#include "query/obb_sat.hpp"

using namespace snug;

namespace {

template <class Scalar>
using Boxes = std::vector<Obb<Scalar, 3>>;

/// All verdicts at once are those one by one. Returns how many overlap.
template <class Scalar>
int check_same(const Boxes<Scalar>& a, const Boxes<Scalar>& b) {
  std::vector<std::uint8_t> overlap(a.size(), 7);
  query::obbs_overlap<Scalar>(query::ObbArray<Scalar>(a), query::ObbArray<Scalar>(b), overlap);
  int overlapping = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    CAPTURE(i);
    CHECK(int{overlap[i]} == int{query::obb_sat(a[i], b[i]).overlap});
    overlapping += overlap[i];
  }
  return overlapping;
}

}  // namespace

TEST_CASE_TEMPLATE("no boxes, one, and any number up to more than a block have their verdicts", Scalar, float, double) {
  Random random(1);
  Boxes<Scalar> a, b;
  for (int n = 0; n < 40; ++n) {
    check_same(a, b);
    a.push_back(test::any_box<Scalar, 3>(random, 1));
    b.push_back(test::any_box<Scalar, 3>(random, 1));
  }
}

TEST_CASE_TEMPLATE("an array of boxes gives back what it was given", Scalar, float, double) {
  Random random(2);
  Boxes<Scalar> boxes;
  for (int n = 0; n < 37; ++n) boxes.push_back(test::any_box<Scalar, 3>(random, 1));
  query::ObbArray<Scalar> array(boxes);
  const auto other = test::any_box<Scalar, 3>(random, 1);
  array.set(20, other);
  boxes[20] = other;
  REQUIRE(array.size() == 37);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    CHECK(array[i].center == boxes[i].center);
    CHECK(array[i].axes == boxes[i].axes);
    CHECK(array[i].half_extents == boxes[i].half_extents);
  }
}

TEST_CASE_TEMPLATE("many boxes at once have the verdicts of the hard families", Scalar, float, double) {
  Random random(3);
  Boxes<Scalar> a, b;
  for (int round = 0; round < 3; ++round)
    for (int o = 0; o < test::kOrientations; ++o)
      for (int e = 0; e < test::kExtents; ++e)
        for (const double gap : {0.0, 1e-5, -1e-5, 1e-3, -1e-3, 0.3, -0.3})
          for (const double offset : {0.0, 1e5}) {
            const auto pair = test::pair_of<Scalar, 3>(static_cast<test::Orientation>(o), static_cast<test::Extents>(e),
                                                       gap, offset, random);
            a.push_back(pair.a);
            b.push_back(pair.b);
          }
  const int overlapping = check_same(a, b);
  CHECK(overlapping > static_cast<int>(a.size()) / 5);
  CHECK(overlapping < static_cast<int>(a.size()) * 4 / 5);
}

TEST_CASE_TEMPLATE("a wall of cubes that share their axes: each touches its neighbours, and no others", Scalar, float,
                   double) {
  Boxes<Scalar> a, b;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      for (int z = -2; z <= 2; ++z) {
        a.push_back({.half_extents = {Scalar(0.5), Scalar(0.5), Scalar(0.5)}});
        b.push_back(a.back());
        b.back().center = {Scalar(x), Scalar(y), Scalar(z)};
      }
  CHECK(check_same(a, b) == 27);
}
