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

}  // namespace snug::app
