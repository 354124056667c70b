// What the lesson on swept spheres says of cylinders: how many simplices GJK takes for two of them, and for two
// capsules on the same axes, and how many operations their support mappings take on the way.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "core/lesson/lesson_files.hpp"
#include "geometry/capsule.hpp"
#include "geometry/cylinder.hpp"
#include "geometry/random.hpp"
#include "query/distance/gjk.hpp"

namespace snug {

/// A cylinder whose support mapping counts what it takes: an axis of length 1, and twice across it.
template <class Scalar, int Dim>
struct CountedCylinder : Cylinder<Scalar, Dim> {};

struct CylinderWork {
  std::int64_t dot_products = 0, square_roots = 0;
};
static CylinderWork cylinder_work;

template <class Scalar, int Dim>
[[nodiscard]] Vector<double, Dim> core_support(const CountedCylinder<Scalar, Dim>& cylinder,
                                               const Vector<Scalar, Dim>& origin,
                                               const Vector<double, Dim>& direction) {
  cylinder_work.dot_products += 4, cylinder_work.square_roots += 2;
  return core_support(static_cast<const Cylinder<Scalar, Dim>&>(cylinder), origin, direction);
}

}  // namespace snug

using namespace snug;

namespace {

constexpr int kPairs = 1000;

struct Axes {
  std::array<Vector<double, 3>, 4> ends;
  std::array<double, 2> radii;
};

Axes any_axes(Random& random) {
  Axes axes;
  for (std::size_t i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j) axes.ends[i][j] = random.between(-1, 1) + (i < 2 || j > 0 ? 0.0 : 2.0);
  for (double& radius : axes.radii) radius = random.between(0.1, 0.5);
  return axes;
}

template <template <class, int> class Kind>
int simplices(const Axes& axes) {
  const auto& [a, b, c, d] = axes.ends;
  Kind<double, 3> one, other;
  one.a = a, one.b = b, one.radius = axes.radii[0];
  other.a = c, other.b = d, other.radius = axes.radii[1];
  return query::gjk(one, other)->turns;
}

/// The dot products of the support mappings: GJK reports one for each end that a capsule's core has to compare.
std::int64_t dot_products(const Axes& axes) {
  const auto& [a, b, c, d] = axes.ends;
  Counter counter;
  const auto found =
      query::gjk(Capsule<double, 3>{a, b, axes.radii[0]}, Capsule<double, 3>{c, d, axes.radii[1]}, false, counter);
  REQUIRE(found.has_value());
  return counter.counts[static_cast<std::size_t>(Operation::kDotProducts)];
}

/// The mean of that sum with one decimal, as the prose has it.
std::string mean_text(std::int64_t sum) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f", static_cast<double>(sum) / kPairs);
  return text.data();
}

}  // namespace

TEST_CASE("GJK takes as many simplices for two cylinders and for two capsules as the lesson says") {
  Random random(1);
  std::int64_t cylinders = 0, capsules = 0, capsule_dots = 0;
  cylinder_work = {};
  for (int i = 0; i < kPairs; ++i) {
    const Axes axes = any_axes(random);
    cylinders += simplices<CountedCylinder>(axes), capsules += simplices<Capsule>(axes);
    capsule_dots += dot_products(axes);
  }
  CHECK(cylinders > 2 * capsules);
  const std::string lesson = test::lessons_file("swept-volumes.toml");
  CAPTURE(mean_text(cylinders));
  CAPTURE(mean_text(capsules));
  CHECK(lesson.find("| cylinders | " + mean_text(cylinders) + " |") != std::string::npos);
  CHECK(lesson.find("| capsules | " + mean_text(capsules) + " |") != std::string::npos);
  const std::string roots = mean_text(cylinder_work.square_roots), dots = mean_text(cylinder_work.dot_products);
  CAPTURE(roots);
  CAPTURE(dots);
  CAPTURE(mean_text(capsule_dots));
  CHECK(lesson.find("| capsules | " + mean_text(capsules) + " | " + mean_text(capsule_dots) + " | 0 |") !=
        std::string::npos);
  CHECK(lesson.find("| cylinders | " + mean_text(cylinders) + " | " + dots + " | " + roots + " |") !=
        std::string::npos);
}
