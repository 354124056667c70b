// A ray against a box, held to rational arithmetic.
#include "query/overlap/ray_aabb.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "core/exact.hpp"
#include "geometry/random.hpp"

using namespace snug;
using exact::Rational;

namespace {

/// Where the ray truly enters; none where it misses. widened: by how much of t the last slab is held open.
template <class Scalar, int Dim>
std::optional<Rational> enters_exactly(const Aabb<Scalar, Dim>& box, const Ray<Scalar, Dim>& ray,
                                       const Rational& widened = 0) {
  const auto exactly = [](Scalar value) { return Rational(static_cast<double>(value)); };
  Rational enter = 0;
  std::optional<Rational> leave;
  for (int i = 0; i < Dim; ++i) {
    const Rational o = exactly(ray.origin[i]), d = exactly(ray.direction[i]);
    const Rational low = exactly(box.min[i]) - o, high = exactly(box.max[i]) - o;
    if (d == 0) {
      if (low > 0 || high < 0) return std::nullopt;
      continue;
    }
    const Rational first = low / d, second = high / d;
    enter = std::max(enter, std::min(first, second));
    const Rational last = std::max(first, second);
    if (!leave || last < *leave) leave = last;
  }
  if (leave && (*leave < 0 || enter > *leave * (1 + widened))) return std::nullopt;
  return enter;
}

template <class Scalar, int Dim>
void check_ray(const Aabb<Scalar, Dim>& box, const Ray<Scalar, Dim>& ray, int& hits, int& misses) {
  const auto exactly = enters_exactly(box, ray);
  const auto found = query::ray_enters(box, ray);
  if (exactly) {
    ++hits;
    REQUIRE(found);
    const double error = std::abs(static_cast<double>(Rational(static_cast<double>(*found)) - *exactly));
    CHECK(error <= static_cast<double>(tolerance::kRaySlab<Scalar>) * static_cast<double>(*exactly));
  } else {
    ++misses;
    if (found) CHECK(enters_exactly(box, ray, Rational(2 * static_cast<double>(tolerance::kRaySlab<Scalar>))));
  }
}

template <class Scalar, int Dim>
void check_random() {
  Random random(Dim);
  const auto any = [&](double size) {
    Vector<Scalar, Dim> v;
    for (int i = 0; i < Dim; ++i) v[i] = static_cast<Scalar>(random.between(-size, size));
    return v;
  };
  int hits = 0, misses = 0, grazing_misses = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vector<Scalar, Dim> a = any(1), b = any(1);
    const Aabb<Scalar, Dim> box{a.cwiseMin(b), a.cwiseMax(b)};
    Ray<Scalar, Dim> ray{any(2), any(1)};
    if (i % 3 == 0) ray.direction[i % Dim] = 0;
    if (i % 4 == 0) ray.origin[i % Dim] = box.min[i % Dim];
    check_ray(box, ray, hits, misses);
    // Towards a corner, an edge or a face's border, and an ulp beside it.
    Vector<Scalar, Dim> corner = box.min;
    for (int k = 0; k < Dim; ++k)
      if (random.below(2) == 1) corner[k] = box.max[k];
    ray.direction = corner - ray.origin;
    if (ray.direction.isZero(0)) continue;
    check_ray(box, ray, hits, grazing_misses);
    const int axis = static_cast<int>(random.below(Dim));
    ray.direction[axis] = std::nextafter(ray.direction[axis], static_cast<Scalar>(random.between(-9, 9)));
    check_ray(box, ray, hits, grazing_misses);
  }
  CHECK(hits > 1000);
  CHECK(misses > 1000);
  CHECK(grazing_misses > 500);
}

}  // namespace

TEST_CASE_TEMPLATE("a ray never misses a box that it touches", Scalar, float, double) {
  check_random<Scalar, 2>();
  check_random<Scalar, 3>();
}

TEST_CASE("a ray that begins in a box enters it at once, and one that points away never") {
  const Aabb<double, 3> box{{0, 0, 0}, {1, 2, 3}};
  CHECK(query::ray_enters(box, Ray<double, 3>{{0.5, 1, 1}, {1, 1, 1}}) == 0.0);
  CHECK(query::ray_enters(box, Ray<double, 3>{{1, 2, 3}, {1, 1, 1}}) == 0.0);
  CHECK(query::ray_enters(box, Ray<double, 3>{{-2, 1, 1}, {0.5, 0, 0}}) == 4.0);
  CHECK(!query::ray_enters(box, Ray<double, 3>{{-2, 1, 1}, {-1, 0, 0}}));
  CHECK(!query::ray_enters(box, Ray<double, 3>{{-2, 2.5, 1}, {1, 0, 0}}));
  const Aabb<double, 3> point{{1, 1, 1}, {1, 1, 1}};
  CHECK(query::ray_enters(point, Ray<double, 3>{{0, 0, 0}, {3, 3, 3}}) == doctest::Approx(1.0 / 3));
  CHECK(query::ray_enters(point, Ray<double, 3>{{1, 1, 1}, {0, 0, 1}}) == 0.0);
}

TEST_CASE_TEMPLATE("a box in another is entered no sooner", Scalar, float, double) {
  Random random(9);
  int hits = 0;
  for (int i = 0; i < 100'000; ++i) {
    const auto any = [&] {
      return Vector<Scalar, 3>(static_cast<Scalar>(random.normal()), static_cast<Scalar>(random.normal()),
                               static_cast<Scalar>(random.normal()));
    };
    const Vector<Scalar, 3> a = any(), b = any(), c = any();
    const Aabb<Scalar, 3> inner{a.cwiseMin(b), a.cwiseMax(b)}, outer{inner.min.cwiseMin(c), inner.max.cwiseMax(c)};
    const Ray<Scalar, 3> ray{any() * Scalar(3), any()};
    const auto of_inner = query::ray_enters(inner, ray), of_outer = query::ray_enters(outer, ray);
    if (!of_inner) continue;
    ++hits;
    REQUIRE(of_outer);
    REQUIRE(*of_outer <= *of_inner);
  }
  CHECK(hits > 1000);
}
