#include "geometry/point_set.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "geometry/generate.hpp"

using namespace snug;
using Set = PointSet<float, 2>;

TEST_CASE("no points make no set") {
  const auto set = Set::make({});
  REQUIRE(!set);
  CHECK(set.error().message() == "there are no points");
}

TEST_CASE("a coordinate that is not finite is refused by point and axis") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  CHECK(Set::make({{0, 0}, {1, nan}}).error().message() == "coordinate y of point 1 is not finite");
  CHECK(Set::make({{-infinity, 0}}).error().message() == "coordinate x of point 0 is not finite");
  CHECK(Set::make({{0, 1e30f}}).error().message() ==
        "coordinate y of point 0 is larger than this program can take (1.1e18)");
  CHECK(Set::make({{1.1e18f, 1.1e18f}}).has_value());
  using Double = PointSet<double, 3>;
  CHECK(Double::make({{0, 0, 1e300}}).error().message() ==
        "coordinate z of point 0 is larger than this program can take (8.3e152)");
  CHECK(Double::make({{8.3e152, 0, 0}}).has_value());
}

TEST_CASE("a refused move leaves the set as it was") {
  auto set = *Set::make({{1, 2}, {3, 4}});
  CHECK(!set.move(1, {5, std::numeric_limits<float>::infinity()}));
  CHECK(set[1] == Vector<float, 2>(3, 4));
  CHECK(set.move(1, {5, 6}));
  CHECK(set[1] == Vector<float, 2>(5, 6));
}

TEST_CASE("every generator gives n points of its dimension, the same for the same seed") {
  for (const auto kind : generator_kinds()) {
    for (const int dim : {2, 3}) {
      const auto a = generate(kind, 100, dim, 5);
      const auto b = generate(kind, 100, dim, 5);
      REQUIRE(a);
      CHECK(*a == *b);
      CHECK(a->size() == 100);
      for (const auto& p : *a) {
        CHECK(p.allFinite());
        CHECK(p.cwiseAbs().maxCoeff() < 7);
        if (dim == 2) CHECK(p[2] == 0);
      }
      if (kind != "lattice") CHECK(*a != *generate(kind, 100, dim, 6));
    }
  }
  CHECK(!generate("unknown", 3, 2, 1));
  CHECK(!generate("cube", 0, 2, 1));
}
