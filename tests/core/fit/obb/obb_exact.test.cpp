// The smallest box against oracles that share nothing with it: rational arithmetic, known shapes, and blind search.
#include "fit/obb/obb_exact.hpp"

#include <doctest/doctest.h>

#include "core/at_random.hpp"
#include "core/exact.hpp"
#include "core/point_clouds.hpp"
#include "fit/obb/certify_obb.hpp"
#include "fit/obb/obb_sphere_axis.hpp"
#include "geometry/turn.hpp"

using namespace snug;

namespace {

using Cloud = test::Cloud<double, 3>;

double measure_on(const Matrix<double, 3>& axes, const Cloud& cloud) {
  const fit::LocalBox<3> box(axes, cloud);
  return (box.greatest - box.least).prod();
}

/// The smallest box that turning at random and then ever finer about its own axes comes upon: no proof, but a rival.
double smallest_by_search(const Cloud& cloud, int starts, Random& random) {
  double best = std::numeric_limits<double>::infinity();
  for (int start = 0; start < starts; ++start) {
    Matrix<double, 3> axes = fit::frame(test::any_direction(random), test::any_direction(random));
    double here = measure_on(axes, cloud);
    for (double step = 0.5; step > 1e-9; step /= 1.5)
      for (bool better = true; better;) {
        better = false;
        for (int about = 0; about < 6; ++about) {
          const Matrix<double, 3> turned = turn(axes.col(about / 2), about % 2 == 0 ? step : -step) * axes;
          const double there = measure_on(turned, cloud);
          if (!(there < here * (1 - 1e-13))) continue;
          here = there;
          axes = orthonormal<double, 3>(turned);
          better = true;
        }
      }
    best = std::min(best, here);
  }
  return best;
}

void check_smallest(const std::string& name, const Cloud& cloud, int starts, Random& random) {
  INFO(name << ", " << cloud.size() << " points");
  const auto set = test::set_of<double, 3>(cloud);
  const fit::Fit<Obb<double, 3>> found = fit::obb_exact(set.span());
  const fit::Certificate certificate = fit::certify(found, set.span(), true);
  CHECK(certificate.optimal == true);
  CHECK(certificate.lower_bound <= measure(found.volume));
  const double rival = smallest_by_search(cloud, starts, random);
  CHECK(measure(found.volume) <= rival * (1 + 1e-12));
  CHECK(certificate.lower_bound <= rival * (1 + 1e-13));
  if (fit::quickhull(set.span()).volume.affine_dim == 3)
    CHECK(fit::on_edges<3>(fit::contacts(found.volume, set.span())));
}

/// A prism over a regular polygon, twisted if wanted.
Cloud prism(int sides, double height, double twist) {
  Cloud cloud;
  for (int i = 0; i < sides; ++i)
    for (const double z : {0.0, height}) {
      const SineCosine at = sine_cosine(i * 2 * 3.141592653589793 / sides + (z > 0 ? twist : 0));
      cloud.push_back({at.cosine, at.sine, z});
    }
  return cloud;
}

}  // namespace

TEST_CASE("around a sliver the smallest box is as flat as the sliver") {
  Random random(4);
  check_smallest("found by fuzzing",
                 {{0x1p-12, -0x1p-12, -0x1p-24}, {-0x1p-24, -0x1p-24, -0x1.0000000000001p-24}, {-4, -4, -4}}, 0,
                 random);
  for (int k = 4; k <= 50; ++k)
    for (int turned = 0; turned < 20; ++turned) {
      const Cloud cloud{4 * test::any_direction(random), 4 * test::any_direction(random)};
      const Vector<double, 3> beside = cloud[0] + 0.3 * (cloud[1] - cloud[0]);
      check_smallest("at random", {cloud[0], cloud[1], beside + std::ldexp(1, -k) * test::any_direction(random)}, 0,
                     random);
    }
}

TEST_CASE("the smallest box is proven so, and no search finds a smaller one") {
  Random random(1);
  for (int n = 4; n <= 12; ++n)
    for (int turned = 0; turned < 6; ++turned) {
      Cloud cloud;
      for (int i = 0; i < n; ++i) cloud.push_back(test::any_direction(random));
      check_smallest("at random", cloud, 25, random);
      for (auto& p : cloud) p[2] *= 0.01;
      check_smallest("thin", cloud, 10, random);
      for (auto& p : cloud) p[1] *= 0.01;
      check_smallest("long", cloud, 5, random);
    }
  for (const char* kind : {"cube", "ball", "sphere", "gaussian", "stick", "clusters", "lattice"})
    check_smallest(kind, test::generated<double, 3>(kind, 150, 2), 8, random);
}

TEST_CASE("the smallest box of shapes with many smallest ones") {
  Random random(2);
  for (int sides = 3; sides <= 9; ++sides)
    for (const double twist : {0.0, 0.1, 3.141592653589793 / sides})
      for (const double height : {0.3, 1.4}) {
        const Matrix<double, 3> pose = turn(test::any_direction(random), random.between(-3, 3));
        Cloud cloud = prism(sides, height, twist);
        check_smallest("prism", cloud, 12, random);
        for (auto& p : cloud) p = pose * p;
        check_smallest("turned prism", cloud, 12, random);
      }
  const double golden = (1 + std::sqrt(5.0)) / 2;
  Cloud icosahedron, octahedron;
  for (int axis = 0; axis < 3; ++axis)
    for (const double one : {-1.0, 1.0}) {
      octahedron.push_back(one * Vector<double, 3>::Unit(axis));
      for (const double other : {-golden, golden}) {
        Vector<double, 3> p = Vector<double, 3>::Zero();
        p[(axis + 1) % 3] = one;
        p[(axis + 2) % 3] = other;
        icosahedron.push_back(p);
      }
    }
  check_smallest("icosahedron", icosahedron, 20, random);
  check_smallest("octahedron", octahedron, 20, random);
  check_smallest("regular tetrahedron", {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, 20, random);
  check_smallest("cube", test::generated<double, 3>("lattice", 8, 1), 20, random);
  check_smallest("100-sided prism", prism(100, 1, 0), 4, random);
}

TEST_CASE("known smallest boxes") {
  Random random(3);
  for (int turned = 0; turned < 40; ++turned) {
    // Whatever lies in a box and has its corners has no smaller one.
    const Vector<double, 3> half(random.between(0.01, 1), random.between(0.1, 1), 1);
    const Matrix<double, 3> pose = turn(test::any_direction(random), random.between(-3, 3));
    Cloud cloud;
    for (int corner = 0; corner < 8; ++corner)
      cloud.push_back(pose * Vector<double, 3>((corner & 1 ? 1 : -1) * half[0], (corner & 2 ? 1 : -1) * half[1],
                                               (corner & 4 ? 1 : -1) * half[2]));
    for (int i = 0; i < 20; ++i) cloud.push_back(pose * test::any_direction(random).cwiseProduct(half));
    const auto set = test::set_of<double, 3>(cloud);
    CHECK(measure(fit::obb_exact(set.span()).volume) == doctest::Approx(8 * half.prod()).epsilon(1e-13));
  }
}

TEST_CASE("the order of its points changes the smallest box by no more than rounding") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Cloud cloud = test::generated<double, 3>("ball", 60, seed);
    const double measure_before = measure(fit::obb_exact(test::set_of<double, 3>(cloud).span()).volume);
    Random random(seed);
    for (std::size_t i = cloud.size() - 1; i > 0; --i)
      std::swap(cloud[i], cloud[random.below(static_cast<std::uint32_t>(i + 1))]);
    CHECK(measure(fit::obb_exact(test::set_of<double, 3>(cloud).span()).volume) ==
          doctest::Approx(measure_before).epsilon(1e-13));
  }
}

TEST_CASE("in the plane the smallest box is that of rational arithmetic") {
  // The area of the rectangle on an edge e is the product of the spreads of e . p and e x p, over |e|^2: rational.
  using exact::Rational;
  Random random(4);
  for (int turned = 0; turned < 60; ++turned) {
    const bool whole = turned % 3 == 0;
    test::Cloud<double, 2> cloud;
    for (int i = 0; i < 9; ++i) {
      Vector<double, 2> p(random.between(-1, 1), random.between(-1, 1));
      if (whole) p = {std::floor(4 * p[0]), std::floor(4 * p[1])};
      cloud.push_back(p);
    }
    const auto set = test::set_of<double, 2>(cloud);
    const auto hull = fit::quickhull(set.span()).volume;
    if (hull.affine_dim < 2) continue;
    std::optional<Rational> best;
    for (const auto& facet : hull.facets) {
      const auto& a = hull.vertices[facet[0]];
      const auto& b = hull.vertices[facet[1]];
      const Rational ex = Rational(b[0]) - Rational(a[0]), ey = Rational(b[1]) - Rational(a[1]);
      std::vector<Rational> along, across;
      for (const auto& p : cloud) {
        along.push_back(ex * Rational(p[0]) + ey * Rational(p[1]));
        across.push_back(ex * Rational(p[1]) - ey * Rational(p[0]));
      }
      const auto spread = [](std::vector<Rational>& v) -> Rational {
        const auto [least, greatest] = std::minmax_element(v.begin(), v.end());
        return *greatest - *least;
      };
      const Rational area = spread(along) * spread(across) / (ex * ex + ey * ey);
      if (!best || area < *best) best = area;
    }
    const fit::Fit<Obb<double, 2>> found = fit::obb_exact(set.span());
    CHECK(measure(found.volume) == doctest::Approx(best->convert_to<double>()).epsilon(1e-14));
    CHECK(fit::certify(found, set.span(), true).optimal == true);
    CHECK(fit::on_edges<2>(fit::contacts(found.volume, set.span())));
  }
}

TEST_CASE("the best box on a face is that of rational arithmetic") {
  // With a normal n, an edge e, v = n x e and u = v x n, whose length is |v| |n|, the volume is the product of the
  // spreads of n . p, u . p and v . p, over |n|^2 |v|^2: rational too.
  using exact::Rational;
  using Three = std::array<Rational, 3>;
  const auto dot = [](const Three& a, const Three& b) -> Rational { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const auto cross = [](const Three& a, const Three& b) {
    return Three{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  Random random(5);
  for (int turned = 0; turned < 4; ++turned) {
    Cloud cloud;
    std::vector<Three> at;
    for (int i = 0; i < 7; ++i) {
      cloud.push_back(test::any_direction(random));
      at.push_back({Rational(cloud.back()[0]), Rational(cloud.back()[1]), Rational(cloud.back()[2])});
    }
    const auto minus = [&](std::size_t b, std::size_t a) {
      return Three{at[b][0] - at[a][0], at[b][1] - at[a][1], at[b][2] - at[a][2]};
    };
    const auto spread = [&](const Three& axis) -> Rational {
      Rational least = dot(axis, at[0]), greatest = least;
      for (const Three& p : at) least = std::min(least, dot(axis, p)), greatest = std::max(greatest, dot(axis, p));
      return greatest - least;
    };
    std::optional<Rational> best;
    const auto set = test::set_of<double, 3>(cloud);
    const auto hull = fit::quickhull(set.span()).volume;
    for (const auto& facet : hull.facets) {
      const auto index = [&](std::size_t k) { return static_cast<std::size_t>(hull.indices[facet[k]]); };
      const Three n = cross(minus(index(1), index(0)), minus(index(2), index(0)));
      for (std::size_t a = 0; a < at.size(); ++a)
        for (std::size_t b = a + 1; b < at.size(); ++b) {
          const Three v = cross(n, minus(b, a)), u = cross(v, n);
          if (dot(v, v) == 0) continue;
          const Rational volume = spread(n) * spread(u) * spread(v) / (dot(n, n) * dot(v, v));
          if (!best || volume < *best) best = volume;
        }
    }
    CHECK(measure(fit::obb_face_aligned(set.span()).volume) ==
          doctest::Approx(best->convert_to<double>()).epsilon(1e-13));
  }
}

TEST_CASE("an outline is that of all points") {
  Random random(6);
  int small = 0;
  for (const char* kind : {"cube", "sphere", "gaussian", "lattice"}) {
    const auto set = test::set_of<double, 3>(test::generated<double, 3>(kind, 500, 3));
    const fit::HullSolid solid(fit::quickhull(set.span()).volume);
    for (int turned = 0; turned < 100; ++turned) {
      // At random, along a face and along an edge.
      Vector<double, 3> along = fit::unit<3>(test::any_direction(random));
      const auto facet = random.below(static_cast<std::uint32_t>(solid.normals().size()));
      const auto& edge = solid.edges()[random.below(static_cast<std::uint32_t>(solid.edges().size()))];
      if (turned % 3 == 1) along = fit::unit<3>(solid.normals()[facet].cross(along));
      if (turned % 3 == 2) along = fit::unit<3>(solid.at(edge[1]) - solid.at(edge[0]));
      const std::vector<Index> outline = solid.outline(along);
      small += 2 * outline.size() < solid.vertices().size();
      for (int k = 0; k < 20; ++k) {
        const Vector<double, 3> across = fit::unit<3>(along.cross(test::any_direction(random)));
        const auto reach = [&](Index i) { return across.dot(solid.at(i)); };
        double on_outline = -2, of_all = -2;
        for (const Index i : outline) on_outline = std::max(on_outline, reach(i));
        for (Index i = 0; i < static_cast<Index>(solid.vertices().size()); ++i) of_all = std::max(of_all, reach(i));
        CHECK(on_outline >= of_all - 1e-15 * solid.size());
      }
    }
  }
  CHECK(small > 200);
}

TEST_CASE("points on a sphere: the pairs of edges are all gone through, most of them by one bound") {
  const auto set = test::set_of<double, 3>(test::generated<double, 3>("sphere", 300, 5));
  Recorder<fit::ObbStep<double, 3>> recorder;
  const auto found = fit::obb_exact(set.span(), recorder);
  std::int64_t pairs = 0, ruled_out = 0, halvings = 0;
  Index edges = 0;
  for (const auto& entry : recorder.entries)
    if (const auto* edge = std::get_if<fit::EdgeSearched>(&entry.step.fact)) {
      ++edges;
      pairs += edge->pairs;
      ruled_out += edge->ruled_out;
      halvings += edge->halvings;
    }
  CHECK(edges == 3 * 300 - 6);
  CHECK(pairs > 10'000);
  CHECK(ruled_out < pairs);
  CHECK(2 * ruled_out > pairs);
  CHECK(halvings > 300);
  CHECK(fit::certify(found, set.span(), true).optimal == true);
}

TEST_CASE("boxes count what is spent within: on balls, on each face's rectangle, on each pair's bounds") {
  const auto set = test::set_of<double, 3>(test::generated<double, 3>("sphere", 300, 5));
  const std::int64_t n = set.size(), faces = 2 * n - 4, edges = 3 * n - 6;
  const auto at = [](const OperationCounts& counts, Operation kind) { return counts[static_cast<std::size_t>(kind)]; };

  Counter axis, ball;
  const auto on_axis = fit::obb_sphere_axis(set.span(), axis);
  static_cast<void>(fit::pivot(set.span(), fit::Options{}, ball));
  CHECK(at(axis.counts, Operation::kBallSolves) >
        at(ball.counts, Operation::kBallSolves));  // the ball's, and a circle's
  CHECK(at(axis.counts, Operation::kDistanceTests) > at(ball.counts, Operation::kDistanceTests) + n);
  CHECK(at(axis.counts, Operation::kPointsTouched) > at(ball.counts, Operation::kPointsTouched) + 3 * n);
  CHECK(fit::obb_sphere_axis(set.span()).volume.half_extents == on_axis.volume.half_extents);

  Counter face, hull;
  const auto on_face = fit::obb_face_aligned(set.span(), face);
  static_cast<void>(fit::quickhull(set.span(), hull));
  // Each face has an outline of ten or more vertices, whose rectangle has three corners moved for each of its edges.
  CHECK(at(face.counts, Operation::kOrientationTests) > at(hull.counts, Operation::kOrientationTests) + faces * 3 * 10);
  CHECK(at(face.counts, Operation::kDotProducts) > at(hull.counts, Operation::kDotProducts) + faces * 3 * n);
  CHECK(at(face.counts, Operation::kComparisons) > faces * 6 * n);
  CHECK(at(face.counts, Operation::kPointsTouched) > faces * n);
  CHECK(fit::obb_face_aligned(set.span()).volume.half_extents == on_face.volume.half_extents);

  Recorder<fit::ObbStep<double, 3>> exact;
  const auto smallest = fit::obb_exact(set.span(), exact);
  std::int64_t halvings = 0;
  for (const auto& entry : exact.entries)
    if (const auto* edge = std::get_if<fit::EdgeSearched>(&entry.step.fact)) halvings += edge->halvings;
  CHECK(at(exact.counts, Operation::kDotProducts) > edges * 2 * faces + 17 * halvings);
  CHECK(at(exact.counts, Operation::kSquareRoots) > 2 * halvings);
  CHECK(at(exact.counts, Operation::kComparisons) > edges * edges / 2 * 4);
  CHECK(fit::obb_exact(set.span()).volume.half_extents == smallest.volume.half_extents);
}

TEST_CASE("the normals of thin triangles keep their digits") {
  // A tetrahedron with a face whose third corner is off the line of the others by less and less.
  using exact::Rational;
  for (const double off : {1e-3, 1e-8, 1e-13, 1e-17, 1e-30, 1e-100}) {
    const Cloud cloud{{0, 0, 0}, {1, 0.7, 0.3}, {0.5, 0.35 + off, 0.15}, {0.1, 0.3, -1}};
    const auto set = test::set_of<double, 3>(cloud);
    const auto hull = fit::quickhull(set.span()).volume;
    if (hull.affine_dim < 3) continue;
    const fit::HullSolid solid(hull);
    for (std::size_t f = 0; f < hull.facets.size(); ++f) {
      std::array<std::array<Rational, 3>, 2> edge;
      for (std::size_t k = 0; k < 2; ++k)
        for (int axis = 0; axis < 3; ++axis)
          edge[k][axis] =
              Rational(hull.vertices[hull.facets[f][k + 1]][axis]) - Rational(hull.vertices[hull.facets[f][0]][axis]);
      Vector<double, 3> normal;
      Rational largest = 0;
      std::array<Rational, 3> exact_normal;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
        exact_normal[axis] = edge[0][i] * edge[1][j] - edge[0][j] * edge[1][i];
        largest = std::max(largest, Rational(abs(exact_normal[axis])));
      }
      for (std::size_t axis = 0; axis < 3; ++axis)
        normal[static_cast<int>(axis)] = Rational(exact_normal[axis] / largest).convert_to<double>();
      CHECK((solid.normals()[f] - normal / normal.norm()).norm() <= 4 * tolerance::kRoundoff<double>);
    }
  }
}

TEST_CASE("the search ends where the boxes on two edges turn along two lines that cross") {
  // Found by the long run (tests/long.cpp): halving went on for ever, because rounding put the middle of a stretch
  // beside it. Five corners of a cube.
  const double r = static_cast<double>(1.47197449f);
  const Cloud corners{{r, r, r}, {-r, -r, r}, {-r, r, r}, {-r, -r, -r}, {r, -r, r}};
  const auto set = test::set_of<double, 3>(corners);
  const auto fit = fit::obb_exact(set.span());
  CHECK(certify(fit, set.span(), true).optimal == true);
}
