// The rectangle of least area against every edge tried in rational arithmetic, and rectangles that are known.
#include "fit/obb/min_area_rectangle.hpp"

#include <doctest/doctest.h>

#include "core/exact.hpp"
#include "core/point_clouds.hpp"
#include "fit/hull/quickhull.hpp"
#include "query/contain/contains.hpp"

using namespace snug;
using exact::Rational;

namespace {

template <class Scalar>
ConvexHull<Scalar, 2> polygon_of(const test::Cloud<Scalar, 2>& cloud) {
  return fit::quickhull(test::set_of<Scalar, 2>(cloud).span()).volume;
}

/// The least area of a rectangle on an edge of the hull, by every edge against every vertex.
template <class Scalar>
Rational least_area(const ConvexHull<Scalar, 2>& hull) {
  const auto at = [&](Index i, int axis) { return Rational(static_cast<double>(hull.vertices[i][axis])); };
  std::optional<Rational> least;
  for (const auto& [a, b] : hull.facets) {
    const Rational x = at(b, 0) - at(a, 0), y = at(b, 1) - at(a, 1);
    Rational back = 0, forth = 0, height = 0;
    for (Index i = 0; i < static_cast<Index>(hull.vertices.size()); ++i) {
      const Rational dx = at(i, 0) - at(a, 0), dy = at(i, 1) - at(a, 1);
      const Rational along = dx * x + dy * y, across = dy * x - dx * y;
      if (along < back) back = along;
      if (along > forth) forth = along;
      if (across > height) height = across;
    }
    const Rational area = (forth - back) * height / (x * x + y * y);
    if (!least || area < *least) least = area;
  }
  return *least;
}

template <class Scalar>
void check_rectangle(const std::string& name, const test::Cloud<Scalar, 2>& cloud) {
  INFO(name << ", " << cloud.size() << " points, " << sizeof(Scalar) << " bytes");
  const auto hull = polygon_of(cloud);
  const auto box = fit::min_area_rectangle(hull);
  for (const auto& p : cloud) CHECK(query::contains(box, p));
  if (hull.affine_dim == 0) CHECK(box.half_extents.isZero(0));
  if (hull.affine_dim < 2) return;

  // The calipers' own areas are good to nearly all digits of a double ...
  Ignore ignore;
  fit::Calipers<Scalar, Ignore> calipers(hull, ignore);
  const auto best = calipers.run();
  const Rational least = least_area(hull);
  Vector<Scalar, 2> low = hull.vertices[0], high = low;
  for (const auto& v : hull.vertices) low = low.cwiseMin(v), high = high.cwiseMax(v);
  double widest = 0;
  for (const auto& v : hull.vertices)
    widest = std::max(widest, static_cast<double>((v - hull.vertices[0]).cwiseAbs().maxCoeff()));
  const Rational unit(std::ldexp(1.0, std::ilogb(widest)));
  CHECK(abs(Rational(best.area) * unit * unit / least - 1) < Rational(0x1p-48));

  // ... and the box is rounded to Scalars: its axes, so that it tilts and a side widens by roundoffs of the other, and
  // its centre, which moves by roundoffs of the coordinates.
  const Scalar farthest_out = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  const double reach = 4 * widest + static_cast<double>(farthest_out);
  const Rational slack = Rational(16 * static_cast<double>(tolerance::kRoundoff<Scalar>)) * Rational(reach);
  const Rational width = 2 * Rational(static_cast<double>(box.half_extents[0]));
  const Rational height = 2 * Rational(static_cast<double>(box.half_extents[1]));
  CHECK(width * height <= least + slack * (width + height));
}

}  // namespace

TEST_CASE_TEMPLATE("degenerate clouds have the rectangle that rational arithmetic finds", Scalar, float, double) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    for (const int n : {1, 2, 3, 5, 12, 40})
      for (const auto& [name, points] : test::degenerate_clouds<Scalar, 2>(seed, n))
        check_rectangle<Scalar>(name, points);
}

TEST_CASE_TEMPLATE("random clouds have the rectangle that rational arithmetic finds", Scalar, float, double) {
  for (const char* kind : {"cube", "ball", "sphere", "gaussian", "stick", "lattice"})
    for (const int n : {10, 60})
      for (std::uint64_t seed = 1; seed <= 3; ++seed)
        check_rectangle<Scalar>(kind, test::generated<Scalar, 2>(kind, n, seed));
}

TEST_CASE("far, tiny and huge clouds have it too") {
  for (const double scale : {1e-150, 1e-75, 1.0, 1e75, 1e150})
    for (const char* kind : {"cube", "sphere", "stick"})
      check_rectangle<double>(kind, test::generated<double, 2>(kind, 30, 5, scale));
  for (const char* kind : {"cube", "sphere", "stick"})
    check_rectangle<double>(kind, test::generated<double, 2>(kind, 30, 5, 1, 1e8));
}

TEST_CASE("a turned rectangle is found as it was made") {
  Random random(3);
  for (int turn = 0; turn < 50; ++turn) {
    // A Pythagorean direction, so that corners are exact: (m^2 - k^2, 2 m k) / (m^2 + k^2).
    const double m = 2 + random.below(20), k = 1 + random.below(static_cast<std::uint32_t>(m) - 1);
    const Vector<double, 2> u(m * m - k * k, 2 * m * k), v(-u[1], u[0]);
    const double w = 1 + random.below(50), h = 1 + random.below(50);
    test::Cloud<double, 2> cloud{{0, 0}, w * u, w * u + h * v, h * v};
    for (int i = 0; i < 20; ++i) cloud.push_back(random.below(64) / 64.0 * w * u + random.below(64) / 64.0 * h * v);
    const auto box = fit::min_area_rectangle(polygon_of<double>(cloud));
    CHECK(measure(box) == doctest::Approx(w * h * u.squaredNorm()).epsilon(1e-14));
    CHECK(box.axes(0, 0) * box.axes(1, 1) - box.axes(0, 1) * box.axes(1, 0) == doctest::Approx(1).epsilon(1e-15));
  }
}

TEST_CASE("points on a line give a flat box along it, and points in one place a box without extent") {
  const auto line = fit::min_area_rectangle(polygon_of<double>({{0, 0}, {3, 4}, {6, 8}, {1.5, 2}}));
  CHECK(line.half_extents[0] == doctest::Approx(5).epsilon(1e-15));
  CHECK(line.half_extents[1] < 1e-15);
  const auto place = fit::min_area_rectangle(polygon_of<double>({{7, 8}, {7, 8}}));
  CHECK(place.center == Vector<double, 2>(7, 8));
  CHECK(place.half_extents.isZero(0));
}

TEST_CASE("its steps try every edge once, and end with the result") {
  using Step = fit::ObbStep<double, 2>;
  const auto hull = polygon_of<double>(test::generated<double, 2>("gaussian", 200, 4));
  Recorder<Step> recorder;
  const auto box = fit::min_area_rectangle(hull, recorder);
  CHECK(recorder.entries.size() == hull.vertices.size() + 1);
  double best = std::numeric_limits<double>::infinity();
  int better = 0;
  for (const auto& entry : recorder.entries) {
    const auto* tried = std::get_if<fit::BoxTried<double, 2>>(&entry.step.fact);
    if (tried == nullptr) continue;
    CHECK(tried->on.size() >= 3);
    better += tried->better;
    if (tried->better) CHECK(tried->measure < best * (1 + 1e-14));
    best = std::min(best, tried->measure);
  }
  CHECK(better >= 2);
  CHECK(measure(box) == doctest::Approx(best).epsilon(1e-14));
  CHECK(std::holds_alternative<fit::Finished>(recorder.entries.back().step.fact));
  CHECK(recorder.entries.back().step.volume.center == box.center);
}
