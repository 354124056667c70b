#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "quickhull.hpp"

#include <doctest/doctest.h>

using Points = std::vector<snug::Vector<double, 2>>;

TEST_CASE("the farther of two points") { CHECK(farthest(Points{{0, 0}, {4, 0}, {1, 1}, {2, 3}}, 0, 1) == 3); }

TEST_CASE("points to the right do not count") { CHECK(farthest(Points{{0, 0}, {4, 0}, {1, 1}, {2, -3}}, 0, 1) == 2); }

TEST_CASE("no point to the left") { CHECK(farthest(Points{{0, 0}, {4, 0}, {2, 0}, {2, -3}}, 0, 1) == -1); }
