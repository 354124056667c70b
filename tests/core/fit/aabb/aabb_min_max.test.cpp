// The axis-aligned box: exact, and optimal by its certificate.
#include "fit/aabb/aabb_min_max.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "core/point_clouds.hpp"
#include "fit/aabb/certify_aabb.hpp"

using namespace snug;

TEST_CASE("the box of a few known points, and who holds it") {
  const auto set = test::set_of<double, 2>({{0, 0}, {3, -1}, {1, 4}, {3, 4}});
  const auto fit = fit::aabb_min_max(set.span());
  CHECK(fit.volume.min == Vector<double, 2>(0, -1));
  CHECK(fit.volume.max == Vector<double, 2>(3, 4));
  CHECK(fit.support == std::vector<Index>{0, 1, 2});  // of equals the first
}

TEST_CASE("a box a number too small or too large has no certificate for it") {
  const auto set = test::set_of<double, 2>({{0, 0}, {1, 2}});
  auto fit = fit::aabb_min_max(set.span());
  fit.volume.max[1] = std::nextafter(2.0, 1.0);
  auto certificate = certify(fit, set.span(), true);
  CHECK_FALSE(certificate.contains);
  CHECK(certificate.outside == 1);
  CHECK(certificate.max_outside == 2 - fit.volume.max[1]);
  CHECK(certificate.optimal == false);
  fit.volume.max[1] = std::nextafter(2.0, 3.0);
  certificate = certify(fit, set.span(), true);
  CHECK(certificate.contains);
  CHECK(certificate.optimal == false);
  CHECK_FALSE(certify(fit, set.span(), false).optimal.has_value());
}
