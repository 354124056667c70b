// A kind of volume of which no more is known than its header: its support mapping and what it contains.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/query/cylinder.hpp"
#include "geometry/random.hpp"
#include "geometry/turn.hpp"
#include "hierarchy/bounds.hpp"
#include "query/contain/contains.hpp"
#include "query/cull/classify.hpp"

using namespace snug;
using query::Culling;

namespace {

template <class Scalar, int Dim>
Vector<Scalar, Dim> any_point(Random& random, double reach) {
  Vector<Scalar, Dim> point;
  for (int i = 0; i < Dim; ++i) point[i] = static_cast<Scalar>(random.between(-reach, reach));
  return point;
}

template <class Scalar, int Dim>
Cylinder<Scalar, Dim> any_cylinder(Random& random, double reach) {
  return {any_point<Scalar, Dim>(random, reach), any_point<Scalar, Dim>(random, reach),
          static_cast<Scalar>(random.between(0, reach))};
}

/// How far a point is from a cylinder, by its distance from the axis and along it.
template <class Scalar, int Dim>
double distance(const Cylinder<Scalar, Dim>& cylinder, const Vector<Scalar, Dim>& point) {
  const Vector<double, Dim> axis = difference(cylinder.b, cylinder.a), p = difference(point, cylinder.a);
  const double length = axis.norm(), along = p.dot(axis) / length;
  const double across = (p - axis * (along / length)).norm() - static_cast<double>(cylinder.radius);
  return std::hypot(std::max({0.0, -along, along - length}), std::max(0.0, across));
}

/// The signs of the least and greatest of normal . p + d over a cylinder, exactly.
template <class Scalar, int Dim>
Span<int> exact_signs(const Plane<Scalar, Dim>& plane, const Cylinder<Scalar, Dim>& cylinder) {
  const Dyadic a = value_at<Dyadic>(plane, cylinder.a), b = value_at<Dyadic>(plane, cylinder.b);
  Dyadic nn, ne, ee;
  for (int i = 0; i < Dim; ++i) {
    const Dyadic n = static_cast<double>(plane.normal[i]);
    const Dyadic e = Dyadic(static_cast<double>(cylinder.b[i])) - Dyadic(static_cast<double>(cylinder.a[i]));
    nn += n * n, ne += n * e, ee += e * e;
  }
  const Dyadic radius = static_cast<double>(cylinder.radius);
  const Dyadic square = radius * radius * (nn * ee - ne * ne);  // of the reach across the axis, times ee
  const auto sign_less = [&](const Dyadic& value) {
    if (value.sign() > 0) return (value * value * ee - square).sign();
    return square.sign() > 0 ? -1 : value.sign();
  };
  return {sign_less(a < b ? a : b), -sign_less(-(a < b ? b : a))};
}

/// A frustum whose first plane all but touches the cylinder; the others are far away.
template <class Scalar, int Dim>
Frustum<Scalar, Dim> grazing(Random& random, const Cylinder<Scalar, Dim>& cylinder) {
  typename Frustum<Scalar, Dim>::Planes planes;
  for (int i = 0; i < 2 * Dim; ++i) {
    planes[i].normal[i / 2] = i % 2 == 0 ? Scalar(-1) : Scalar(1);
    planes[i].d = -1000;
  }
  Plane<Scalar, Dim>& plane = planes[0];
  plane.normal = any_point<Scalar, Dim>(random, 1);
  const Vector<Scalar, Dim> way = random.below(2) == 0 ? plane.normal : Vector<Scalar, Dim>(-plane.normal);
  plane.d = -plane.normal.dot(query::support(cylinder, way));
  for (auto steps = random.below(4); steps > 0; --steps)
    plane.d = std::nextafter(plane.d, random.below(2) == 0 ? Scalar(-1e9) : Scalar(1e9));
  return *Frustum<Scalar, Dim>::make(planes);
}

template <class Scalar, int Dim>
void check_culling(std::uint64_t seed) {
  Random random(seed);
  int outside = 0, inside = 0, grazed = 0, open = 0;
  for (int round = 0; round < 20'000; ++round) {
    CAPTURE(round);
    const auto cylinder = any_cylinder<Scalar, Dim>(random, 1);
    Frustum<Scalar, Dim> frustum = grazing(random, cylinder);
    if (round % 2 == 0) {  // nor always grazing
      typename Frustum<Scalar, Dim>::Planes planes = frustum.planes();
      planes[0].d += static_cast<Scalar>(random.between(-1, 1));
      frustum = *Frustum<Scalar, Dim>::make(planes);
    }
    const Culling culling = query::classify(frustum, cylinder).verdict;
    const Span<int> signs = exact_signs(frustum[0], cylinder);
    if (culling == Culling::kOutside) CHECK(signs.low > 0);
    if (culling == Culling::kInside) CHECK(signs.high <= 0);
    outside += culling == Culling::kOutside ? 1 : 0, inside += culling == Culling::kInside ? 1 : 0;
    const bool undecided = culling == Culling::kIntersecting && (signs.low > 0 || signs.high <= 0);
    (round % 2 == 0 ? open : grazed) += undecided ? 1 : 0;
  }
  CHECK(outside > 1000);
  CHECK(inside > 1000);
  CHECK(grazed > 1000);  // the doubt is real
  CHECK(open < 10);      // and no wider than it need be
}

template <class Scalar, int Dim>
void check_distance(std::uint64_t seed) {
  Random random(seed);
  const double doubt = 1e3 * static_cast<double>(tolerance::kTouching<Scalar>);
  int apart = 0;
  for (int round = 0; round < 2000; ++round) {
    CAPTURE(round);
    const auto cylinder = any_cylinder<Scalar, Dim>(random, 1);
    const auto point = any_point<Scalar, Dim>(random, 3);
    const double outside = query::outside_by(cylinder, point);
    CHECK((outside > 0) == !contains(cylinder, point));
    CHECK(std::abs(outside - distance(cylinder, point)) <= doubt);
    apart += outside > 0 ? 1 : 0;

    const auto other = any_cylinder<Scalar, Dim>(random, 1);
    const auto moved_off = moved(other, any_point<Scalar, Dim>(random, 2));
    const auto found = *query::gjk(cylinder, moved_off);
    if (found.overlap) continue;
    CHECK(found.distance - found.gap <= doubt);  // both bounds meet
    CHECK(distance(cylinder, found.on_b) <= static_cast<double>(found.distance) + doubt);
  }
  CHECK(apart > 500);
}

}  // namespace

TEST_CASE("no point of a smooth volume lies beyond its support mapping, and its box is around it") {
  Random random(5);
  for (int round = 0; round < 2000; ++round) {
    const auto cylinder = any_cylinder<double, 3>(random, 1);
    const Vector<double, 3> axis = cylinder.b - cylinder.a;
    const Vector<double, 3> across = axis.cross(any_point<double, 3>(random, 1)).normalized();
    const Vector<double, 3> inner =
        cylinder.a + axis * random.between(0, 1) + across * (cylinder.radius * random.between(0, 1));
    const Vector<double, 3> way = round % 2 == 0 ? any_point<double, 3>(random, 1)
                                                 : Vector<double, 3>(axis + any_point<double, 3>(random, 1e-15));
    CHECK(way.dot(inner) <= way.dot(query::support(cylinder, way)) + 1e-15);
    const auto box = hierarchy::bounds_of(cylinder);
    CHECK((inner - box.min).minCoeff() >= -1e-15);
    CHECK((box.max - inner).minCoeff() >= -1e-15);
  }
}

TEST_CASE("the distance of a smooth volume from a point and from another") {
  check_distance<double, 3>(1);
  check_distance<double, 2>(2);
  check_distance<float, 3>(3);
  check_distance<float, 2>(4);
}

TEST_CASE("culling by a support mapping alone is never wrong") {
  check_culling<double, 3>(1);
  check_culling<double, 2>(2);
  check_culling<float, 3>(3);
  check_culling<float, 2>(4);
}
