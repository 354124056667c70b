// The axis-aligned box: exact, and optimal by its certificate.
#include "fit/aabb_min_max.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "core/point_clouds.hpp"
#include "fit/certify_shapes.hpp"

using namespace snug;

namespace {

template <class Scalar, int Dim>
void check_promises(const std::string& name, const test::Cloud<Scalar, Dim>& points) {
  INFO(name << ", " << points.size() << " points, dim " << Dim << ", " << sizeof(Scalar) << " bytes");
  const auto set = test::set_of<Scalar, Dim>(points);
  Recorder<fit::AabbStep<Scalar, Dim>> recorder;
  const auto fit = fit::aabb_min_max(set.span(), recorder);
  const auto unwatched = fit::aabb_min_max(set.span());
  CHECK(unwatched.volume.min == fit.volume.min);
  CHECK(unwatched.volume.max == fit.volume.max);
  CHECK(unwatched.support == fit.support);

  const auto certificate = certify(fit, set.span(), true);
  CHECK(certificate.contains);
  CHECK(certificate.max_outside == 0);
  CHECK(certificate.on_boundary);
  CHECK(certificate.optimal == true);
  CHECK(fit.support.size() <= 2 * Dim);

  const auto& last = recorder.entries.back().step;
  CHECK(std::holds_alternative<fit::Finished>(last.fact));
  CHECK(last.volume.min == fit.volume.min);
  for (const auto& entry : recorder.entries) {
    REQUIRE(static_cast<std::size_t>(entry.step.line) < fit::kAabbMinMaxPseudocode.size());
    CHECK(entry.step.has_volume);
  }
}

}  // namespace

TEST_CASE_TEMPLATE("the box keeps its promises on degenerate clouds", Scalar, float, double) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    for (const int n : {1, 2, 7, 60}) {
      for (const auto& [name, points] : test::degenerate_clouds<Scalar, 2>(seed, n))
        check_promises<Scalar, 2>(name, points);
      for (const auto& [name, points] : test::degenerate_clouds<Scalar, 3>(seed, n))
        check_promises<Scalar, 3>(name, points);
    }
}

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
