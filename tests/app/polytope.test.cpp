// The faces that volumes are drawn by.
#include "app/polytope.hpp"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <set>

#include "fit/catalogue.hpp"
#include "geometry/generate.hpp"
#include "lesson/point_subject.hpp"

namespace snug::app {

TEST_CASE("a k-DOP in space is drawn by its flat faces, one for each side of a slab at most") {
  for (const char* name : {"k6", "k14", "k18", "k26"})
    for (const char* kind : {"gaussian", "cube", "clusters"}) {
      CAPTURE(name);
      CAPTURE(kind);
      const auto points = *lesson::to_set(*generate(kind, 40, 3, 7), 3);
      const fit::Result result = fit::find_algorithm("kdop", name)->fit(points, {});
      const auto& kdop = *std::get_if<Kdop<double, 3>>(&result.volume);
      const Polytope polytope = polytope_of(kdop, 3);
      CHECK(polytope.faces.size() <= static_cast<std::size_t>(kdop.k));
      std::size_t sides = 0;
      std::set<std::pair<int, int>> edges;
      Vector<double, 3> middle = Vector<double, 3>::Zero();
      for (const auto& corner : polytope.corners) middle += corner / static_cast<double>(polytope.corners.size());
      for (const std::vector<int>& face : polytope.faces) {
        sides += face.size();
        const auto corner = [&](std::size_t i) { return polytope.corners[face[i % face.size()]]; };
        const Vector<double, 3> normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
        CHECK(normal.dot(corner(0) - middle) > 0);  // counter-clockwise from outside
        for (std::size_t i = 0; i < face.size(); ++i) {
          edges.emplace(face[i], face[(i + 1) % face.size()]);
          CHECK(std::abs(normal.dot(corner(i) - corner(0))) < 1e-9);
          CHECK((corner(i + 1) - corner(i)).cross(corner(i + 2) - corner(i + 1)).dot(normal) > 0);  // convex
        }
      }
      for (const auto& [a, b] : edges) CHECK(edges.count({b, a}) == 1);         // each edge borders two faces
      CHECK(polytope.corners.size() + polytope.faces.size() == sides / 2 + 2);  // Euler
    }
}

TEST_CASE("facets of a hull that lie in one plane are drawn as one face") {
  std::vector<lesson::Point3> cube;
  for (int i = 0; i < 8; ++i) cube.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  const auto hull_of = [](const std::vector<lesson::Point3>& points) {
    const fit::Result result = fit::find_algorithm("hull", "quickhull")->fit(*lesson::to_set(points, 3), {});
    return polytope_of(*std::get_if<ConvexHull<double, 3>>(&result.volume), 3);
  };
  const Polytope solid = hull_of(cube);
  CHECK(solid.faces.size() == 6);
  for (const std::vector<int>& face : solid.faces) CHECK(face.size() == 4);
  for (lesson::Point3& corner : cube) corner += 1e-15 * lesson::Point3(corner[1], corner[2] - corner[0], corner[0]);
  CHECK(hull_of(cube).faces.size() == 6);
  cube.push_back({0.5, 0.5, 1.5});  // a roof of four triangles
  CHECK(hull_of(cube).faces.size() == 9);
}

TEST_CASE("a flat hull in space is drawn as its polygon, points on a line as a segment") {
  const auto faces_of = [](const std::vector<lesson::Point3>& points) {
    const fit::Result result = fit::find_algorithm("hull", "quickhull")->fit(*lesson::to_set(points, 3), {});
    return polytope_of(*std::get_if<ConvexHull<double, 3>>(&result.volume), 3).faces;
  };
  const lesson::Point3 a(0, 0, 1), b(2, 0, 1), c(2, 2, 1), d(0, 2, 1), inside(1, 1, 1);
  const auto polygon = faces_of({a, c, inside, b, d});
  REQUIRE(polygon.size() == 1);
  CHECK(polygon.front() == std::vector<int>{0, 1, 2, 3});
  const auto segment = faces_of({a, b, (a + b) / 2});
  REQUIRE(segment.size() == 1);
  CHECK(segment.front().size() == 2);
  CHECK(faces_of({a, a}).empty());
}

}  // namespace snug::app
