#include <doctest/doctest.h>

#include "measure/random_boxes.hpp"
#include "query/exhibits/wrong_corners_only.hpp"
#include "query/exhibits/wrong_extents_only.hpp"
#include "query/overlap/obb_sat.hpp"

using namespace snug;

namespace {

template <class Scalar, int Dim>
void check_both() {
  // Each errs to one side alone, and often enough that nobody should trust it.
  Random random(7);
  int empty_corners = 0, crossings = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto a = cost::random_box<Scalar, Dim>(random), b = cost::random_box<Scalar, Dim>(random);
    const bool overlap = query::obb_sat(a, b).overlap;
    if (overlap) CHECK(query::extents_only(a, b));
    if (!overlap) CHECK_FALSE(query::corners_only(a, b));
    empty_corners += !overlap && query::extents_only(a, b);
    crossings += overlap && !query::corners_only(a, b);
  }
  CHECK(empty_corners > 50);
  CHECK(crossings > 50);
}

}  // namespace

TEST_CASE("extents only and corners only are wrong, each to one side") {
  check_both<double, 2>();
  check_both<double, 3>();
  check_both<float, 2>();
  check_both<float, 3>();
}

TEST_CASE("upright squares: outlines are right, and a plus sign has every corner free") {
  const Obb<double, 2> wide{{0, 0}, Matrix<double, 2>::Identity(), {2, 0.5}},
      tall{{0, 0}, Matrix<double, 2>::Identity(), {0.5, 2}};
  CHECK(query::extents_only(wide, tall));
  CHECK_FALSE(query::corners_only(wide, tall));
  const Obb<double, 2> aside{{4, 0}, Matrix<double, 2>::Identity(), {0.5, 2}};
  CHECK_FALSE(query::extents_only(wide, aside));
  CHECK_FALSE(query::corners_only(wide, aside));
}
