// A proof is worth what it refuses: every way in which a hull can be wrong is tried.
#include "fit/hull/certify_hull.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/point_clouds.hpp"
#include "fit/hull/quickhull.hpp"

using namespace snug;

namespace {

template <int Dim>
struct Given {
  PointSet<double, Dim> set;
  ConvexHull<double, Dim> hull;

  explicit Given(const test::Cloud<double, Dim>& cloud)
      : set(test::set_of<double, Dim>(cloud)), hull(fit::quickhull(set.span()).volume) {}
  [[nodiscard]] fit::HullProof proof() const { return fit::prove_hull(hull, set.span()); }
};

Given<3> ball(int n) { return Given<3>(test::generated<double, 3>("ball", n, 3)); }

test::Cloud<double, 3> cube_with_more() {
  test::Cloud<double, 3> cloud;
  for (int x = 0; x <= 2; ++x)
    for (int y = 0; y <= 2; ++y)
      for (int z = 0; z <= 2; ++z) cloud.push_back({double(x), double(y), double(z)});
  return cloud;
}

}  // namespace

TEST_CASE("hulls as Quickhull gives them are proven, and so is their certificate") {
  const Given<3> given = ball(500);
  CHECK(given.proof().holds());
  const auto certificate = certify(fit::quickhull(given.set.span()), given.set.span(), true);
  CHECK(certificate.contains);
  CHECK(certificate.on_boundary);
  CHECK(certificate.optimal == true);
  CHECK(certificate.max_outside == 0);
  CHECK(certify(fit::quickhull(given.set.span()), given.set.span(), false).optimal == std::nullopt);
}

TEST_CASE("a hull of fewer points leaves some outside, and the proof says how many and how far") {
  const auto cloud = test::generated<double, 3>("ball", 400, 3);
  Given<3> given(test::Cloud<double, 3>(cloud.begin(), cloud.begin() + 300));
  const auto all = test::set_of<double, 3>(cloud);
  const auto proof = fit::prove_hull(given.hull, all.span());
  CHECK(proof.convex);
  CHECK(proof.extreme);
  CHECK(proof.of_points);
  CHECK(proof.outside > 5);
  CHECK(proof.max_outside > 0.01);
  CHECK(proof.max_outside < 1);
  CHECK_FALSE(proof.holds());
  Index outside = 0;  // by the planes, one by one
  const auto at = [&](Index i) { return given.hull.vertices[i]; };
  for (const auto& p : cloud)
    outside += std::any_of(given.hull.facets.begin(), given.hull.facets.end(),
                           [&](const auto& f) { return orient3d(at(f[0]), at(f[1]), at(f[2]), p) > 0; });
  CHECK(proof.outside == outside);
}

TEST_CASE("a point a last digit outside is seen") {
  test::Cloud<double, 3> cloud = cube_with_more();
  const Given<3> given(cloud);
  for (int axis = 0; axis < 3; ++axis) {
    auto more = cloud;
    more.push_back({1.25, 0.75, 1.5});
    more.back()[axis] = std::nextafter(2.0, 3.0);
    const auto proof = fit::prove_hull(given.hull, test::set_of<double, 3>(more).span());
    CHECK(proof.outside == 1);
    CHECK(proof.max_outside > 0);
    CHECK(proof.max_outside < 1e-15);
  }
}

TEST_CASE("surfaces that are open, turned inside out, dented or there twice are refused") {
  const Given<3> good = ball(60);
  Given<3> open = good;
  open.hull.facets.pop_back();
  CHECK_FALSE(open.proof().convex);

  Given<3> turned = good;
  for (auto& facet : turned.hull.facets) std::swap(facet[0], facet[1]);
  CHECK_FALSE(turned.proof().convex);

  Given<3> one_turned = good;
  std::swap(one_turned.hull.facets[7][0], one_turned.hull.facets[7][1]);
  CHECK_FALSE(one_turned.proof().convex);

  Given<3> twice = good;
  twice.hull.facets.insert(twice.hull.facets.end(), good.hull.facets.begin(), good.hull.facets.end());
  CHECK_FALSE(twice.proof().convex);

  // An edge between two facets exchanged for the other diagonal of the four corners: a dent.
  Given<3> dented = good;
  auto& facets = dented.hull.facets;
  for (std::size_t f = 1; f < facets.size(); ++f) {
    const auto [a, b, c] = facets[0];
    for (std::size_t i = 0; i < 3; ++i)
      if (facets[f][i] == b && facets[f][(i + 1) % 3] == a) {
        const Index d = facets[f][(i + 2) % 3];
        facets[0] = {a, d, c};
        facets[f] = {d, b, c};
        f = facets.size() - 1;
        break;
      }
  }
  CHECK(facets[0] != good.hull.facets[0]);
  CHECK_FALSE(dented.proof().convex);
}

TEST_CASE("a surface that bends outward everywhere but winds twice is refused") {
  // A five-pointed star of a rim with one apex above and one below: every edge bends outward, and it goes around twice.
  // Corners in a ring by twos: the rim 0 2 4 1 3 of a regular pentagon in whole numbers.
  const test::Cloud<double, 3> cloud{{95, 31, 0},  {0, 100, 0}, {-95, 31, 0}, {-59, -81, 0},
                                     {59, -81, 0}, {0, 0, 50},  {0, 0, -50}};
  Given<3> star(cloud);
  REQUIRE(star.proof().holds());
  star.hull.facets.clear();
  for (Index i = 0; i < 5; ++i) {
    const Index from = 2 * i % 5, to = (2 * i + 2) % 5;
    star.hull.facets.push_back({from, to, 5});
    star.hull.facets.push_back({to, from, 6});
  }
  CHECK_FALSE(star.proof().convex);
  // The same of a polygon in the plane.
  Given<2> pentagram({{95, 31}, {0, 100}, {-95, 31}, {-59, -81}, {59, -81}});
  REQUIRE(pentagram.proof().holds());
  auto& hull = pentagram.hull;
  const auto plain = hull;
  for (std::size_t i = 0; i < 5; ++i) {
    hull.vertices[i] = plain.vertices[2 * i % 5];
    hull.indices[i] = plain.indices[2 * i % 5];
  }
  CHECK_FALSE(pentagram.proof().convex);
}

TEST_CASE("vertices that are not extreme, or not the points they say, are refused") {
  const auto cloud = cube_with_more();
  // A corner's fan with one more vertex in the middle of a face: the same set of points, one vertex too many.
  Given<3> given(cloud);
  REQUIRE(given.proof().holds());
  const Index middle = 4;  // (0, 1, 1), in the face x = 0
  Given<3> more = given;
  more.hull.vertices.push_back(cloud[middle]);
  more.hull.indices.push_back(middle);
  const auto added = static_cast<Index>(more.hull.vertices.size() - 1);
  CHECK_FALSE(more.proof().extreme);  // no facet has it
  std::vector<std::array<Index, 3>> facets;
  for (const auto& f : given.hull.facets) {
    const auto at = [&](std::size_t i) { return given.hull.vertices[f[i]]; };
    if (at(0)[0] != 0 || at(1)[0] != 0 || at(2)[0] != 0) {
      facets.push_back(f);
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i) {  // the sides of the square, not its diagonal
      const auto from = at(i), to = at((i + 1) % 3);
      if ((from - to).squaredNorm() == 4) facets.push_back({f[i], f[(i + 1) % 3], added});
    }
  }
  more.hull.facets = facets;
  CHECK(more.proof().convex);
  CHECK(more.proof().outside == 0);
  CHECK_FALSE(more.proof().extreme);
  CHECK_FALSE(more.proof().holds());

  Given<3> misnamed = given;
  misnamed.hull.indices[2] = 13;
  CHECK_FALSE(misnamed.proof().of_points);
  Given<3> moved = given;
  moved.hull.vertices[7][0] = std::nextafter(2.0, 3.0);
  CHECK_FALSE(moved.proof().of_points);

  auto again = cloud;
  again.insert(again.begin(), cloud.back());
  Given<3> later(again);
  REQUIRE(later.proof().holds());
  for (Index& i : later.hull.indices)
    if (i == 0) i = static_cast<Index>(again.size()) - 1;  // the same place, but not its first point
  CHECK_FALSE(later.proof().of_points);
}

TEST_CASE("indices that name nothing, and too few vertices, are refused without looking") {
  Given<3> given = ball(30);
  given.hull.facets[0][1] = static_cast<Index>(given.hull.vertices.size());
  CHECK(given.proof().outside == 30);
  CHECK_FALSE(given.proof().convex);
  given = ball(30);
  given.hull.indices[0] = -1;
  CHECK_FALSE(given.proof().holds());
  given = ball(30);
  given.hull.indices.pop_back();
  CHECK_FALSE(given.proof().holds());
  given.hull = {};
  CHECK_FALSE(given.proof().holds());
  given.hull.affine_dim = 0;
  CHECK_FALSE(given.proof().holds());
}

TEST_CASE("flat hulls: points off the plane or line, rings that are not convex") {
  const test::Cloud<double, 3> square{{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}, {2, 2, 1}, {4, 2, 1}};
  Given<3> given(square);
  CHECK(given.proof().holds());
  auto off = square;
  off.push_back({1, 1, std::nextafter(1.0, 2.0)});
  CHECK(fit::prove_hull(given.hull, test::set_of<double, 3>(off).span()).outside == 1);
  Given<3> crossed = given;
  std::swap(crossed.hull.vertices[0], crossed.hull.vertices[1]);
  std::swap(crossed.hull.indices[0], crossed.hull.indices[1]);
  CHECK_FALSE(crossed.proof().convex);
  Given<3> with_edge = given;  // (4, 2, 1) lies inside an edge
  const auto at =
      std::find(with_edge.hull.indices.begin(), with_edge.hull.indices.end(), 1) - with_edge.hull.indices.begin();
  with_edge.hull.indices[at] = 5;
  with_edge.hull.vertices[at] = square[5];
  CHECK(with_edge.proof().outside == 1);

  Given<3> segment({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}});
  CHECK(segment.proof().holds());
  CHECK(fit::prove_hull(segment.hull, test::set_of<double, 3>({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {1, 2, 4}}).span())
            .outside == 1);
  Given<2> place({{1, 1}, {1, 1}});
  CHECK(place.proof().holds());
  CHECK(fit::prove_hull(place.hull, test::set_of<double, 2>({{1, 1}, {1, 2}}).span()).outside == 1);
}

TEST_CASE("a hull thinner than its coordinates' last digits is proven without a point inside") {
  // Whole numbers near 2^53, a few steps apart: the mean of the corners is rounded onto the surface or out of it.
  Random random(5);
  int proven = 0;
  for (int turn = 0; turn < 40; ++turn) {
    test::Cloud<double, 3> cloud;
    for (int i = 0; i < 12; ++i)
      cloud.push_back({0x1p53 + 2.0 * random.below(2), 0x1p53 + 2.0 * random.below(3), 0x1p53 + 2.0 * random.below(3)});
    const Given<3> given(cloud);
    CHECK(given.proof().holds());
    proven += given.hull.affine_dim == 3;
    if (given.hull.affine_dim < 3) continue;
    Given<3> fewer = given;
    fewer.hull.facets.pop_back();
    CHECK_FALSE(fewer.proof().convex);
  }
  CHECK(proven > 30);
}
