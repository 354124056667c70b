#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "overlap.hpp"

#include <doctest/doctest.h>

using Box = snug::Aabb<double, 3>;

TEST_CASE("boxes that overlap") { CHECK(overlap(Box{{0, 0, 0}, {2, 2, 2}}, Box{{1, 1, 1}, {3, 3, 3}})); }

TEST_CASE("boxes that are apart along y") {
  CHECK_FALSE(overlap(Box{{0, 0, 0}, {2, 2, 2}}, Box{{0, 3, 0}, {2, 4, 2}}));
}

TEST_CASE("boxes that touch") { CHECK(overlap(Box{{0, 0, 0}, {1, 1, 1}}, Box{{1, 0, 0}, {2, 1, 1}})); }
