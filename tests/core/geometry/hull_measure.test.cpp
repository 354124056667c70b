// Measures and neighbours of hulls that are known, and hill climbing over the neighbours.
#include "geometry/hull_measure.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/point_clouds.hpp"
#include "fit/hull/quickhull.hpp"
#include "geometry/hull_neighbors.hpp"

using namespace snug;

namespace {

template <class Scalar, int Dim>
ConvexHull<Scalar, Dim> hull_of(const test::Cloud<Scalar, Dim>& cloud) {
  return fit::quickhull(test::set_of<Scalar, Dim>(cloud).span()).volume;
}

test::Cloud<double, 3> box(double x, double y, double z, double offset = 0) {
  test::Cloud<double, 3> cloud;
  for (int i = 0; i < 8; ++i)
    cloud.push_back({offset + (i & 1 ? x : 0), offset + (i & 2 ? y : 0), offset + (i & 4 ? z : 0)});
  return cloud;
}

}  // namespace

TEST_CASE("measures of a point, a segment and flat polygons") {
  CHECK(measure(hull_of<double, 3>({{1, 2, 3}})) == 0);
  CHECK(surface_pieces(hull_of<double, 3>({{1, 2, 3}})).empty());
  CHECK(surface_pieces(hull_of<double, 3>({{0, 0, 0}, {3, 4, 0}})).empty());
  CHECK(surface_measure(hull_of<double, 2>({{0, 0}, {3, 4}})) == 10);
  const auto square = hull_of<double, 3>({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  CHECK(measure(square) == 0);
  CHECK(surface_measure(square) == 8);
}

TEST_CASE("measures of boxes, wherever they stand") {
  for (const double offset : {0.0, 5.0, -1e6}) {
    const auto hull = hull_of<double, 3>(box(1, 2, 3, offset));
    CHECK(measure(hull) == doctest::Approx(6).epsilon(1e-13));
    CHECK(surface_measure(hull) == doctest::Approx(22).epsilon(1e-13));
    Vector<double, 3> centroid = Vector<double, 3>::Zero();
    for (const auto& piece : surface_pieces(hull)) centroid += piece.measure / 22 * piece.centroid;
    const Vector<double, 3> middle(0.5 + offset, 1 + offset, 1.5 + offset);
    CHECK((centroid - middle).norm() < 1e-13 * (10 + std::abs(offset)));
  }
  const auto square = hull_of<float, 2>({{0, 0}, {4, 0}, {4, 3}, {0, 3}, {1, 1}});
  CHECK(measure(square) == 12);
  CHECK(surface_measure(square) == 14);
}

TEST_CASE("a regular tetrahedron's measures, and a ball's by many points") {
  const auto tetrahedron = hull_of<double, 3>({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
  CHECK(measure(tetrahedron) == doctest::Approx(8.0 / 3));
  CHECK(surface_measure(tetrahedron) == doctest::Approx(8 * std::sqrt(3.0)));
  const auto ball = hull_of<double, 3>(test::generated<double, 3>("sphere", 4000, 1));
  CHECK(measure(ball) < 4.18879);
  CHECK(measure(ball) > 4.17);
  CHECK(surface_measure(ball) < 12.56638);
  CHECK(surface_measure(ball) > 12.54);
}

TEST_CASE("neighbours go both ways, and know the facet on their left") {
  const auto hull = hull_of<double, 3>(test::generated<double, 3>("ball", 300, 2));
  const HullNeighbors neighbors = hull_neighbors(hull);
  CHECK(neighbors.ends.size() == 3 * hull.facets.size());
  for (Index v = 0; v < static_cast<Index>(hull.vertices.size()); ++v) {
    CHECK(neighbors.of(v).size() >= 3);
    CHECK(std::is_sorted(neighbors.of(v).begin(), neighbors.of(v).end()));
    for (const Index w : neighbors.of(v)) {
      CHECK(neighbors.edge(w, v) != kNoIndex);
      const auto& facet = hull.facets[neighbors.facets[neighbors.edge(v, w)]];
      const auto at = std::find(facet.begin(), facet.end(), v) - facet.begin();
      REQUIRE(at < 3);
      CHECK(facet[(at + 1) % 3] == w);
    }
    CHECK(neighbors.edge(v, v) == kNoIndex);
  }
}

TEST_CASE("neighbours in a ring, on a segment and of a point") {
  const auto ring = hull_neighbors(hull_of<double, 2>({{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
  for (Index v = 0; v < 4; ++v) CHECK(ring.of(v).size() == 2);
  CHECK(ring.of(0)[0] == 1);
  CHECK(ring.of(0)[1] == 3);
  const auto flat = hull_neighbors(hull_of<double, 3>({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}}));
  for (Index v = 0; v < 4; ++v) CHECK(flat.of(v).size() == 2);
  const auto segment = hull_neighbors(hull_of<double, 3>({{0, 0, 0}, {2, 0, 0}}));
  CHECK(segment.of(0).size() == 1);
  CHECK(segment.of(0)[0] == 1);
  CHECK(hull_neighbors(hull_of<double, 3>({{0, 0, 0}})).of(0).empty());
}

TEST_CASE("climbing over the neighbours ends at the farthest vertex") {
  Random random(9);
  const auto climb_all = [&](const auto& hull) {
    using Point = std::decay_t<decltype(hull.vertices[0])>;
    const HullNeighbors neighbors = hull_neighbors(hull);
    int moves = 0;
    for (int turn = 0; turn < 200; ++turn) {
      Point direction;
      for (int i = 0; i < Point::RowsAtCompileTime; ++i) direction[i] = random.between(-1, 1);
      const auto reach = [&](Index v) { return direction.dot(hull.vertices[v]); };
      Index at = 0;
      for (bool climbs = true; climbs;) {
        climbs = false;
        for (const Index next : neighbors.of(at))
          if (reach(next) > reach(at)) at = next, climbs = true, ++moves;
      }
      for (Index v = 0; v < static_cast<Index>(hull.vertices.size()); ++v) CHECK(reach(v) <= reach(at));
    }
    CHECK(moves > 200);
  };
  climb_all(hull_of<double, 3>(test::generated<double, 3>("ball", 500, 1)));
  climb_all(hull_of<double, 3>(box(1, 2, 3)));
  climb_all(hull_of<double, 2>(test::generated<double, 2>("sphere", 50, 1)));
}
