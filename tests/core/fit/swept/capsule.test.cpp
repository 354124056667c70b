// Capsules: exact containment on every cloud, and as tight as their axis allows.
#include "fit/swept/capsule_pca.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <set>

#include "core/point_clouds.hpp"
#include "fit/swept/certify_swept.hpp"
#include "geometry/turn.hpp"

using namespace snug;

namespace {

template <class Scalar, int Dim>
Capsule<Scalar, Dim> checked_capsule(const std::string& name, const test::Cloud<Scalar, Dim>& points) {
  INFO(name << ", " << points.size() << " points, dim " << Dim << ", " << sizeof(Scalar) << " bytes");
  const auto set = test::set_of<Scalar, Dim>(points);
  Recorder<fit::CapsuleStep<Scalar, Dim>> recorder;
  const auto fit = fit::capsule_pca(set.span(), {}, recorder);
  const auto unwatched = fit::capsule_pca(set.span(), {});
  CHECK(unwatched.volume.a == fit.volume.a);
  CHECK(unwatched.volume.b == fit.volume.b);
  CHECK(unwatched.volume.radius == fit.volume.radius);
  CHECK(unwatched.support == fit.support);

  const auto certificate = certify(fit, set.span(), false);
  CHECK(certificate.contains);
  CHECK(certificate.max_outside == 0);
  CHECK(certificate.on_boundary);
  CHECK_FALSE(certificate.optimal.has_value());
  CHECK(!fit.support.empty());
  CHECK(fit.support.size() <= Dim + 2);

  for (const auto& entry : recorder.entries)
    REQUIRE(static_cast<std::size_t>(entry.step.line) < fit::kCapsulePcaPseudocode.size());
  const auto& last = recorder.entries.back().step;
  CHECK(std::holds_alternative<fit::Finished>(last.fact));
  CHECK(last.volume.radius == fit.volume.radius);
  return fit.volume;
}

/// Points on the surface of a capsule, its caps and its sides alike, with those that say how long it is.
test::Cloud<double, 3> on_capsule(const Capsule<double, 3>& capsule, int n, std::uint64_t seed) {
  Random random(seed);
  const Vector<double, 3> axis = (capsule.b - capsule.a).normalized();
  test::Cloud<double, 3> points{capsule.a - axis * capsule.radius, capsule.b + axis * capsule.radius};
  const auto directions = test::generated<double, 3>("sphere", n, seed);
  for (const auto& direction : directions) {
    const double along = direction.dot(axis);
    const Vector<double, 3> across = (direction - along * axis).normalized();
    if (random.below(2) == 0) points.push_back((along < 0 ? capsule.a : capsule.b) + capsule.radius * direction);
    else points.push_back(capsule.a + random.unit() * (capsule.b - capsule.a) + capsule.radius * across);
  }
  return points;
}

}  // namespace

TEST_CASE("one point is a capsule of radius zero, and points on an upright line have none either") {
  const auto point = checked_capsule<double, 3>("one point", {{1, 2, 3}});
  CHECK(point.a == Vector<double, 3>(1, 2, 3));
  CHECK(point.a == point.b);
  CHECK(point.radius == 0);
  const auto line = checked_capsule<double, 3>("a line", {{1, 2, 3}, {1, 2, 8}, {1, 2, 4}, {1, 2, 5}});
  CHECK(line.radius == 0);
  CHECK(std::abs(line.b[2] - line.a[2]) == 5);
}

TEST_CASE("points on a tilted line have a radius of no more than rounding") {
  const auto capsule = checked_capsule<double, 3>("tilted", test::generated<double, 3>("line", 200, 3));
  CHECK(capsule.radius < 1e-15);
  CHECK((capsule.b - capsule.a).norm() > 1.9);
}

TEST_CASE("a capsule is found again from points on its surface") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    const Matrix<double, 3> turned = turn({random.between(-1, 1), random.between(-1, 1), 1}, random.between(-3, 3));
    const Capsule<double, 3> right{turned * Vector<double, 3>(-3, 0, 0), turned * Vector<double, 3>(3, 0, 0), 1};
    const auto found = checked_capsule<double, 3>("on a capsule", on_capsule(right, 5000, seed));
    // Its axis is the sample's, not the capsule's: a few parts in a hundred.
    CHECK(measure(found) == doctest::Approx(measure(right)).epsilon(0.1));
    CHECK(measure(found) > measure(right) * 0.98);
  }
}

TEST_CASE("along the true axis the capsule is the smallest: a symmetric sample gives it back to the last digits") {
  test::Cloud<double, 3> points;
  for (const double x : {-3.0, 3.0})
    for (const double s : {-1.0, 1.0}) {
      points.push_back({x, s, 0});
      points.push_back({x, 0, s});
      points.push_back({x + (x > 0 ? 0.6 : -0.6), 0.8 * s, 0});
      points.push_back({x + (x > 0 ? 0.6 : -0.6), 0, 0.8 * s});
    }
  points.push_back({4, 0, 0});
  points.push_back({-4, 0, 0});
  const auto found = checked_capsule<double, 3>("symmetric", points);
  CHECK(found.radius == doctest::Approx(1).epsilon(1e-15));
  CHECK((found.b - found.a).norm() == doctest::Approx(6).epsilon(1e-15));
}

TEST_CASE("pulling the ends in makes the capsule smaller, and each kind of step happens") {
  const auto set = test::set_of<double, 3>(test::generated<double, 3>("stick", 300, 3));
  Recorder<fit::CapsuleStep<double, 3>> recorder;
  fit::capsule_pca(set.span(), {}, recorder);
  std::set<std::size_t> kinds;
  double loose = 0;
  for (const auto& entry : recorder.entries) {
    kinds.insert(entry.step.fact.index());
    if (std::holds_alternative<fit::LineFound>(entry.step.fact)) loose = measure(entry.step.volume);
    if (const auto* pulled = std::get_if<fit::EndPulledIn>(&entry.step.fact)) CHECK(pulled->by > 0);
  }
  CHECK(kinds.size() == std::variant_size_v<fit::CapsuleStep<double, 3>::Fact>);
  CHECK(measure(recorder.entries.back().step.volume) < 0.97 * loose);
}

TEST_CASE("a capsule that leaves a point out by one digit has no certificate") {
  const auto set = test::set_of<double, 2>({{0, 0}, {4, 1}, {1, 2}});
  auto fit = fit::capsule_pca(set.span(), {});
  CHECK(certify(fit, set.span(), false).contains);
  fit.volume.radius *= 1 - 1e-15;
  const auto certificate = certify(fit, set.span(), true);
  CHECK_FALSE(certificate.contains);
  CHECK(certificate.max_outside > 0);
  CHECK(certificate.on_boundary);  // within rounding still
  CHECK(certificate.optimal == false);
  fit.volume.radius *= 1 + 1e-9;
  CHECK_FALSE(certify(fit, set.span(), false).on_boundary);
}
