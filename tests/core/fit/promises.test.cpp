// Every fitter of every volume keeps its promises (core/fit/promises.hpp), on every cloud.
#include "core/fit/promises.hpp"

#include <array>
#include <set>
#include <vector>

using namespace snug;
using test::check_promises;

namespace {

/// Spheres take more clouds in the same time than volumes with a hull in them.
constexpr int kSphereSeeds = 12, kSeeds = 3;

std::vector<fit::Algorithm> but_spheres() {
  std::vector<fit::Algorithm> rows;
  for (const fit::Algorithm& algorithm : fit::algorithms())
    if (algorithm.volume != "sphere") rows.push_back(algorithm);
  return rows;
}

template <class Scalar>
void check_degenerate(std::span<const fit::Algorithm> algorithms, std::uint64_t seed, int n) {
  for (const auto& [name, points] : test::degenerate_clouds<Scalar, 2>(seed, n))
    check_promises<Scalar, 2>(algorithms, name, points);
  for (const auto& [name, points] : test::degenerate_clouds<Scalar, 3>(seed, n))
    check_promises<Scalar, 3>(algorithms, name, points);
}

}  // namespace

TEST_CASE_TEMPLATE("every fitter keeps its promises on degenerate clouds", Scalar, float, double) {
  for (std::uint64_t seed = 1; seed <= kSphereSeeds; ++seed)
    for (const int n : {3, 7, 14}) check_degenerate<Scalar>(fit::algorithms_of("sphere"), seed, n);
  const std::vector<fit::Algorithm> others = but_spheres();
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed)
    for (const int n : {2, 5, 12}) check_degenerate<Scalar>(others, seed, n);
}

TEST_CASE_TEMPLATE("every fitter keeps its promises on larger clouds", Scalar, float, double) {
  const std::vector<fit::Algorithm> others = but_spheres();
  for (const auto kind : generator_kinds()) {
    const std::string name(kind);
    for (const int n : {100, 2000}) {
      check_promises<Scalar, 2>(fit::algorithms_of("sphere"), name, test::generated<Scalar, 2>(name.c_str(), n, 11));
      check_promises<Scalar, 3>(fit::algorithms_of("sphere"), name, test::generated<Scalar, 3>(name.c_str(), n, 12));
    }
    check_promises<Scalar, 2>(others, name, test::generated<Scalar, 2>(name.c_str(), 1000, 11));
    check_promises<Scalar, 3>(others, name, test::generated<Scalar, 3>(name.c_str(), 150, 12));
  }
  for (const auto& [name, points] : test::degenerate_clouds<Scalar, 3>(5, 2000))
    check_promises<Scalar, 3>(fit::algorithms_of("sphere"), name, points);
}

TEST_CASE("every fitter keeps its promises on far, tiny and huge clouds") {
  const std::vector<fit::Algorithm> others = but_spheres();
  for (const double offset : {0.0, 1e3, 1e8, -1e8})
    for (const double scale : {1e-150, 1e-75, 1e-3, 1.0, 1e75, 1e150}) {
      if (offset != 0 && scale != 1) continue;
      CAPTURE(offset);
      CAPTURE(scale);
      for (const char* kind : {"cube", "sphere", "gaussian", "lattice", "line"}) {
        check_promises<double, 2>(fit::algorithms(), kind, test::generated<double, 2>(kind, 30, 3, scale, offset));
        check_promises<double, 3>(others, kind, test::generated<double, 3>(kind, 30, 4, scale, offset));
        check_promises<double, 3>(fit::algorithms_of("sphere"), kind,
                                  test::generated<double, 3>(kind, 300, 4, scale, offset));
      }
    }
}

TEST_CASE("boxes, capsules and lozenges keep theirs down to the least numbers that there are") {
  for (const char* kind : {"cube", "sphere", "stick", "lattice", "line"})
    for (const std::string_view volume : {"obb", "capsule", "lozenge"}) {
      for (const double scale : {1e-160, 1e-300}) {
        check_promises<double, 2>(fit::algorithms_of(volume), kind, test::generated<double, 2>(kind, 30, 3, scale));
        check_promises<double, 3>(fit::algorithms_of(volume), kind, test::generated<double, 3>(kind, 30, 4, scale));
      }
      if (volume == "obb") continue;
      check_promises<double, 3>(fit::algorithms_of(volume), kind, test::generated<double, 3>(kind, 100, 2, 1e-310));
      check_promises<float, 3>(fit::algorithms_of(volume), kind, test::generated<float, 3>(kind, 200, 2, 1, 1e4));
      check_promises<float, 3>(fit::algorithms_of(volume), kind, test::generated<float, 3>(kind, 3000, 2));
      for (const double scale : {1e-22, 1e-40, 1e17})
        check_promises<float, 3>(fit::algorithms_of(volume), kind, test::generated<float, 3>(kind, 100, 2, scale));
      check_promises<double, 3>(fit::algorithms_of(volume), kind, test::generated<double, 3>(kind, 3000, 2));
    }
}

TEST_CASE("one point is a volume of no size, for every algorithm") {
  for (const fit::Algorithm& algorithm : fit::algorithms()) {
    if (!fit::takes(algorithm, 3)) continue;
    const AnyPointSet point = test::set_of<double, 3>({{1, 2, 3}});
    check_promises(algorithm, point);
    const fit::Result found = algorithm.fit(point, {});
    CHECK(fit::size_of(found.volume, 3) == 0);
    if (algorithm.volume == "sphere") CHECK(ball_of(found).center == Vector<double, 3>(1, 2, 3));
  }
}

TEST_CASE("every kind of step happens, and reads as JSON with its own name") {
  // What only tests of boxes and scenes tell of happens in tests/app/captions.test.cpp.
  std::set<std::string_view> seen{"frames_related", "axis_tested", "looked_closer", "verdict", "outlines_compared",
                                  "corner_tried", "claimed", "plane_tested", "corner_tested", "classified",
                                  "frame_taken",
                                  // These need harder clouds: tests/core/fit/sphere/naive.test.cpp.
                                  "circumsphere_failed", "tests_exhausted"};
  for (const fit::Algorithm& algorithm : fit::algorithms())
    for (const char* kind : {"gaussian", "lattice", "clusters", "ball", "stick"})
      for (const int n : {12, 300, 1100}) {
        // Only the printed recursion does something else with more points: it is stopped.
        if (n > algorithm.max_points || (n == 1100 && algorithm.name != "welzl_recursive")) continue;
        const std::array<AnyPointSet, 3> sets{test::set_of<double, 2>(test::generated<double, 2>(kind, n, 9)),
                                              test::set_of<double, 3>(test::generated<double, 3>(kind, n, 9)),
                                              test::set_of<double, 3>({{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}})};
        for (const AnyPointSet& set : sets) {
          if (!fit::takes(algorithm, fit::dim_of(set))) continue;
          for (const auto& entry : algorithm.record(set, {}).steps) {
            if (!seen.insert(name_of(entry.step)).second) continue;
            const std::string json = json_of(entry.step, fit::dim_of(set));
            CHECK(json.find("{\"step\":\"" + std::string(name_of(entry.step)) + "\",\"line\":") == 0);
            CHECK(json.back() == '}');
          }
        }
      }
  for (const auto name : fit::fact_names()) {
    CAPTURE(name);
    CHECK(seen.contains(name));
  }
}
