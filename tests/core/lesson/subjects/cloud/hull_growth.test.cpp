// The hull that is rebuilt from a trace's facts, against the points themselves.
#include "lesson/subjects/cloud/hull_growth.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/point_clouds.hpp"
#include "fit/catalogue.hpp"
#include "geometry/orientation.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

/// +1 if the point lies strictly outside of the facet.
int side_of(const GrowingFacet& facet, const AnyPointSet& points, Index i) {
  const auto at = [&](Index k) { return fit::point_of(points, k); };
  const auto flat = [&](Index k) { return Vector<double, 2>(at(k).head<2>()); };
  if (facet.vertices.size() == 2) return -orient2d(flat(facet.vertices[0]), flat(facet.vertices[1]), flat(i));
  return orient3d(at(facet.vertices[0]), at(facet.vertices[1]), at(facet.vertices[2]), at(i));
}

void check_assigned(const GrowingHull& hull, const AnyPointSet& points) {
  for (const GrowingFacet& facet : hull.facets)
    for (const Index i : facet.outside) CHECK(side_of(facet, points, i) > 0);
  for (const Index i : hull.just_dropped)
    for (const GrowingFacet& facet : hull.facets)
      if (facet.alive()) CHECK(side_of(facet, points, i) <= 0);
}

/// Every point is a vertex, outside of one facet, waits for one, or was dropped: exactly one of these.
void check_all_there(const GrowingHull& hull, Index n) {
  std::vector<Index> all = hull.vertices();
  for (const auto* list : {&hull.waiting, &hull.dropped}) all.insert(all.end(), list->begin(), list->end());
  for (const GrowingFacet& facet : hull.facets) all.insert(all.end(), facet.outside.begin(), facet.outside.end());
  std::sort(all.begin(), all.end());
  REQUIRE(static_cast<Index>(all.size()) == n);
  for (Index i = 0; i < n; ++i) CHECK(all[i] == i);
}

void check_growth(const AnyPointSet& points) {
  const fit::Recording run = fit::find_algorithm("hull", "quickhull")->record(points, {});
  const Index n = fit::count_of(points);
  for (int step = 1; step <= static_cast<int>(run.steps.size()); ++step) {
    const fit::Step3& now = run.steps[step - 1].step;
    const auto hull = growing_hull(run.steps, step);
    REQUIRE(hull);
    CAPTURE(step);
    if (std::holds_alternative<fit::SimplexChosen>(now.fact)) continue;  // nothing is assigned yet
    if (std::holds_alternative<fit::PointsAssigned>(now.fact)) check_assigned(*hull, points);
    if (const auto* eye = std::get_if<fit::EyeChosen>(&now.fact)) {
      CHECK(growing_hull(run.steps, step - 1)->at == eye->facet);  // the one that was to come
      CHECK(hull->facets[eye->facet].outside.size() == static_cast<std::size_t>(eye->of));
    }
    if (const auto* horizon = std::get_if<fit::HorizonFound>(&now.fact))
      for (const Index f : hull->seen) CHECK(side_of(hull->facets[f], points, horizon->eye) > 0);
    if (std::holds_alternative<fit::FacesMerged>(now.fact) || std::holds_alternative<fit::Finished>(now.fact)) continue;
    check_all_there(*hull, n);
  }
  CHECK(growing_hull(run.steps, static_cast<int>(run.steps.size()))->still_outside() == 0);
}

}  // namespace

TEST_CASE("at every step each point is a vertex, outside of its facet, waiting or dropped") {
  for (const char* kind : {"cube", "gaussian", "sphere", "lattice"})
    for (const std::uint64_t seed : {1, 2, 7}) {
      CAPTURE(kind);
      check_growth(test::set_of<double, 2>(test::generated<double, 2>(kind, 16, seed)));
      check_growth(test::set_of<double, 3>(test::generated<double, 3>(kind, 27, seed)));
      check_growth(test::set_of<float, 3>(test::generated<float, 3>(kind, 16, seed)));
    }
}

TEST_CASE("coplanar facets have flat edges between them, exactly, and other facets have none") {
  test::Cloud<double, 3> cube;
  for (int bits = 0; bits < 8; ++bits)
    cube.push_back({bits & 1 ? 0.1 : 0.7, bits & 2 ? 0.1 : 0.7, bits & 4 ? 0.1 : 0.7});
  const auto flat_of = [](const AnyPointSet& points) {
    const fit::Recording run = fit::find_algorithm("hull", "quickhull")->record(points, {});
    return flat_edges(*growing_hull(run.steps, static_cast<int>(run.steps.size()) - 1), points).size();
  };
  CHECK(flat_of(test::set_of<double, 3>(cube)) == 6);
  cube.back() = {0.7, 0.7, std::nextafter(0.7, 1.0)};
  CHECK(flat_of(test::set_of<double, 3>(cube)) < 6);
}

TEST_CASE("before the first facets there is no hull, nor on a line in space, nor in another algorithm's run") {
  const auto plane = test::set_of<double, 2>(test::generated<double, 2>("cube", 9, 1));
  CHECK_FALSE(growing_hull(fit::find_algorithm("hull", "quickhull")->record(plane, {}).steps, 0));
  CHECK_FALSE(growing_hull(fit::find_algorithm("sphere", "ritter")->record(plane, {}).steps, 5));
  const auto line = test::set_of<double, 3>({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}});
  CHECK_FALSE(growing_hull(fit::find_algorithm("hull", "quickhull")->record(line, {}).steps, 2));
}
