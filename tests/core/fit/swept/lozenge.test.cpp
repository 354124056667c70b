// Lozenges: exact containment on every cloud, and as tight as their axes allow.
#include "fit/swept/lozenge_pca.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "core/point_clouds.hpp"
#include "fit/swept/certify_swept.hpp"
#include "geometry/turn.hpp"

using namespace snug;

namespace {

template <class Scalar, int Dim>
Lozenge<Scalar, Dim> checked_lozenge(const std::string& name, const test::Cloud<Scalar, Dim>& points) {
  INFO(name << ", " << points.size() << " points, dim " << Dim << ", " << sizeof(Scalar) << " bytes");
  const auto set = test::set_of<Scalar, Dim>(points);
  Recorder<fit::LozengeStep<Scalar, Dim>> recorder;
  const auto fit = fit::lozenge_pca(set.span(), recorder);
  const auto unwatched = fit::lozenge_pca(set.span());
  CHECK(unwatched.volume.origin == fit.volume.origin);
  CHECK(unwatched.volume.edges == fit.volume.edges);
  CHECK(unwatched.volume.radius == fit.volume.radius);
  CHECK(unwatched.support == fit.support);

  const auto certificate = certify(fit, set.span(), false);
  CHECK(certificate.contains);
  CHECK(certificate.max_outside == 0);
  CHECK(certificate.on_boundary);
  CHECK_FALSE(certificate.optimal.has_value());
  CHECK(!fit.support.empty());
  const auto& edges = fit.volume.edges;
  const auto length = [&](std::size_t edge) { return static_cast<double>(scaled_norm<Scalar, Dim>(edges[edge])); };
  constexpr double kSound = std::numeric_limits<Scalar>::min() / static_cast<double>(tolerance::kRoundoff<Scalar>);
  if (length(0) > kSound && length(1) > kSound) {  // perpendicular
    const Vector<double, Dim> first = edges[0].template cast<double>() / length(0);
    const Vector<double, Dim> second = edges[1].template cast<double>() / length(1);
    CHECK(std::abs(first.dot(second)) <= 16 * static_cast<double>(tolerance::kRoundoff<Scalar>));
  }
  for (const auto& entry : recorder.entries)
    REQUIRE(static_cast<std::size_t>(entry.step.line) < fit::kLozengePcaPseudocode.size());
  const auto& last = recorder.entries.back().step;
  CHECK(std::holds_alternative<fit::Finished>(last.fact));
  CHECK(last.volume.radius == fit.volume.radius);
  return fit.volume;
}

/// The corners of a box, turned about the origin and moved there.
test::Cloud<double, 3> box_corners(const Vector<double, 3>& half_extents, const Matrix<double, 3>& rotation) {
  test::Cloud<double, 3> points;
  for (int v = 0; v < 8; ++v) {
    Vector<double, 3> corner = half_extents;
    for (int i = 0; i < 3; ++i) corner[i] *= (v >> i & 1) == 0 ? -1 : 1;
    points.push_back(rotation * corner + Vector<double, 3>(1, 2, 3));
  }
  return points;
}

}  // namespace

TEST_CASE("one point is a lozenge of nothing, and an upright flat rectangle has no radius") {
  const auto point = checked_lozenge<double, 3>("one point", {{1, 2, 3}});
  CHECK(point.origin == Vector<double, 3>(1, 2, 3));
  CHECK(point.edges[0].isZero(0));
  CHECK(point.edges[1].isZero(0));
  CHECK(point.radius == 0);
  const auto flat = checked_lozenge<double, 3>("flat", {{-2, -1, 5}, {2, -1, 5}, {-2, 1, 5}, {2, 1, 5}, {0, 0, 5}});
  CHECK(flat.radius == 0);
  CHECK(flat.edges[0].norm() == 4);
  CHECK(flat.edges[1].norm() == 2);
}

TEST_CASE("around a box's corners the lozenge is the box's two long sides swept by half of its thickness") {
  Random random(1);
  for (int round = 0; round < 20; ++round) {
    const Vector<double, 3> axis(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    const auto found = checked_lozenge<double, 3>("a box", box_corners({5, 2, 0.5}, turn(axis, random.between(-3, 3))));
    CHECK(found.radius == doctest::Approx(0.5).epsilon(1e-13));
    // The corners are as high as the radius: they have no reach but the square root of rounding's.
    CHECK(found.edges[0].norm() == doctest::Approx(10).epsilon(1e-7));
    CHECK(found.edges[1].norm() == doctest::Approx(4).epsilon(1e-7));
  }
}

TEST_CASE("in the plane the radius is the largest that cuts no point off") {
  // An octagon: each corner of the box loses a right triangle of legs 1, in which a circle of radius r that touches
  // both sides passes through (1, 0) from the corner: r = 1 + 0 + sqrt(0).
  const auto octagon =
      checked_lozenge<double, 2>("octagon", {{-3, -1}, {-3, 1}, {-2, 2}, {2, 2}, {3, 1}, {3, -1}, {2, -2}, {-2, -2}});
  CHECK(octagon.radius == doctest::Approx(1).epsilon(1e-14));
  CHECK(measure(octagon) == doctest::Approx(24 - (4 - std::numbers::pi)));
  // A stadium's outline gives the whole stadium.
  test::Cloud<double, 2> outline;
  for (int i = 0; i <= 40; ++i) {
    const auto [sine, cosine] = sine_cosine((i - 20) * std::numbers::pi / 40);
    outline.push_back({2 + cosine, sine});
    outline.push_back({-2 - cosine, -sine});
  }
  const auto stadium = checked_lozenge<double, 2>("stadium", outline);
  CHECK(stadium.radius == doctest::Approx(1).epsilon(1e-12));
  CHECK(measure(stadium) == doctest::Approx(std::numbers::pi + 8).epsilon(1e-9));
  // A square's corners cannot be rounded at all.
  CHECK(checked_lozenge<double, 2>("square", {{0, 0}, {1, 0}, {0, 1}, {1, 1}}).radius < 1e-14);
}

TEST_CASE("a lozenge in the plane moves no corner") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const char* kind : {"cube", "ball", "gaussian", "sphere"}) {
      const auto set = test::set_of<double, 2>(test::generated<double, 2>(kind, 200, seed));
      Recorder<fit::LozengeStep<double, 2>> recorder;
      fit::lozenge_pca(set.span(), recorder);
      for (const auto& entry : recorder.entries)
        CHECK_FALSE(std::holds_alternative<fit::CornerMovedOut>(entry.step.fact));
    }
}

TEST_CASE("pulling the sides in makes the lozenge smaller, and each kind of step happens") {
  std::set<std::size_t> kinds;
  int smaller = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto set = test::set_of<double, 3>(test::generated<double, 3>("ball", 100, seed));
    Recorder<fit::LozengeStep<double, 3>> recorder;
    fit::lozenge_pca(set.span(), recorder);
    double loose = 0, corners = 0;
    for (const auto& entry : recorder.entries) {
      kinds.insert(entry.step.fact.index());
      const double now = measure(entry.step.volume);
      if (std::holds_alternative<fit::ThicknessFound>(entry.step.fact)) loose = now;
      if (const auto* moved = std::get_if<fit::CornerMovedOut>(&entry.step.fact)) {
        CHECK(moved->along_first + moved->along_second > 0);
        CHECK(now > corners);
      }
      corners = now;
    }
    smaller += corners < 0.7 * loose ? 1 : 0;
  }
  CHECK(kinds.size() == std::variant_size_v<fit::LozengeStep<double, 3>::Fact>);
  CHECK(smaller == 20);
}

TEST_CASE("a lozenge that leaves a point out by one digit has no certificate") {
  const auto set = test::set_of<double, 3>(test::generated<double, 3>("ball", 50, 7));
  auto fit = fit::lozenge_pca(set.span());
  CHECK(certify(fit, set.span(), false).contains);
  fit.volume.radius *= 1 - 1e-14;
  const auto certificate = certify(fit, set.span(), true);
  CHECK_FALSE(certificate.contains);
  CHECK(certificate.max_outside > 0);
  CHECK(certificate.optimal == false);
}
