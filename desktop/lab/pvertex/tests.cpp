#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "pvertex.hpp"

#include <doctest/doctest.h>

const snug::Aabb<double, 3> box{{0, 0, 0}, {1, 2, 3}};

TEST_CASE("a normal with positive coordinates") {
  const Vertices found = vertices(box, {1, 1, 1});
  CHECK(found.p == snug::Vector<double, 3>(1, 2, 3));
  CHECK(found.n == snug::Vector<double, 3>(0, 0, 0));
}

TEST_CASE("a normal with a negative coordinate") {
  const Vertices found = vertices(box, {1, -1, 1});
  CHECK(found.p == snug::Vector<double, 3>(1, 0, 3));
  CHECK(found.n == snug::Vector<double, 3>(0, 2, 0));
}

TEST_CASE("a short normal") { CHECK(vertices(box, {-1e-30, 1e-30, 1e-30}).p == snug::Vector<double, 3>(0, 2, 3)); }
