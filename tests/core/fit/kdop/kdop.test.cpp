// k-DOPs: their bounds against rational arithmetic, and what they come to beside the box.
#include "fit/kdop/kdop_fit.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "core/exact.hpp"
#include "core/point_clouds.hpp"
#include "fit/aabb/aabb_min_max.hpp"
#include "fit/kdop/certify_kdop.hpp"
#include "geometry/kdop_measure.hpp"

using namespace snug;
using exact::Rational;

namespace {

template <class Scalar, int Dim>
Rational along(const std::array<int, Dim>& axis, const Vector<Scalar, Dim>& p) {
  Rational sum = 0;
  for (std::size_t i = 0; i < Dim; ++i) sum += axis[i] * Rational(static_cast<double>(p[static_cast<int>(i)]));
  return sum;
}

}  // namespace

TEST_CASE_TEMPLATE("a k-DOP's bounds are the exact projections, rounded outwards", Scalar, float, double) {
  constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();
  int rounded = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    for (const auto& cloud : test::degenerate_clouds<Scalar, 3>(seed, 25)) {
      CAPTURE(cloud.name);
      const auto& points = cloud.points;
      const auto set = test::set_of<Scalar, 3>(points);
      const auto kdop = fit::kdop_fit(set.span(), 26).volume;
      const auto axes = kdop_axes<3>(26);
      for (std::size_t i = 0; i < axes.size(); ++i) {
        Rational least = along<Scalar, 3>(axes[i], points[0]), greatest = least;
        for (const auto& p : points) {
          const Rational here = along<Scalar, 3>(axes[i], p);
          least = std::min(least, here), greatest = std::max(greatest, here);
        }
        const auto exactly = [](Scalar value) { return Rational(static_cast<double>(value)); };
        CHECK(exactly(kdop.min[i]) <= least);
        CHECK(exactly(std::nextafter(kdop.min[i], kInfinity)) > least);
        CHECK(exactly(kdop.max[i]) >= greatest);
        CHECK(exactly(std::nextafter(kdop.max[i], -kInfinity)) < greatest);
        rounded += exactly(kdop.max[i]) != greatest ? 1 : 0;
      }
    }
  CHECK(rounded > 100);
}

TEST_CASE("a k-DOP of the coordinate axes is the box, and more slabs only take away") {
  for (const char* kind : {"ball", "stick", "clusters", "cube"}) {
    const auto set = test::set_of<double, 3>(test::generated<double, 3>(kind, 400, 5));
    const auto box = fit::aabb_min_max(set.span()).volume;
    const auto six = fit::kdop_fit(set.span(), 6).volume;
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(six.min[i] == box.min[static_cast<int>(i)]);
      CHECK(six.max[i] == box.max[static_cast<int>(i)]);
    }
    CHECK(measure(six) == doctest::Approx(measure(box)).epsilon(1e-14));
    const auto measure_of_k = [&](int k) { return measure(fit::kdop_fit(set.span(), k).volume); };
    const double fourteen = measure_of_k(14), eighteen = measure_of_k(18), twenty_six = measure_of_k(26);
    CHECK(fourteen < measure(box));
    CHECK(eighteen < measure(box));
    CHECK(twenty_six < std::min(fourteen, eighteen));
  }
}

TEST_CASE("a triangle's 8-DOP is known") {
  const auto set = test::set_of<double, 2>({{0, 0}, {4, 0}, {0, 4}});
  const auto kdop = fit::kdop_fit(set.span(), 8).volume;
  CHECK(kdop.max[2] == 4);  // x + y, the hypotenuse
  CHECK(kdop.min[2] == 0);
  CHECK(kdop.max[3] == 4);
  CHECK(kdop.min[3] == -4);
  CHECK(measure(kdop) == 8);  // the triangle itself
}

TEST_CASE("a k-DOP that leaves a point out, or a bound loose, has no certificate for it") {
  const auto set = test::set_of<double, 2>({{0, 0}, {1, 2}, {0.1, 0.7}});
  auto fit = fit::kdop_fit(set.span(), 8);
  REQUIRE(certify(fit, set.span(), true).optimal == true);
  const double bound = fit.volume.max[2];
  fit.volume.max[2] = std::nextafter(bound, 0.0);
  CHECK_FALSE(certify(fit, set.span(), true).contains);
  CHECK(certify(fit, set.span(), true).outside == 1);
  fit.volume.max[2] = std::nextafter(bound, 9.0);
  CHECK(certify(fit, set.span(), true).contains);
  CHECK(certify(fit, set.span(), true).optimal == false);
}
