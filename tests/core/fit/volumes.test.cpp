// Known figures of boxes, through the catalogue, as the command line and lessons call it.
#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include "core/point_clouds.hpp"
#include "fit/catalogue.hpp"

using namespace snug;

TEST_CASE("known figures of the exact box: a turned 1 x 2 x 3, a tetrahedron in its cube") {
  const auto exact = [](const std::vector<Vector<double, 3>>& points) {
    return fit::size_of(fit::find_algorithm("obb", "exact")->fit(AnyPointSet(test::set_of<double, 3>(points)), {}).volume, 3);
  };
  const auto faces = [](const std::vector<Vector<double, 3>>& points) {
    return fit::size_of(fit::find_algorithm("obb", "face_aligned")->fit(AnyPointSet(test::set_of<double, 3>(points)), {}).volume, 3);
  };
  std::vector<Vector<double, 3>> turned;
  const Vector<double, 3> u(2.0 / 3, 2.0 / 3, 1.0 / 3), v(-2.0 / 3, 1.0 / 3, 2.0 / 3), w = u.cross(v);
  for (int bits = 0; bits < 8; ++bits)
    turned.push_back(u * (bits & 1) + v * (bits >> 1 & 1) * 2 + w * (bits >> 2 & 1) * 3);
  CHECK(exact(turned) == doctest::Approx(6).epsilon(1e-12));
  const std::vector<Vector<double, 3>> tetrahedron{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  CHECK(exact(tetrahedron) == doctest::Approx(8).epsilon(1e-12));
  CHECK(faces(tetrahedron) == doctest::Approx(16).epsilon(1e-12));
}
