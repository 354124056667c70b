// Touching is told from overlapping exactly: at the gap, and one unit in the last place to either side of it.
#include "query/overlap/touching.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace snug;

namespace {

using V2 = Volume<double, 2>;
using V3 = Volume<double, 3>;

std::optional<bool> touch(const V3& a, const V3& b) {
  const auto one = query::touch<double, 3>(a, b);
  CHECK(one == query::touch<double, 3>(b, a));
  return one;
}

}  // namespace

TEST_CASE("spheres and boxes that touch are told from those one rounding deeper or apart") {
  const auto sphere = [](double radius) { return V3(Sphere<double, 3>{{3, 4, 12}, radius}); };
  const V3 about_origin = Sphere<double, 3>{{0, 0, 0}, 6};
  CHECK(touch(about_origin, sphere(7)) == true);
  CHECK(touch(about_origin, sphere(std::nextafter(7, 8))) == false);
  CHECK(touch(about_origin, sphere(std::nextafter(7, 6))) == false);

  const V3 box = Aabb<double, 3>{{-2, -2, -2}, {0, 0, 0}};
  CHECK(touch(box, sphere(13)) == true);
  CHECK(touch(box, sphere(std::nextafter(13, 14))) == false);
  CHECK(touch(box, V3(Sphere<double, 3>{{-1, -1, -1}, 0})) == false);  // a point inside
  CHECK(touch(box, V3(Sphere<double, 3>{{-1, -1, 0}, 0})) == true);    // on a face
  CHECK(touch(box, V3(Sphere<double, 3>{{-1, -1, 0}, 1})) == false);

  CHECK(touch(box, V3(Aabb<double, 3>{{0, -1, -1}, {1, 0, 1}})) == true);
  CHECK(touch(box, V3(Aabb<double, 3>{{-0x1p-1074, -1, -1}, {1, 0, 1}})) == false);
  CHECK(touch(box, V3(Aabb<double, 3>{{0x1p-1074, -1, -1}, {1, 0, 1}})) == false);
}

TEST_CASE("oriented boxes touch by a face, an edge or a corner, and parallel edges do not make them") {
  const Matrix<double, 3> straight = Matrix<double, 3>::Identity();
  const auto at = [&](double x, double y, double z) { return V3(Obb<double, 3>{{x, y, z}, straight, {1, 1, 1}}); };
  const V3 first = at(0, 0, 0);
  CHECK(touch(first, at(2, 0.5, 0)) == true);
  CHECK(touch(first, at(2, 2, 0)) == true);
  CHECK(touch(first, at(2, 2, 2)) == true);
  CHECK(touch(first, at(std::nextafter(2, 1), 0.5, 0)) == false);
  CHECK(touch(first, at(std::nextafter(2, 3), 0.5, 0)) == false);
  CHECK(touch(first, at(1, 1, 1)) == false);
  CHECK(touch(first, V3(Aabb<double, 3>{{1, 0, 0}, {2, 1, 1}})) == true);
  CHECK(touch(V3(Aabb<double, 3>{{0.1, 0, 0}, {1.7, 1, 1}}), first).has_value() == false);  // its centre rounds

  Matrix<double, 2> turned;
  turned << 0.6, -0.8, 0.8, 0.6;
  const V2 diamond = Obb<double, 2>{{0, 0}, turned, {5, 5}};
  CHECK(query::touch<double, 2>(diamond, V2(Sphere<double, 2>{{9, 9}, 1})).has_value() == false);
  CHECK(query::touch<double, 2>(diamond, V2(Capsule<double, 2>{{9, 9}, {9, 8}, 1})).has_value() == false);
}
