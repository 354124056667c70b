// Families of small point sets, each named by what is hard about it; every member by its seed, the same everywhere.
#pragma once

#include <span>
#include <string_view>

#include "core/point_clouds.hpp"

namespace snug::test {

/// What a set turned out to be, by what was fitted round it.
struct Traits {
  int dim = 3, points = 0;
  int hull_dim = 0;  // of its hull, decided exactly
  int hull_vertices = 0;
  int support = 0;      // of its smallest sphere
  int on_sphere = 0;    // points within 4 ulps of that sphere's boundary
  int near_sphere = 0;  // points within a part of 1e-11 of its radius (in float 3e-6)
  double radius = 0;
  double farthest = 0;   // the largest coordinate
  double thickness = 0;  // of a box along its principal axes: the shortest edge by the longest
};

struct Family {
  std::string_view name;
  bool plane = true;  // whether it has members in 2-D; it has some in 3-D
  int rarer = 1;      // larger sets: one in so many seeds has a member
  double share = 1;   // of its members are hard, at least
  bool (*hard)(const Traits& traits, bool is_float);
};

[[nodiscard]] std::span<const Family> families();

/// family: an index of families(). In float, distances that are a part of the set's size have half the exponent: what
/// is 1e-12 in double is 1e-6.
template <class Scalar, int Dim>
[[nodiscard]] Cloud<Scalar, Dim> member(std::size_t family, std::uint64_t seed);

}  // namespace snug::test
