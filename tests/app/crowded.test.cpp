// When a polytope is drawn without its edges.
#include "app/crowded.hpp"

#include <doctest/doctest.h>

#include "fit/catalogue.hpp"
#include "geometry/generate.hpp"
#include "lesson/point_subject.hpp"

namespace snug::app {
namespace {

/// Whether it is crowded where a scene unit is so many pixels, seen along z.
bool crowded_at(const Polytope& polytope, float pixels) {
  std::vector<ImVec2> screen;
  for (const auto& corner : polytope.corners)
    screen.push_back({pixels * static_cast<float>(corner[0]), -pixels * static_cast<float>(corner[1])});
  std::vector<bool> front;
  for (const auto& face : polytope.faces) {
    const auto at = [&](std::size_t i) { return polytope.corners[face[i]]; };
    const Vector<double, 3> u = at(1) - at(0), v = at(2) - at(0);
    front.push_back(u[0] * v[1] - u[1] * v[0] > 0);
  }
  return is_crowded(polytope, screen, front);
}

}  // namespace

TEST_CASE("a hull of many points has edges on the stage and none in a small picture; a small box keeps its edges") {
  const auto points = *lesson::to_set(*generate("sphere", 160, 3, 7), 3);
  const fit::Result result = fit::find_algorithm("hull", "quickhull")->fit(points, {});
  const Polytope hull = polytope_of(*std::get_if<ConvexHull<double, 3>>(&result.volume), 3);
  REQUIRE(hull.faces.size() > 300);
  double reach = 0;
  for (const auto& corner : hull.corners) reach = std::max(reach, corner.norm());
  CHECK(crowded_at(hull, static_cast<float>(45 / reach)));
  CHECK_FALSE(crowded_at(hull, static_cast<float>(250 / reach)));
  const Aabb<double, 3> box{Vector<double, 3>(-1, -1, -1), Vector<double, 3>(1, 1, 1)};
  CHECK_FALSE(crowded_at(polytope_of(box, 3), 2));
}

}  // namespace snug::app
