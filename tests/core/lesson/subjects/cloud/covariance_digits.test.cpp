// The digits of a covariance that are right.
#include "lesson/subjects/cloud/covariance_digits.hpp"

#include <doctest/doctest.h>

#include "core/point_clouds.hpp"

using namespace snug;

TEST_CASE("a covariance is right to as many digits as its worst entry, relative to its largest") {
  const AnyPointSet points = test::set_of<double, 2>({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  Matrix<double, 3> found = Matrix<double, 3>::Zero();
  found(0, 0) = found(1, 1) = 1;
  CHECK(lesson::digits_right(found, points) == 16);
  found(1, 0) = found(0, 1) = 1e-6;
  CHECK(lesson::digits_right(found, points) == 6);
  found(1, 1) = 3;
  CHECK(lesson::digits_right(found, points) == 0);
}
